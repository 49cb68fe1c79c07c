//! Marks by seat and question, for the import of grades in Moodle.

use analysis::csv::Dialect;
use class::collection::{Collection, Work};
use class::grading::GivenAnswer;
use std::collections::BTreeSet;
use units::{Language, say};

/// Marks of a question that is answered fully.
const FULL: f64 = 100.0;

/// CSV with a row for each hand-in that counts: name, seat, marks of each question from 0 to 100, and their mean over all questions. The
/// cell of a question without an attempt is empty; it counts 0 in the mean. Questions of several documents are named with the title.
pub fn gradebook(class: &Collection, language: Language) -> String {
    let answers = class.works().flat_map(|(_, work)| &work.answers);
    let questions: BTreeSet<(&str, usize)> =
        answers.map(|answer| (answer.document.as_str(), answer.question)).collect();
    let is_one_document =
        questions.iter().all(|(document, _)| questions.first().is_some_and(|(first, _)| first == document));
    let mut text = String::new();
    cell(&mut text, language.say("Group"));
    cell(&mut text, language.say("Seat"));
    for (document, question) in &questions {
        let number = question + 1;
        let heading = say!(language, "Question {number}");
        cell(&mut text, &if is_one_document { heading } else { format!("{document}: {heading}") });
    }
    cell(&mut text, language.say("Total"));
    end(&mut text);
    for (index, work) in class.works() {
        let seat = class.entries().get(index).and_then(|entry| entry.hand_in()?.sender.seat);
        cell(&mut text, class.sender(index));
        cell(&mut text, &seat.map_or_else(String::new, |seat| seat.to_string()));
        let marks: Vec<Option<f64>> = questions.iter().map(|asked| marks(work, *asked)).collect();
        for mark in &marks {
            number(&mut text, *mark);
        }
        let sum: f64 = marks.iter().flatten().sum();
        number(&mut text, (!marks.is_empty()).then(|| sum / marks.len() as f64));
        end(&mut text);
    }
    text
}

/// Marks of an answer; `None` if it was not tried.
fn marks(work: &Work, (document, question): (&str, usize)) -> Option<f64> {
    let is_it = |answer: &&GivenAnswer| answer.document == document && answer.question == question;
    let answer = work.answers.iter().find(is_it)?;
    (!answer.attempts.is_empty() || answer.credit > 0.0).then_some(FULL * answer.credit)
}

/// Adds a text. One that a spreadsheet would take for a formula begins with an apostrophe.
fn cell(text: &mut String, word: &str) {
    let is_formula = word.starts_with(['=', '+', '-', '@', '\t', '\r']);
    // Writing to a string cannot fail.
    let _ = Dialect::Commas.text(text, &[if is_formula { "'" } else { "" }, word].concat());
    text.push(',');
}

/// Adds marks with at most two decimals.
fn number(text: &mut String, marks: Option<f64>) {
    if let Some(marks) = marks {
        let _ = Dialect::Commas.number(text, (marks * 100.0).round() / 100.0);
    }
    text.push(',');
}

/// Ends a row after its last comma.
fn end(text: &mut String) {
    text.pop();
    text.push('\n');
}
