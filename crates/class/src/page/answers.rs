//! Answers by question, and groups that are stuck.

use super::progress::progress_text;
use crate::collection::{Collection, ErrorKind, QuestionTally};
use crate::grades::grade_name;
use crate::results::Quantity;
use report::{Page, escaped};
use units::{Language, say};

/// Maximum number of examples of an error that are shown.
const MOST_EXAMPLES: usize = 6;

/// Section of the questions; empty if there are none.
pub fn questions(questions: &[QuestionTally], language: Language) -> String {
    let mut page = Page::default();
    for tally in questions {
        let number = tally.question + 1;
        page.element("h3", &say!(language, "Question {number}"));
        // The text of a question is markup of the document, made safe when it was opened.
        page.wrapped("div class=\"prompt\"", &tally.prompt);
        let (first, found) = (tally.first.text(language), tally.found.text(language));
        page.element(
            "p",
            &say!(language, "Right at the first attempt: {first}. Found before the answer was shown: {found}."),
        );
        let (revealed, without) = (tally.revealed, tally.without);
        if without > 0 {
            let text = language.say("Groups that have not tried");
            page.element("p", &format!("{text}: {without}."));
        }
        if revealed > 0 {
            let text = language.say("Groups that have looked at the answer");
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
    let headings = language.say_all(["Error", "#Groups", "Examples"]);
    page.table("wide", &headings);
    for kind in errors {
        let example = |(typed, right, count): &(String, String, usize)| {
            let times = if *count > 1 { format!(" (×{count})") } else { String::new() };
            let instead = language.say("instead of");
            if right.is_empty() {
                return format!("<q>{}</q>{times}", escaped(typed));
            }
            format!("<q>{}</q>{times} {instead} {}", escaped(typed), escaped(right))
        };
        let mut examples: Vec<String> = kind.examples.iter().take(MOST_EXAMPLES).map(example).collect();
        let more = kind.examples.len().saturating_sub(MOST_EXAMPLES);
        if more > 0 {
            examples.push(say!(language, "and {more} more"));
        }
        let groups = format!("#{}", kind.groups);
        page.row(&[grade_name(kind.grade, language), &groups, &examples.join("<br>")]);
    }
    page.end_table();
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
        page.element("p", language.say("No group is stuck."));
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
