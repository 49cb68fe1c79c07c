//! A choice of one or several options: `option: "The density" "It cancels."`, `option: "The length" right`.

use super::entry::Entry;
use super::raw::RawQuestion;
use crate::expressions::Expressions;
use crate::text::source::trim;
use model::{Diagnostic, Span};
use program::{ChoiceAnswer, Question, QuestionKind};
use std::ops::Range;
use units::words;

/// Mark of a right option.
const RIGHT: &str = "right";

/// Compiles the options of a choice. `choose`: byte range after `choose:`.
pub fn compile(expressions: &mut Expressions, raw: &RawQuestion, choose: Range<usize>) -> Option<QuestionKind> {
    let source = expressions.source;
    let place = trim(source, choose.clone());
    let start = if place.is_empty() { choose.start } else { place.start };
    let span = Span::new(start, place.end.max(choose.start));
    let several = match &source[place] {
        "one" => false,
        "several" => true,
        _ => {
            let message = words("a choice is of `one` option or of `several`");
            let diagnostic = Diagnostic::error("question-syntax", message, span);
            expressions.diagnostics.push(diagnostic.with_hint(words("write `choose: one` or `choose: several`")));
            return None;
        }
    };
    let written = raw.entries(source, "option");
    let mut right = Vec::new();
    for range in &written {
        right.push(option(expressions, &Entry::read(source, range.clone()))?);
    }
    let most = Question::MOST_OPTIONS;
    let wrong = match right.iter().filter(|right| **right).count() {
        _ if !(2..=most).contains(&right.len()) => words!("a choice has 2 to {most} options"),
        0 => words("no option of the choice is right"),
        2.. if !several => words("several options are right, but only one can be chosen"),
        _ => return Some(QuestionKind::Choice(ChoiceAnswer { several, right })),
    };
    let hint = if several || right.iter().all(|right| !right) {
        words("write a line for each, such as `option: \"The length\" right` and `option: \"The density\"`")
    } else {
        words("write `choose: several`, or mark one option with `right`")
    };
    expressions.diagnostics.push(Diagnostic::error("question-syntax", wrong, span).with_hint(hint));
    None
}

/// Reads an option; true if it is right.
fn option(expressions: &mut Expressions, entry: &Entry) -> Option<bool> {
    let source = expressions.source;
    let begins = entry.text(0).is_some_and(|text| text.start == entry.span.start) && entry.inside(source, 0).is_some();
    let marks: Vec<&str> = entry.others.iter().map(|other| other.text(source)).collect();
    let is_right = marks == [RIGHT];
    // The mark stands directly behind the option.
    let precedes = |text: Span| entry.others.first().is_none_or(|mark| mark.span.start < text.start);
    if begins && (is_right || marks.is_empty()) && entry.count() <= 2 && entry.text(1).is_none_or(precedes) {
        return Some(is_right);
    }
    let message = words("an option is a text in quotation marks");
    let hint = words(
        "write `option: \"The length\" right \"A remark for those who choose it\"`; `right` and the remark may be missing",
    );
    expressions.diagnostics.push(Diagnostic::error("question-syntax", message, entry.span).with_hint(hint));
    None
}
