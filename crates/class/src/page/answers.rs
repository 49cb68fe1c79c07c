//! Answers by question, and groups that are stuck.

use super::progress::progress_text;
use crate::collection::{Collection, ErrorKind, QuestionTally};
use crate::results::Quantity;
use desk::play::Grade;
use report::{Page, escaped};
use units::Language;

/// Maximum number of examples of an error that are shown.
const MOST_EXAMPLES: usize = 6;

/// Section of the questions; empty if there are none.
pub fn questions(questions: &[QuestionTally], language: Language) -> String {
    let mut page = Page::default();
    for tally in questions {
        let number = tally.question + 1;
        page.element("h3", &language.pick(format!("Question {number}"), format!("Pregunta {number}")));
        // The text of a question is markup of the document, made safe when it was opened.
        page.wrapped("div class=\"prompt\"", &tally.prompt);
        let (first, last) = (tally.first.text(language), tally.last.text(language));
        page.element(
            "p",
            &language.pick(
                format!("Right at the first attempt: {first}. At the last: {last}."),
                format!("Bien al primer intento: {first}. Al último: {last}."),
            ),
        );
        let (revealed, without) = (tally.revealed, tally.without);
        if without > 0 {
            let text = language.pick("Groups that have not tried", "Grupos que no lo han intentado");
            page.element("p", &format!("{text}: {without}."));
        }
        if revealed > 0 {
            let text = language.pick("Groups that have looked at the answer", "Grupos que han mirado la respuesta");
            page.element("p", &format!("{text}: {revealed}."));
        }
        errors(&mut page, &tally.errors, language);
    }
    page.out
}

fn errors(page: &mut Page, errors: &[ErrorKind], language: Language) {
    if errors.is_empty() {
        return;
    }
    let headings = language.pick(["Error", "#Groups", "Examples"], ["Error", "#Grupos", "Ejemplos"]);
    page.table("wide", &headings);
    for kind in errors {
        let example = |(typed, right, count): &(String, String, usize)| {
            let times = if *count > 1 { format!(" (×{count})") } else { String::new() };
            let instead = language.pick("instead of", "en vez de");
            format!("<q>{}</q>{times} {instead} {}", escaped(typed), escaped(right))
        };
        let mut examples: Vec<String> = kind.examples.iter().take(MOST_EXAMPLES).map(example).collect();
        let more = kind.examples.len().saturating_sub(MOST_EXAMPLES);
        if more > 0 {
            examples.push(language.pick(format!("and {more} more"), format!("y {more} más")));
        }
        let groups = format!("#{}", kind.groups);
        page.row(&[error_name(kind.grade, language), &groups, &examples.join("<br>")]);
    }
    page.end_table();
}

/// Name of a kind of error.
fn error_name(grade: Grade, language: Language) -> &'static str {
    match grade {
        Grade::Correct => language.pick("right", "bien"),
        Grade::Close => language.pick("close", "cerca"),
        Grade::WrongSign => language.pick("wrong sign", "signo equivocado"),
        Grade::WrongScale => language.pick("wrong power of ten", "potencia de diez equivocada"),
        Grade::Wrong => language.pick("wrong", "mal"),
        Grade::Unreadable => language.pick("not a number, or another unit", "no es un número, u otra unidad"),
        Grade::Unanswerable => language.pick("no answer for these values", "sin respuesta para estos valores"),
    }
}

/// List of the groups that are stuck, with the reason. While hand-ins are still to be computed, it says so.
pub fn stuck(collection: &Collection, quantities: &[Quantity], language: Language) -> String {
    let mut page = Page::default();
    let stuck = collection.stuck(quantities);
    let progress = progress_text(collection, language);
    if let Some(progress) = &progress {
        page.element("p", progress);
    }
    if stuck.is_empty() && progress.is_some() {
        return page.out;
    }
    if stuck.is_empty() {
        page.element("p", language.pick("No group is stuck.", "Ningún grupo está atascado."));
        return page.out;
    }
    page.raw("<ul>\n");
    for one in stuck {
        let sender = collection.sender(one.hand_in);
        page.element("li", &format!("{sender}: {}", one.why.text(language)));
    }
    page.raw("</ul>\n");
    page.out
}
