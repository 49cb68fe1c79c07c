//! Texts of publishing in every language.

use crate::app::App;
use view::table_of_words;

table_of_words! {
    title: "Share and publish";
    close: "Close";
    faulty: "The text has errors. They are listed in the tab Write; what is published here is ready as soon as they are corrected.";

    // Parts.
    part_hand_in: "Hand in";
    part_hand_in_note: "Answers, records and fits for your teacher.";
    part_send: "Send";
    part_send_note: "This simulation as it is now, for somebody else or for yourself.";
    part_publish: "Publish";
    part_publish_note: "For teachers and authors: a page of its own, a place in a course, paper.";

    // Link and QR code.
    link: "Link";
    link_intro: "Opens this document with the present values in this laboratory.";
    qr_code: "QR code";
    qr_save: "Save QR code";
    qr_label: "QR code of the link";
    qr_too_long: "This link is too long for a QR code that a telephone reads reliably. Save the page, put it on a web server, and make the QR code of its address here:";
    qr_local: "This laboratory is on this computer alone, where no other device can reach it. Save the page, put it on a web server, and make the QR code of its address here:";
    qr_address: "Address for the QR code";
    qr_not_made: "This address is too long for a QR code.";

    // Worksheet.
    sheet: "Worksheet";
    sheet_intro: "Printing this page gives a worksheet, also with the keys of the browser. Choose its parts.";
    sheet_parts: "Printed";
    sheet_theory: "Theory";
    sheet_values: "Table of the parameters";
    sheet_lines: "Lines for answers";
    sheet_solutions: "Solutions";
    sheet_print: "Print";

    // Link of a teacher.
    lesson: "Link for a class";
    lesson_intro: "Opens this document with the present values in this laboratory, and shows only what you choose. It is no lock: whoever changes the address sees the rest.";
    lesson_tabs: "Tabs";
    lesson_address: "Address";
    lesson_copy: "Copy this link";
    lesson_as_left: "as the reader has chosen";
    lesson_student: "of a student";
    lesson_everything: "everything";

    // Page.
    page: "Page";
    page_intro: "One file that plays this simulation in any browser, without a network. Its source is inside: the laboratory opens it again.";
    page_save: "Save as page";
    page_preparing: "The page is being prepared ...";
    page_too_large: "This document is too large for a page that plays it.";
    page_missing: "The player could not be loaded. Check the connection, and open this dialog again.";

    // Course.
    course: "Package for a course";
    course_intro: "A ZIP file for a learning platform: it keeps answers, score and state of each student, and gives assigned values by the student's id. Moodle takes SCORM 1.2.";
    course_web: "Web page (ZIP)";
    course_scores: "Scores come from the student's browser and can be forged, as in every package of this kind. A hand-in can be verified.";

    // Frame.
    frame: "Frame in another page";
    frame_intro: "Put the page on a web server, and this code into a page of Moodle, Google Sites or your own.";
    frame_address: "Address of the page";
    frame_width: "Width";
    frame_height: "Height";
    frame_follows: "The height follows the content (a script for the page around it is added)";
    frame_language: "Language";
    frame_any_language: "that of the reader";
    frame_shown: "Shown";
    frame_locked: "Fix the values (parameters, presets and handles)";
    frame_state: "With the present values";
    frame_code: "Code";
    frame_copy: "Copy code";
    frame_copied: "Copied.";
    frame_not_copied: "The browser does not allow copying. Select the text and copy it.";
    part_head: "Title and buttons";
    part_scene: "Scene";
    part_plots: "Plots";
    part_parameters: "Parameters";
    part_values: "Values";
    part_activities: "Questions";
    part_measure: "Measurements and fits";
    part_text: "Theory";

    // Files.
    files: "Files";
    source_intro: "The text of the document, with its translations beside it.";
    project_intro: "Everything in one file: document, translations, present values, records, fits, work on films and answers. Open it or drop it on this page to go on.";
    project_save: "Save project";
    source_save: "Save as file";

    // Hand-in.
    hand_in_intro: "One file for your teacher: this document with your values, records, measured points of films, fits and answers, and the results that follow from them. Send it as your course asks; this page sends nothing.";
    hand_in_left_out: "Not in it, because they are too long or cannot be restored: #.";
}

/// Texts in the language of the page. Not tracked: views with texts are rebuilt when the language changes.
pub fn of(app: App) -> &'static Words {
    words_in(app.language.get_untracked())
}
