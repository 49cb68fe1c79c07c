//! One claim: its test and its moment.

use super::identity::remark_on_identity;
use super::tolerance::tolerance;
use crate::expressions::{Expressions, Placed, dimension_error, wrong_dimension};
use crate::text::source::trim;
use model::{BinaryOperator, Diagnostic, ExpressionKind, Phrase, Sentence, Span, Split, lexemes};
use program::{Claim, Kind, Moment, Relation, Sides, Test};
use std::ops::Range;
use units::words;

/// First words of a claim about the step.
const HALVING: [&str; 4] = ["halving", "the", "step", "changes"];

/// Reads the claim of a sentence.
pub fn read(expressions: &mut Expressions, name: String, sentence: &Sentence) -> Option<Claim> {
    let source = expressions.source;
    let claim = sentence.phrases().next()?;
    let halved = after_words(source, claim.span().range(), &HALVING);
    let (what, moment) = moment(expressions, claim, halved.is_some())?;
    let test = match halved {
        Some(halved) => halved_step(expressions, what, halved)?,
        None => match what.split_last(&["within"]) {
            Some(within) => near(expressions, within)?,
            None => holds(expressions, what.span())?,
        },
    };
    let written = model::spaced(source, claim.span().range());
    Some(Claim { name, written, test, moment })
}

/// Byte after these words, if the text begins with them.
fn after_words(source: &str, range: Range<usize>, words: &[&str]) -> Option<usize> {
    let mut at = range.start;
    for word in words {
        let rest = trim(source, at..range.end);
        let after = source[rest.clone()].strip_prefix(word)?;
        if after.starts_with(|letter: char| letter.is_alphanumeric() || letter == '_') {
            return None;
        }
        at = rest.start + word.len();
    }
    Some(at)
}

/// Splits off the moment: `always`, `at end` or `at 5 [s]`. A claim about the step may omit it. Returns the phrase before
/// it, and the moment.
fn moment<'t>(expressions: &mut Expressions, claim: Phrase<'t>, is_step: bool) -> Option<(Phrase<'t>, Moment)> {
    let source = expressions.source;
    if let Some(always) = claim.split_last(&["always"]).filter(|always| always.after.is_empty()) {
        return Some((always.before, Moment::Always));
    }
    let Some(at) = claim.split_last(&["at"]) else {
        if is_step {
            return Some((claim, Moment::End));
        }
        expressions.diagnostics.push(
            Diagnostic::error("check-syntax", words("the claim does not say when it holds"), claim.span())
                .with_hint(words("end it with `always`, with `at end` or with a time such as `at 5 [s]`")),
        );
        return None;
    };
    let when = at.after.span().range();
    if &source[when.clone()] == "end" {
        return Some((at.before, Moment::End));
    }
    let time = expressions.constant(when, &words("the moment of a claim"))?;
    let independent = expressions.model().independent.unit.clone();
    if time.value.dimension() != independent.dimension {
        let message = words("this is not a moment of the run");
        let found = time.value.dimension();
        expressions.diagnostics.push(wrong_dimension(message, time.span, found, independent.dimension));
        return None;
    }
    if expressions.model().graph.as_constant(time.value.node).is_some_and(|time| !(time >= 0.0 && time.is_finite())) {
        let message = words("the run begins at 0");
        expressions.error("check-syntax", message, time.span);
        return None;
    }
    Some((at.before, Moment::At(expressions.turned(time.value, &independent))))
}

/// Reads `E within 1e-6 of E(0)`, split at `within`.
fn near(expressions: &mut Expressions, within: Split) -> Option<Test> {
    let Some(of) = within.after.split_first("of") else {
        let place = within.keyword.span.to(within.after.span());
        expressions.diagnostics.push(
            Diagnostic::error("check-syntax", words("within this of what?"), place)
                .with_hint(words("write `E within 1 % of E(0) always`")),
        );
        return None;
    };
    let value = expressions.number(within.before.span().range());
    let expected = expressions.number(of.after.span().range());
    let (value, mut expected) = (value?, expected?);
    expected.value = expressions.turned(expected.value, &value.value.unit);
    let zero = expressions.model().graph.as_constant(expected.value.node) == Some(0.0);
    let bare_zero = zero && expected.value.dimension().is_none();
    if value.value.dimension() != expected.value.dimension() && !bare_zero {
        let message = words("the value and what it should be have different dimensions");
        let found = (value.span, value.value.dimension());
        expressions.diagnostics.push(dimension_error(message, found, (expected.span, expected.value.dimension())));
        return None;
    }
    let tolerance = tolerance(expressions, of.before.span(), &value, zero)?;
    warn_if_constant(expressions, &[&value, &expected]);
    remark_on_identity(expressions, &value, &expected);
    Some(Test::Near { value: value.value, expected: expected.value, tolerance })
}

/// Reads `halving the step changes` EXPRESSION `by less than` TOLERANCE; the expression begins after byte `start`.
fn halved_step(expressions: &mut Expressions, claim: Phrase, start: usize) -> Option<Test> {
    let source = expressions.source;
    let whole = trim(source, start..claim.span().end.max(start));
    let by = claim.split_last(&["by"]);
    let limit = by.and_then(|by| Some((by, after_words(source, by.after.span().range(), &["less", "than"])?)));
    let Some((by, limit)) = limit else {
        expressions.diagnostics.push(
            Diagnostic::error(
                "check-syntax",
                words("by how much may halving the step change it?"),
                Span::new(whole.start, whole.end),
            )
            .with_hint(words("write `halving the step changes y by less than 0.1 %`")),
        );
        return None;
    };
    let value = expressions.number(whole.start..by.keyword.span.start)?;
    let limit = trim(source, limit..whole.end);
    let tolerance = tolerance(expressions, Span::new(limit.start, limit.end), &value, false)?;
    if expressions.model().depends(value.value.node).states.is_empty() {
        expressions.diagnostics.push(
            Diagnostic::warning(
                "check-constant",
                words("no step changes this: it does not depend on what the equations are solved for"),
                value.span,
            )
            .with_hint(words("name what the run computes, such as `y`")),
        );
    }
    Some(Test::HalvedStep { value: value.value, tolerance })
}

/// Reads `y < 2 [m]`.
fn holds(expressions: &mut Expressions, span: Span) -> Option<Test> {
    let source = expressions.source;
    if let Some(equals) = lexemes(source, span.range()).iter().find(|one| one.text(source) == "=") {
        expressions.diagnostics.push(
            Diagnostic::error("check-syntax", words("`=` defines, and a claim compares"), equals.span)
                .with_hint(words("write `==` for exactly equal, or `E within 1e-6 of E(0)`")),
        );
        return None;
    }
    let (expression, unit) = expressions.parse(span.range())?;
    let sides = match &expression.kind {
        ExpressionKind::Binary(operator, left, right) => {
            relation(*operator).map(|relation| (relation, left.as_ref().clone(), right.as_ref().clone()))
        }
        _ => None,
    };
    let condition = expressions.place(expression, unit.as_ref())?;
    if condition.value.kind != Kind::Truth {
        expressions.diagnostics.push(
            Diagnostic::error("check-syntax", words("a claim is true or false, and this is neither"), condition.span)
                .with_hint(words("compare it, as in `y < 2 [m] always`, or write `within 1 % of ...`")),
        );
        return None;
    }
    warn_if_constant(expressions, &[&condition]);
    let compared = sides.and_then(|(relation, left, right)| {
        let (left, right) = (expressions.place(left, None)?.value, expressions.place(right, None)?.value);
        let numbers = left.kind == Kind::Number && right.kind == Kind::Number;
        numbers.then_some(Sides { left, relation, right })
    });
    Some(Test::Holds { condition: condition.value.node, compared })
}

fn relation(operator: BinaryOperator) -> Option<Relation> {
    match operator {
        BinaryOperator::Less | BinaryOperator::LessOrEqual => Some(Relation::Below),
        BinaryOperator::Greater | BinaryOperator::GreaterOrEqual => Some(Relation::Above),
        BinaryOperator::Equal => Some(Relation::Equal),
        BinaryOperator::NotEqual => Some(Relation::Different),
        _ => None,
    }
}

/// Warns of a claim about constants, which does not depend on the run.
fn warn_if_constant(expressions: &mut Expressions, values: &[&Placed]) {
    if values.iter().any(|placed| expressions.model().depends(placed.value.node).varies()) {
        return;
    }
    let Some(span) = values.iter().map(|placed| placed.span).reduce(Span::to) else { return };
    expressions.diagnostics.push(
        Diagnostic::warning("check-constant", words("nothing in this claim changes during a run"), span)
            .with_hint(words("compare what the run computes with what it should be")),
    );
}
