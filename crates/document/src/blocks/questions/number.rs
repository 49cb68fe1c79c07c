//! A number with a unit and a tolerance, and expected wrong answers: `answer: 2*pi/omega_d in [s] within 2 %` and
//! `wrong: pi/omega_d "This is half a period."`.

use super::entry::Entry;
use super::raw::RawQuestion;
use crate::blocks::tolerances;
use crate::expressions::{Expressions, Placed, dimension_error};
use crate::text::grammar;
use crate::text::source::trim;
use model::{Diagnostic, Span, sentence};
use program::{NumberAnswer, Question, QuestionKind, Tolerance, WrongValue};
use std::ops::Range;
use units::words;

/// Tolerances `within 2 %` and `within 0.1 [s]`.
const TOLERANCE: tolerances::Form = tolerances::Form {
    code: "question-syntax",
    other_dimension: words("the tolerance and the answer have different dimensions"),
    hint: words("write `within 2 %` or, say, `within 0.1 [s]`"),
    bare_is_fraction: false,
};

/// Compiles the right answer and the expected wrong ones. `answer`: byte range after `answer:`.
pub fn compile(expressions: &mut Expressions, raw: &RawQuestion, answer: Range<usize>) -> Option<QuestionKind> {
    let source = expressions.source;
    let answer = sentence(source, answer, &grammar::ANSWER);
    let Some(within) = answer.phrases().next().and_then(|phrase| phrase.split_last(&["within"])) else {
        if let Some(sign) = plus_minus(source, answer.span) {
            let wrong = words("the tolerance of an answer follows the word `within`");
            let diagnostic = Diagnostic::error("question-syntax", wrong, sign);
            let hint = words("such as `within 2 %` or `within 0.1 [s]`");
            expressions.diagnostics.push(diagnostic.with_hint(hint).with_fix(sign, "within"));
            return None;
        }
        expressions.diagnostics.push(
            Diagnostic::error("question-syntax", words("how exact must the answer be?"), answer.span)
                .with_hint(words("end it with `within 2 %` or, say, `within 0.1 [s]`"))
                .with_fix(answer.span.after(), " within 2 %"),
        );
        return None;
    };
    let right = expressions.constant(within.before.span().range(), &words("an answer"))?;
    let tolerance = tolerances::read(expressions, within.after.span(), &right, &TOLERANCE)?;
    let written = raw.entries(source, "wrong");
    if written.len() > Question::MOST_WRONG {
        let most = Question::MOST_WRONG;
        let message = words!("a question has at most {most} lines `wrong:`");
        expressions.error("too-large", message, Span::new(raw.place.start, raw.place.end));
        return None;
    }
    let mut wrong = Vec::new();
    for range in written {
        wrong.push(wrong_value(expressions, &Entry::read(source, range), &right, tolerance)?);
    }
    let unit = right.value.unit.clone();
    Some(QuestionKind::Number(NumberAnswer { right: right.value, unit, tolerance, wrong }))
}

/// Reads an expected wrong answer. `tolerance`: that of the right answer, used where the line states none.
fn wrong_value(
    expressions: &mut Expressions,
    entry: &Entry,
    right: &Placed,
    tolerance: Tolerance,
) -> Option<WrongValue> {
    let source = expressions.source;
    let remark = entry.text(0).filter(|text| text.end == entry.span.end && entry.count() == 1);
    let Some(remark) = remark.filter(|_| entry.inside(source, 0).is_some() && !entry.others.is_empty()) else {
        let message = words("an expected wrong answer is a value and a text in quotation marks");
        let hint = words("write, say, `wrong: 2*T \"This is twice the period.\"`");
        expressions.diagnostics.push(Diagnostic::error("question-syntax", message, entry.span).with_hint(hint));
        return None;
    };
    let written = sentence(source, trim(source, entry.span.start..remark.start), &grammar::ANSWER);
    let within = written.phrases().next().and_then(|phrase| phrase.split_last(&["within"]));
    let place = within.as_ref().map_or(written.span, |within| within.before.span());
    let value = expressions.constant(place.range(), &words("an expected wrong answer"))?;
    let (own, expected) = (value.value.dimension(), right.value.dimension());
    if own != expected {
        let message = words("this wrong answer and the answer have different dimensions");
        let diagnostic = dimension_error(message, (value.span, own), (right.span, expected));
        let unit = &right.value.unit.text;
        expressions.diagnostics.push(match own.is_none() && !unit.is_empty() {
            true => diagnostic.with_fix(value.span.after(), format!(" [{unit}]")),
            false => diagnostic,
        });
        return None;
    }
    let tolerance = match within {
        Some(within) => tolerances::read(expressions, within.after.span(), &value, &TOLERANCE)?,
        None => tolerance,
    };
    Some(WrongValue { value: value.value, tolerance })
}

/// Place of a sign `±` before the tolerance of an answer.
fn plus_minus(source: &str, answer: Span) -> Option<Span> {
    let text = &source[answer.range()];
    ["±", "+/-", "+-"].iter().find_map(|sign| {
        let at = answer.start + text.rfind(sign)?;
        Some(Span::new(at, at + sign.len()))
    })
}
