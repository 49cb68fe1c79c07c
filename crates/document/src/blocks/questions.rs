//! Questions: text, and an answer that the document computes.

use super::tolerances;
use crate::expressions::Expressions;
use crate::prose::Prose;
use crate::text::grammar;
use crate::text::source::{lines, trim};
use model::{Diagnostic, ExpressionKind, Grammar, Span, sentence};
use program::{Question, QuestionText};
use std::ops::Range;
use units::words;

/// Maximum number of questions of a document.
pub const QUESTIONS: usize = 200;

/// Keys of a question; the text before the first key is the prompt.
const KEYS: [&str; 7] = ["after", "set", "hide", "answer", "attempts", "hint", "explanation"];

/// Tolerances `within 2 %` and `within 0.1 [s]`.
const TOLERANCE: tolerances::Form = tolerances::Form {
    code: "question-syntax",
    other_dimension: words("the tolerance and the answer have different dimensions"),
    hint: words("write `within 2 %` or, say, `within 0.1 [s]`"),
    bare_is_fraction: false,
};

/// A question as written.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct RawQuestion {
    /// Byte range without the fence.
    pub place: Range<usize>,
    prompt: Range<usize>,
    fields: Vec<(&'static str, Range<usize>)>,
}

impl RawQuestion {
    /// Byte range of the question text.
    pub fn prompt(&self) -> Range<usize> {
        self.prompt.clone()
    }

    /// Keys with the byte ranges after their colons, in text order.
    pub fn fields(&self) -> &[(&'static str, Range<usize>)] {
        &self.fields
    }

    fn field(&self, key: &str) -> Option<Range<usize>> {
        self.fields.iter().find(|(name, _)| *name == key).map(|(_, range)| range.clone())
    }
}

/// Splits the question in `range` into its parts. Each part extends to the next key.
pub fn split(source: &str, range: Range<usize>, diagnostics: &mut Vec<Diagnostic>) -> RawQuestion {
    let mut question = RawQuestion { place: trim(source, range.clone()), ..RawQuestion::default() };
    question.prompt = range.start..range.end;
    for line in lines(source, range.clone()) {
        let Some((word, _)) = line.text(source).split_once(':') else {
            continue;
        };
        let Some(key) = KEYS.iter().find(|key| **key == word) else {
            continue;
        };
        match question.fields.last_mut() {
            Some((_, last)) => last.end = line.start,
            None => question.prompt.end = line.start,
        }
        if question.field(key).is_some() {
            let span = Span::new(line.start, line.start + key.len());
            diagnostics.push(Diagnostic::error("duplicate-key", words!("the question has two `{key}:`"), span));
        }
        question.fields.push((key, line.start + key.len() + 1..range.end));
    }
    question
}

/// First key at the beginning of a line of a text.
pub fn key_in(text: &str) -> Option<&'static str> {
    text.lines().find_map(|line| {
        let (word, _) = line.split_once(':')?;
        KEYS.into_iter().find(|key| *key == word)
    })
}

/// Byte range of a part of a question, without outer blanks: the text after the key `word`, or the prompt for `None`.
pub fn part(source: &str, range: Range<usize>, word: Option<&str>) -> Option<Range<usize>> {
    let raw = split(source, range, &mut Vec::new());
    match word {
        None => Some(trim(source, raw.prompt)),
        Some(word) => raw.field(word).map(|range| trim(source, range)),
    }
}

/// Texts of a question.
pub fn texts(prose: &mut Prose, raw: &RawQuestion) -> QuestionText {
    QuestionText {
        prompt: prose.fragment(raw.prompt.clone()),
        hint: raw.field("hint").map(|range| prose.fragment(range)),
        explanation: raw.field("explanation").map(|range| prose.fragment(range)),
    }
}

/// Warns of computed parts in a translation, which may contain texts only.
pub fn check_translation(raw: &RawQuestion, diagnostics: &mut Vec<Diagnostic>) {
    for (key, range) in &raw.fields {
        if matches!(*key, "after" | "answer" | "set" | "hide" | "attempts") {
            let span = Span::new(range.start - key.len() - 1, range.end);
            diagnostics.push(
                Diagnostic::warning("translation", words!("`{key}:` in a translation means nothing"), span)
                    .with_hint(words("the original says it; a translation has the words only")),
            );
        }
    }
}

/// Fills texts missing in the questions of a translation with the originals, and warns of them at `place`.
pub fn untranslated(texts: &mut Vec<QuestionText>, originals: &[QuestionText], place: Span) -> Option<Diagnostic> {
    texts.resize_with(originals.len(), QuestionText::default);
    let mut missing = Vec::new();
    for ((number, text), original) in (1..).zip(texts).zip(originals) {
        let is_whole = *text == QuestionText::default();
        if text.prompt.is_empty() && !original.prompt.is_empty() {
            text.prompt.clone_from(&original.prompt);
            missing.push(words!("question {number}"));
        }
        let parts = [
            (&mut text.hint, &original.hint, words!("the hint of question {number}")),
            (&mut text.explanation, &original.explanation, words!("the explanation of question {number}")),
        ];
        for (part, original, name) in parts {
            if part.as_ref().is_none_or(String::is_empty) && original.is_some() {
                part.clone_from(original);
                missing.extend((!is_whole).then_some(name));
            }
        }
    }
    let message = match missing.as_slice() {
        [] => return None,
        [one] => words!("{one} has no translation"),
        several => {
            let number = several.len();
            words!("{number} texts of questions have no translation")
        }
    };
    let warning = Diagnostic::warning("untranslated", message, place)
        .with_hint(words("until they are translated, readers see the original"));
    Some(if missing.len() > 1 { missing.into_iter().fold(warning, Diagnostic::with_note) } else { warning })
}

/// Compiles the computed parts of a question. `earlier` gives the index in the document of each question before it, or
/// `None` for an invalid one.
pub fn compile(expressions: &mut Expressions, raw: &RawQuestion, earlier: &[Option<usize>]) -> Option<Question> {
    let source = expressions.source;
    let span = Span::new(raw.place.start, raw.place.end);
    let Some(answer) = raw.field("answer") else {
        expressions.diagnostics.push(
            Diagnostic::error("question-syntax", words("the question has no answer"), span)
                .with_hint(words("add a line such as `answer: 2*pi/omega_d in [s] within 2 %`")),
        );
        return None;
    };
    let setup = raw.field("set").map_or(Vec::new(), |range| expressions.assignments(range));
    let hides = raw.field("hide").map_or(Vec::new(), |range| hidden(expressions, range));
    let after = raw.field("after").map_or(Vec::new(), |range| questions_before(expressions, range, earlier));
    let attempts = raw.field("attempts").and_then(|range| attempts_allowed(expressions, range));
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
    let answer_value = expressions.constant(within.before.span().range(), &words("an answer"))?;
    let tolerance = tolerances::read(expressions, within.after.span(), &answer_value, &TOLERANCE)?;
    let answer = answer_value.value;
    Some(Question { setup, hides, after, unit: answer.unit.clone(), answer, tolerance, attempts })
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

/// Place of a sign `±` before the tolerance of an answer.
fn plus_minus(source: &str, answer: Span) -> Option<Span> {
    let text = &source[answer.range()];
    ["±", "+/-", "+-"].iter().find_map(|sign| {
        let at = answer.start + text.rfind(sign)?;
        Some(Span::new(at, at + sign.len()))
    })
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
