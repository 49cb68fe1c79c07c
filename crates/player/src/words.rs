//! Texts of the page about its course and about handing in, in every language.

use view::{App, table_of_words};

table_of_words! {
    close: "Close";
    hand_in_intro: "One file for your teacher: this document with your values and answers, and what follows from them. Send it as your course asks; the file is only saved on this device.";
    course: "This page is part of a course";
    course_sent: "Once you start, the page sends the course: your answers with all attempts and their grades, the score, the time spent, and the values you set. You go on from there on any device.";
    course_host: "It is sent to";
    course_not_sent: "Nothing is sent before, and nothing to anyone else.";
    course_start: "Start";
    course_look: "Only look, send nothing";
    course_started: "The course keeps your work.";
    course_shown: "The course only shows this work: nothing that you do here is kept.";
    course_missing: "The course does not answer, and keeps nothing of this visit. Open the page from the course again, or go on here: your answers stay in this browser, and Hand in saves them as a file for your teacher.";
    course_unread: "The work in the course could not be read as a whole; what is missing is as in the document. If it was yours, tell your teacher, and use Hand in from now on.";
    course_refused: "The course has not accepted everything";
    course_cut: "The course takes 250 characters of an answer; the rest was not sent.";
    course_left_out: "The course has no room for everything. Not kept:";
    course_way_out: "Hand in saves everything as a file for your teacher.";
    left_attempts: "texts of earlier attempts";
    left_kept: "kept runs";
    left_changes: "changes during the run";
    left_texts: "texts of the answers";
    left_values: "values of the simulation";
}

/// Texts in the language of the page. Not tracked: views with texts are rebuilt when the language changes.
pub fn of(app: App) -> &'static Words {
    words_in(app.language.get_untracked())
}
