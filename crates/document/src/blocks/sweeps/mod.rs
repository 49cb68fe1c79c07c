//! Curves over the values of a parameter: `A against omega in 1..12 [rad/s]`,
//! `maximum(x) from 60 [s] against omega in 1..12 [rad/s] step 0.1`, and `points x from 50 against r in 2.5..4`.

mod drawn;
mod range;

use super::curves;
use super::curves::Placed;
use crate::expressions::Expressions;
use model::{Diagnostic, ExpressionKind, Name, Phrase, Span};
use program::{Choices, NodeId, Outcomes, Sweep, Taken};
pub use range::Limits;
use range::limits;
use units::words;

/// Default numbers of values: of a curve of definitions, and of a curve of runs.
const VALUES: f64 = 500.0;
const RUNS: f64 = 60.0;

/// Kind of drawing over the values.
#[derive(Clone, Copy)]
pub enum Kind {
    /// One value of each run, joined by lines.
    Lines,
    /// Points of each run: at the firings of the event counted by this node, or at each row for `None`.
    Points(Option<NodeId>),
}

/// `omega in 1..12 [rad/s] step 0.1`: name of the parameter, and its range with the step.
#[derive(Clone, Copy)]
pub struct Swept<'t> {
    name: Phrase<'t>,
    range: Phrase<'t>,
}

/// The text after `against`, if it is a range of values.
pub fn find(phrase: Phrase) -> Option<Swept> {
    let range = phrase.split_last(&["in"])?;
    range.after.operand.dots.map(|_| Swept { name: range.before, range: range.after })
}

/// Reads the curves in `parts` over a range of values. `until`: end of the runs (SI).
pub fn read(
    expressions: &mut Expressions,
    parts: Vec<Phrase>,
    (swept, kind): (Swept, Kind),
    until: Option<f64>,
) -> Option<(Placed, Vec<Placed>, Sweep)> {
    let Values { parameter, is_seed, abscissa, limits } = values(expressions, swept)?;
    let (mut drawn, mut taken, mut aggregates) = (Vec::new(), Vec::new(), Vec::new());
    let mut first = 0.0_f64;
    for part in parts {
        let read = match kind {
            Kind::Lines => drawn::line(expressions, part, &mut aggregates)?,
            Kind::Points(_) => drawn::points(expressions, part)?,
        };
        first = first.max(read.from);
        drawn.push(read.curve);
        taken.push(read.taken);
    }
    let runs = taken.iter().any(|taken| *taken != Taken::Value);
    let part = (limits.high - limits.low) / if runs { RUNS } else { VALUES };
    let step = limits.step.unwrap_or(if is_seed { 1.0 } else { part });
    if is_seed && [limits.low, step].iter().any(|number| number.fract() != 0.0) {
        let message = words("a seed is a whole number");
        expressions.diagnostics.push(
            Diagnostic::error("sweep", message, swept.range.span()).with_hint(words("write `seed in 1..60 step 1`")),
        );
        return None;
    }
    let at = if let Kind::Points(at) = kind { at } else { None };
    let mut sweep = Sweep { parameter, low: limits.low, high: limits.high, step, taken, aggregates, until: 0.0, at };
    if sweep.count() > Sweep::MOST {
        let message = words!("a curve cannot have more than {} values", Sweep::MOST);
        expressions.error("too-large", message, swept.range.span());
        return None;
    }
    if runs {
        sweep.until = end(expressions, first, until, swept.range.span())?;
    }
    Some((abscissa, drawn, sweep))
}

/// A parameter and the range of its values.
struct Values {
    parameter: usize,
    /// Its values are whole numbers.
    is_seed: bool,
    /// The parameter as horizontal axis.
    abscissa: Placed,
    limits: Limits,
}

/// Reads a parameter and the range of its values.
fn values(expressions: &mut Expressions, swept: Swept) -> Option<Values> {
    let source = expressions.source;
    let name_span = swept.name.span();
    let (name, _, found) = model::parse_expression(source, name_span.range());
    let ExpressionKind::Name { name, order: 0 } = name.kind else {
        expressions.diagnostics.extend(found);
        let message = words!("`{}` is not the name of a parameter", &source[name_span.range()]);
        expressions.error("sweep", message, name_span);
        return None;
    };
    let parameter = expressions.parameter(&Name { text: name.clone(), span: name_span })?;
    let choices = expressions.model().parameters.get(parameter).map(|parameter| &parameter.choices);
    let is_seed = choices == Some(&Choices::Seed);
    if !is_seed && choices != Some(&Choices::Numbers) {
        let message = words!("`{name}` has no range of values: it is a switch or a choice");
        let diagnostic = Diagnostic::error("sweep", message, name_span);
        expressions.diagnostics.push(diagnostic.with_hint(words("sweep a parameter that is a number")));
        return None;
    }
    let abscissa = curves::read(expressions, swept.name)?;
    let limits = limits(expressions, swept.range, &abscissa.curve.value.unit.clone())?;
    Some(Values { parameter, is_seed, abscissa, limits })
}

/// Reads `omega in 1..12 [rad/s] step 0.1`: index of the parameter, and its range.
pub fn parameter_range(expressions: &mut Expressions, swept: Swept) -> Option<(usize, Limits)> {
    values(expressions, swept).map(|Values { parameter, limits, .. }| (parameter, limits))
}

/// Reads numbers that are taken of each of many runs.
pub fn outcomes<'t>(expressions: &mut Expressions, parts: impl Iterator<Item = Phrase<'t>>) -> Option<Outcomes> {
    let mut outcomes = Outcomes::default();
    for part in parts {
        let drawn = drawn::line(expressions, part, &mut outcomes.aggregates)?;
        outcomes.nodes.push(match drawn.taken {
            Taken::Run(node) => node,
            Taken::Value | Taken::Points(_) => drawn.curve.curve.value.node,
        });
        outcomes.curves.push(drawn.curve.curve);
    }
    Some(outcomes)
}

/// End of the runs, which must be later than `first`, the latest time from which a curve is evaluated (SI).
fn end(expressions: &mut Expressions, first: f64, until: Option<f64>, span: Span) -> Option<f64> {
    let Some(until) = until else {
        expressions.diagnostics.push(
            Diagnostic::error("sweep", words("it is not said how long these runs are"), span)
                .with_hint(words("write the end of a run into the front matter, such as `until: 100 [s]`")),
        );
        return None;
    };
    if first >= until {
        expressions.error("sweep", words("the runs end before the time from which they count"), span);
        return None;
    }
    Some(until)
}
