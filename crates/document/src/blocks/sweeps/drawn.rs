//! Curves over a parameter: `A`, `maximum(x) - minimum(x) from 60 [s] in [cm] "Range"`, `x at end`.

use super::range;
use crate::blocks::curves;
use crate::blocks::curves::Placed;
use crate::expressions::Expressions;
use model::{Diagnostic, Expression, ExpressionKind, Phrase, Span, StatedUnit};
use program::{Aggregate, AggregateKind, Taken};
use units::{Unit, words};

/// A curve, and the kind of its values.
pub(super) struct Drawn {
    pub curve: Placed,
    pub taken: Taken,
    /// Time from which runs are evaluated (SI).
    pub from: f64,
}

/// A curve split into its expression and the optional parts after it, which may come in any order.
struct Written {
    body: Span,
    label: Option<String>,
    /// `in [cm]`, if another part stands before it. A unit directly after the expression is parsed with it.
    unit: Option<StatedUnit>,
    /// The time (SI), and its place including the word `from`.
    from: Option<(f64, Span)>,
    /// Place of `at end`.
    at_end: Option<Span>,
}

/// Reads an expression of parameters, of aggregates of a run, or of values at its end.
pub(super) fn line(expressions: &mut Expressions, phrase: Phrase, aggregates: &mut Vec<Aggregate>) -> Option<Drawn> {
    let written = written(expressions, phrase)?;
    let (value, unit) = read(expressions, &written)?;
    let from = written.from.map_or(0.0, |(from, _)| from);
    let known = aggregates.len();
    // A curve of one aggregate gets the label of the aggregated quantity.
    let named = match &value.kind {
        ExpressionKind::Call { function, arguments } => (arguments.first())
            .filter(|_| AggregateKind::named(&function.text).is_some())
            .map_or(written.body, |argument| argument.span),
        _ => written.body,
    };
    let of_run = of_run(expressions, value, unit.as_ref(), (from, aggregates))?;
    let node = of_run.value.node;
    let (dependence, own) = (expressions.model().depends(node), expressions.model().parameters.len());
    let varies = dependence.varies();
    let takes = aggregates.len() > known || dependence.parameters.iter().any(|number| *number as usize >= own);
    if let (Some((_, place)), false) = (written.from, takes) {
        nothing_taken(expressions, place, &written);
        return None;
    }
    let mut curve = curves::placed(expressions, of_run, written.body, named, written.label);
    if written.at_end.is_none() && varies {
        refuse_varying(expressions, &curve, takes);
        return None;
    }
    if written.at_end.is_none() && !takes {
        return Some(Drawn { curve, taken: Taken::Value, from });
    }
    if written.at_end.is_some() {
        curve.curve.expression.push_str(" at end");
    }
    curve.curve.value.node = expressions.graph().constant(f64::NAN);
    Some(Drawn { curve, taken: Taken::Run(node), from })
}

/// Reads `x from 60 [s] "Position"`, drawn as points.
pub(super) fn points(expressions: &mut Expressions, phrase: Phrase) -> Option<Drawn> {
    let written = written(expressions, phrase)?;
    if let Some(place) = written.at_end {
        let message = words("points are drawn of the whole run");
        expressions.diagnostics.push(
            Diagnostic::error("sweep", message, place)
                .with_hint(words("leave out `at end`, or leave out `points` for one value of each run")),
        );
        return None;
    }
    let (value, unit) = read(expressions, &written)?;
    let value = expressions.place(value, unit.as_ref())?;
    let value = expressions.expect_number(value)?;
    let from = written.from.map_or(0.0, |(from, _)| from);
    let curve = curves::placed(expressions, value, written.body, written.body, written.label);
    Some(Drawn { curve, taken: Taken::Points(from), from })
}

/// Splits label, unit, time and `at end` off the end of a curve.
fn written(expressions: &mut Expressions, phrase: Phrase) -> Option<Written> {
    let source = expressions.source;
    let (body, label) = (phrase.unlabelled(), curves::label(source, phrase));
    let mut written = Written { body, label, unit: None, from: None, at_end: None };
    let mut phrase = phrase;
    while let Some(last) = phrase.split_last(&["in", "from", "at"]) {
        let place = last.keyword.span.to(written.body.after());
        let rest = Span::new(last.after.span().start.min(place.end), place.end);
        match last.keyword.word {
            "from" if written.from.is_none() => written.from = Some((range::moment(expressions, rest)?, place)),
            "at" if written.at_end.is_none() && &source[rest.range()] == "end" => written.at_end = Some(place),
            // A unit directly after the expression is parsed with it.
            "in" if written.unit.is_none() && last.before.split_last(&["from", "at"]).is_some() => {
                written.unit = Some(stated(expressions, rest)?);
            }
            _ => break,
        }
        phrase = last.before;
        written.body = phrase.span();
    }
    Some(written)
}

/// Parses the expression and its unit.
fn read(expressions: &mut Expressions, written: &Written) -> Option<(Expression, Option<StatedUnit>)> {
    let (value, unit) = expressions.parse(written.body.range())?;
    if let (Some(first), Some(second)) = (&unit, &written.unit) {
        let message = words("the unit is stated twice");
        expressions.diagnostics.push(
            Diagnostic::error("sweep", message, second.span)
                .with_label(first.span, words("it is stated here"))
                .with_hint(words("leave one of them out")),
        );
        return None;
    }
    Some((value, unit.or(written.unit.clone())))
}

/// Parses `[cm]`.
fn stated(expressions: &mut Expressions, span: Span) -> Option<StatedUnit> {
    let text = &expressions.source[span.range()];
    let Some(inner) = text.strip_prefix('[').and_then(|text| text.strip_suffix(']')) else {
        let message = words("a unit in brackets must follow `in`");
        expressions
            .diagnostics
            .push(Diagnostic::error("sweep", message, span).with_hint(words("write it as in `in [cm]`")));
        return None;
    };
    match Unit::parse(inner) {
        Ok(unit) => Some(StatedUnit { unit, span }),
        Err(error) => {
            expressions.diagnostics.push(Diagnostic::of_unit(error, span.start + 1, span));
            None
        }
    }
}

/// Compiles an expression with aggregates of a run from a time on (SI), which are appended to the aggregates.
fn of_run(
    expressions: &mut Expressions,
    value: Expression,
    unit: Option<&StatedUnit>,
    (from, aggregates): (f64, &mut Vec<Aggregate>),
) -> Option<crate::expressions::Placed> {
    let value = expressions.completed(value)?;
    match expressions.compiler.compile_of_run(&value, unit, from, aggregates) {
        Ok(compiled) => expressions.expect_number(crate::expressions::Placed { value: compiled, span: value.span }),
        Err(found) => {
            expressions.diagnostics.extend(found);
            None
        }
    }
}

/// Reports a `from` time of a curve to which it does not apply.
fn nothing_taken(expressions: &mut Expressions, place: Span, written: &Written) {
    let source = expressions.source;
    let body = &source[written.body.range()];
    let message = words!(
        "`{}` says from when on a run counts, but of these runs only single values are drawn",
        &source[place.range()]
    );
    expressions.diagnostics.push(Diagnostic::error("sweep", message, place).with_hint(words!(
        "say what is taken of each run, as in `maximum({body})` or `mean({body})`, or leave the time out"
    )));
}

/// Reports a curve that does not have one value for each value of the parameter.
fn refuse_varying(expressions: &mut Expressions, curve: &Placed, takes: bool) {
    let name = &curve.curve.expression;
    let dependence = expressions.model().depends(curve.curve.value.node);
    let states = &expressions.model().states;
    let culprit = dependence.states.first().and_then(|number| states.get(*number as usize));
    let culprit = culprit.map_or_else(|| expressions.model().independent.name.clone(), program::State::name);
    let diagnostic = if takes {
        let message = words!("what `{name}` does not take of the whole run changes during the run");
        Diagnostic::error("sweep", message, curve.span)
            .saying(words!("depends on {}", format!("`{culprit}`")))
            .with_hint(words!(
                "for the value at the end of each run write `{name} at end`; else put `maximum`, `minimum`, `mean` or `integral` around what changes"
            ))
    } else {
        let message = words!("`{name}` changes during a run: it has no value of its own for each value of a parameter");
        Diagnostic::error("sweep", message, curve.span).with_hint(words!(
            "say what is taken of each run: `maximum({name})`, `minimum({name})`, `mean({name})` or `{name} at end`"
        ))
    };
    expressions.diagnostics.push(diagnostic);
}
