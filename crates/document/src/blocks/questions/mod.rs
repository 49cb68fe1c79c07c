//! Questions: text, and an answer that the document grades.

mod choice;
mod entry;
mod number;
mod raw;
mod texts;

pub use raw::{Holds, RawQuestion, key_in, part, split};
pub use texts::{check_translation, texts, untranslated};

use crate::expressions::Expressions;
use crate::text::source::trim;
use model::{Diagnostic, ExpressionKind, Grammar, Span, sentence};
use program::{Question, QuestionKind};
use std::ops::Range;
use units::words;

/// Maximum number of questions of a document.
pub const QUESTIONS: usize = 200;

/// A kind of question.
struct Kind {
    /// Key that every question of this kind has.
    key: &'static str,
    /// Compiles what belongs to the kind. The range is the text after the key.
    compile: fn(&mut Expressions, &RawQuestion, Range<usize>) -> Option<QuestionKind>,
}

/// Kinds of questions.
const KINDS: [Kind; 2] =
    [Kind { key: "answer", compile: number::compile }, Kind { key: "choose", compile: choice::compile }];

/// Compiles the computed parts of a question. `earlier` gives the index in the document of each question before it, or
/// `None` for an invalid one.
pub fn compile(expressions: &mut Expressions, raw: &RawQuestion, earlier: &[Option<usize>]) -> Option<Question> {
    let kind = kind(expressions, raw);
    let setup = raw.field("set").map_or(Vec::new(), |range| expressions.assignments(range));
    let hides = raw.field("hide").map_or(Vec::new(), |range| hidden(expressions, range));
    let after = raw.field("after").map_or(Vec::new(), |range| questions_before(expressions, range, earlier));
    let attempts = raw.field("attempts").and_then(|range| attempts_allowed(expressions, range));
    let (kind, range) = kind?;
    let kind = (kind.compile)(expressions, raw, range)?;
    Some(Question { setup, hides, after, attempts, kind })
}

/// Kind of a question by its key, with the text after that key.
fn kind(expressions: &mut Expressions, raw: &RawQuestion) -> Option<(&'static Kind, Range<usize>)> {
    let mut found = KINDS.iter().filter_map(|kind| Some((kind, raw.field(kind.key)?)));
    let first = found.next();
    let span_of = |word: &str, range: &Range<usize>| Span::new(range.start - word.len() - 1, range.start);
    if let (Some((first, _)), Some((second, range))) = (&first, found.next()) {
        let (one, other) = (first.key, second.key);
        let message = words!("a question has `{one}:` or `{other}:`, not both");
        expressions.error("question-syntax", message, span_of(other, &range));
        return None;
    }
    let foreign = raw
        .fields()
        .iter()
        .find(|(key, _)| key.kind.is_some_and(|kind| first.as_ref().is_none_or(|(first, _)| kind != first.key)));
    if let Some((key, range)) = foreign {
        let (word, kind) = (key.word, key.kind.unwrap_or_default());
        let message = words!("`{word}:` needs a line `{kind}:`");
        let diagnostic = Diagnostic::error("question-syntax", message, span_of(word, range));
        expressions.diagnostics.push(match word {
            "option" if first.is_none() => {
                diagnostic.with_hint(words("write `choose: one` or `choose: several` before it"))
            }
            _ => diagnostic.with_hint(words("remarks on wrong numbers belong to `answer:`, options to `choose:`")),
        });
        return None;
    }
    if first.is_none() {
        let span = Span::new(raw.place.start, raw.place.end);
        expressions.diagnostics.push(
            Diagnostic::error("question-syntax", words("the question has no answer"), span)
                .with_hint(words("add a line such as `answer: 2*pi/omega_d in [s] within 2 %`"))
                .with_hint(words("or a line `choose: one` and options such as `option: \"The length\" right`")),
        );
    }
    first
}

/// Number of attempts that a question allows: `3`.
fn attempts_allowed(expressions: &mut Expressions, range: Range<usize>) -> Option<u32> {
    let place = trim(expressions.source, range.clone());
    let number = expressions.source[place.clone()].parse().ok();
    let number = number.filter(|number| (1..=Question::MOST_ATTEMPTS).contains(number));
    if number.is_none() {
        let most = Question::MOST_ATTEMPTS;
        let span = Span::new(if place.is_empty() { range.start } else { place.start }, place.end.max(range.start));
        let message = words!("the number of attempts is a whole number from 1 to {most}");
        let diagnostic = Diagnostic::error("question-syntax", message, span);
        let hint = words("write, say, `attempts: 3`; without the line there is no limit");
        expressions.diagnostics.push(diagnostic.with_hint(hint));
    }
    number
}

/// Indices of the questions that must be answered first: `previous`, or numbers counted from 1.
fn questions_before(expressions: &mut Expressions, range: Range<usize>, earlier: &[Option<usize>]) -> Vec<usize> {
    let source = expressions.source;
    let mut questions = Vec::new();
    for phrase in sentence(source, range, &Grammar::LIST).phrases() {
        let span = phrase.span();
        let text = &source[span.range()];
        let number = if text == "previous" { Some(earlier.len()) } else { text.parse().ok() };
        match number.and_then(|number: usize| earlier.get(number.checked_sub(1)?)) {
            // A question with errors is not shown, so nothing can depend on it.
            Some(question) => questions.extend(question.filter(|question| !questions.contains(question))),
            None => {
                let message = words!("there is no question `{text}` before this one");
                let diagnostic = Diagnostic::error("question-syntax", message, span);
                expressions.diagnostics.push(match earlier.len() {
                    0 => diagnostic.with_hint(words("this is the first question: leave the line out")),
                    _ => diagnostic
                        .with_hint(words(
                            "write `previous`, or numbers of questions before this one, such as `after: 1, 2`",
                        ))
                        .with_fix(span, "previous"),
                });
            }
        }
    }
    questions
}

/// Indices of the quantities whose values are hidden until the question is answered: `T_d, omega_d`.
fn hidden(expressions: &mut Expressions, range: Range<usize>) -> Vec<usize> {
    let source = expressions.source;
    let mut quantities = Vec::new();
    for phrase in sentence(source, range, &Grammar::LIST).phrases() {
        let span = phrase.span();
        // Parsed as in the model, so that `ω₀` and `omega_0` are the same name.
        let (expression, unit, found) = model::parse_expression(source, span.range());
        let ExpressionKind::Name { name, order: 0 } = expression.kind else {
            let message = words("`hide:` names quantities, with a comma between them");
            expressions.error("question-syntax", message, span);
            continue;
        };
        let named = &expressions.model().quantities;
        let Some(quantity) = named.iter().position(|quantity| quantity.name == name) else {
            let near = units::nearest(&name, named.iter().map(|quantity| quantity.name.as_str())).map(str::to_owned);
            let message = words!("`{name}` is not a quantity of the model");
            let diagnostic = Diagnostic::error("unknown-name", message, span);
            expressions.diagnostics.push(match near {
                Some(near) => diagnostic.meaning(&near),
                None => diagnostic.with_hint(words("only quantities, `name = expression`, can be hidden")),
            });
            continue;
        };
        if unit.is_some() || !found.is_empty() {
            let message = words("only names stand in `hide:`");
            expressions.error("question-syntax", message, span);
        } else if !quantities.contains(&quantity) {
            quantities.push(quantity);
        }
    }
    quantities
}
