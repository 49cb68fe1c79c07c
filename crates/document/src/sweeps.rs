//! Curves over the values of a parameter: `A against omega in 1..12 [rad/s]`,
//! `maximum(x) from 60 [s] against omega in 1..12 [rad/s] step 0.1`, and `points x from 50 against r in 2.5..4`.

use crate::curves::{self, Placed};
use crate::expressions::{Expressions, dimension_error};
use crate::scan::find_word;
use crate::source::trim;
use model::{Diagnostic, ExpressionKind, Name, Span};
use program::{Choices, NodeId, Sweep, Taken};
use std::ops::Range;
use units::{Unit, words};

/// How many values a curve of a definition has where the document does not say, and how many one of runs.
const VALUES: f64 = 500.0;
const RUNS: f64 = 60.0;

/// What is drawn over the values.
#[derive(Clone, Copy)]
pub enum Kind {
    /// One value of each run, joined by lines.
    Lines,
    /// Points of each run: at the firings of an event that this counts, or at each row.
    Points(Option<NodeId>),
}

/// What is taken of a run from a time on.
type Take = fn(f64) -> Taken;

/// The words before an expression in parentheses that take something of a run.
const TAKEN: [(&str, Take); 3] = [("maximum", Taken::Maximum), ("minimum", Taken::Minimum), ("mean", Taken::Mean)];

/// `omega in 1..12 [rad/s] step 0.1`, as read: the parameter's name, its range and the step.
pub struct Swept {
    name: Range<usize>,
    range: Range<usize>,
}

/// What stands after `against`, where it is a range of values.
pub fn find(source: &str, range: Range<usize>) -> Option<Swept> {
    let word = find_word(source, range.clone(), "in")?;
    source[word.end..range.end]
        .contains("..")
        .then(|| Swept { name: trim(source, range.start..word.start), range: trim(source, word.end..range.end) })
}

fn span(range: &Range<usize>) -> Span {
    Span::new(range.start, range.end)
}

/// Reads the curves in `parts` over a range of values. `until` is where the runs end (SI).
pub fn read(
    expressions: &mut Expressions,
    parts: Vec<Range<usize>>,
    (swept, kind): (&Swept, Kind),
    until: Option<f64>,
) -> Option<(Placed, Vec<Placed>, Sweep)> {
    let source = expressions.source;
    let (name, _, found) = model::parse_expression(source, swept.name.clone());
    let ExpressionKind::Name { name, order: 0 } = name.kind else {
        expressions.diagnostics.extend(found);
        let message = words!(
            "`{}` is not the name of a parameter",
            "`{}` no es el nombre de un parámetro",
            &source[swept.name.clone()]
        );
        expressions.error("sweep", message, span(&swept.name));
        return None;
    };
    let parameter = expressions.parameter(&Name { text: name.clone(), span: span(&swept.name) })?;
    let choices = expressions.model().parameters.get(parameter).map(|parameter| &parameter.choices);
    let is_seed = choices == Some(&Choices::Seed);
    if !is_seed && choices != Some(&Choices::Numbers) {
        let message = words!(
            "`{name}` has no range of values: it is a switch or a choice",
            "`{name}` no tiene un intervalo de valores: es un interruptor o una elección"
        );
        let diagnostic = Diagnostic::error("sweep", message, span(&swept.name));
        expressions.diagnostics.push(
            diagnostic.with_hint(words("sweep a parameter that is a number", "recorre un parámetro que sea un número")),
        );
        return None;
    }
    let abscissa = curves::read(expressions, swept.name.clone())?;
    let limits = limits(expressions, swept.range.clone(), &abscissa.curve.value.unit.clone())?;
    let (mut drawn, mut taken) = (Vec::new(), Vec::new());
    for part in parts {
        let (curve, what) = match kind {
            Kind::Lines => curve(expressions, part)?,
            Kind::Points(_) => points(expressions, part)?,
        };
        drawn.push(curve);
        taken.push(what);
    }
    let runs = taken.iter().any(|taken| *taken != Taken::Value);
    let part = (limits.high - limits.low) / if runs { RUNS } else { VALUES };
    let step = limits.step.unwrap_or(if is_seed { 1.0 } else { part });
    if is_seed && [limits.low, step].iter().any(|number| number.fract() != 0.0) {
        let message = words("a seed is a whole number", "una semilla es un número entero");
        expressions.diagnostics.push(
            Diagnostic::error("sweep", message, span(&swept.range))
                .with_hint(words("write `seed in 1..60 step 1`", "escribe `seed in 1..60 step 1`")),
        );
        return None;
    }
    let at = if let Kind::Points(at) = kind { at } else { None };
    let mut sweep = Sweep { parameter, low: limits.low, high: limits.high, step, taken, until: 0.0, at };
    if sweep.count() > Sweep::MOST {
        let message = words!(
            "a curve cannot have more than {} values",
            "una curva no puede tener más de {} valores",
            Sweep::MOST
        );
        expressions.error("too-large", message, span(&swept.range));
        return None;
    }
    if runs {
        sweep.until = end(expressions, &sweep, until, span(&swept.range))?;
    }
    Some((abscissa, drawn, sweep))
}

/// Where the runs end, which must be after all that is left out of them.
fn end(expressions: &mut Expressions, sweep: &Sweep, until: Option<f64>, span: Span) -> Option<f64> {
    let Some(until) = until else {
        expressions.diagnostics.push(
            Diagnostic::error(
                "sweep",
                words("it is not said how long these runs are", "no se dice cuánto duran estas series"),
                span,
            )
            .with_hint(words(
                "write the end of a run into the front matter, such as `until: 100 [s]`",
                "escribe el final de una serie en la cabecera, por ejemplo `until: 100 [s]`",
            )),
        );
        return None;
    };
    if sweep.taken.iter().any(|taken| taken.from() >= until) {
        expressions.error(
            "sweep",
            words(
                "the runs end before the time from which they count",
                "las series terminan antes del tiempo desde el que cuentan",
            ),
            span,
        );
        return None;
    }
    Some(until)
}

/// `maximum(x) from 60 [s] "Amplitude"`, `x at end`, or an expression that parameters alone decide.
fn curve(expressions: &mut Expressions, range: Range<usize>) -> Option<(Placed, Taken)> {
    let source = expressions.source;
    let (range, label) = curves::labelled(source, range);
    let at_end = find_word(source, range.clone(), "at").filter(|at| source[at.end..range.end].trim() == "end");
    if let Some(at) = at_end {
        let inner = trim(source, range.start..at.start);
        return Some((curves::expression(expressions, inner, range, label)?, Taken::End));
    }
    let from = find_word(source, range.clone(), "from");
    let body = trim(source, range.start..from.map_or(range.end, |from| from.start));
    let call = TAKEN.iter().find_map(|(word, taken)| {
        let inner = source[body.clone()].strip_prefix(word)?.trim_start().strip_prefix('(')?.strip_suffix(')')?;
        Some((body.end - 1 - inner.len()..body.end - 1, taken)).filter(|(inner, _)| is_closed(&source[inner.clone()]))
    });
    let Some((inner, taken)) = call else {
        let curve = curves::expression(expressions, range.clone(), range, label)?;
        return definition(expressions, curve).map(|curve| (curve, Taken::Value));
    };
    let (_, time) = body_and_start(expressions, range)?;
    Some((curves::expression(expressions, inner, body, label)?, taken(time)))
}

/// `x from 60 [s] "Position"`, of which points are drawn.
fn points(expressions: &mut Expressions, range: Range<usize>) -> Option<(Placed, Taken)> {
    let (range, label) = curves::labelled(expressions.source, range);
    let (body, from) = body_and_start(expressions, range)?;
    Some((curves::expression(expressions, body.clone(), body, label)?, Taken::Points(from)))
}

/// What stands before `from 60 [s]`, and that; 0 where it does not stand there.
fn body_and_start(expressions: &mut Expressions, range: Range<usize>) -> Option<(Range<usize>, f64)> {
    let Some(from) = find_word(expressions.source, range.clone(), "from") else { return Some((range, 0.0)) };
    let start = moment(expressions, trim(expressions.source, from.end..range.end))?;
    Some((trim(expressions.source, range.start..from.start), start))
}

/// Whether no bracket in a text closes one before it: `maximum(a) + (b)` is no call as a whole.
fn is_closed(text: &str) -> bool {
    let mut depth = 0_i32;
    text.chars().all(|letter| {
        depth += i32::from(letter == '(') - i32::from(letter == ')');
        depth >= 0
    })
}

/// A curve that parameters alone decide.
fn definition(expressions: &mut Expressions, curve: Placed) -> Option<Placed> {
    if !expressions.model().depends(curve.curve.value.node).varies() {
        return Some(curve);
    }
    let name = &curve.curve.expression;
    let diagnostic = Diagnostic::error(
        "sweep",
        words!(
            "`{name}` changes during a run: it has no value of its own for each value of a parameter",
            "`{name}` cambia durante la simulación: no tiene un valor propio para cada valor de un parámetro"
        ),
        curve.span,
    );
    expressions.diagnostics.push(diagnostic.with_hint(words!(
        "say what is taken of each run: `maximum({name})`, `minimum({name})`, `mean({name})` or `{name} at end`",
        "di qué se toma de cada serie: `maximum({name})`, `minimum({name})`, `mean({name})` o `{name} at end`"
    )));
    None
}

/// `60 [s]`, of the dimension of the independent variable; SI.
fn moment(expressions: &mut Expressions, range: Range<usize>) -> Option<f64> {
    let unit = expressions.model().independent.unit.clone();
    number(expressions, range, &unit).filter(|time| *time >= 0.0)
}

struct Limits {
    low: f64,
    high: f64,
    step: Option<f64>,
}

/// `1..12 [rad/s] step 0.1`; bare numbers are in `unit`, or in the unit that is stated. SI.
fn limits(expressions: &mut Expressions, range: Range<usize>, unit: &Unit) -> Option<Limits> {
    let source = expressions.source;
    let word = find_word(source, range.clone(), "step");
    let ends = trim(source, range.start..word.as_ref().map_or(range.end, |word| word.start));
    let text = &source[ends.clone()];
    let dots = ends.start + text.find("..")?;
    let unit = match text.find('[') {
        Some(bracket) => stated(expressions, ends.start + bracket..ends.end, unit)?,
        None => unit.clone(),
    };
    let upper = dots + 2..text.find('[').map_or(ends.end, |bracket| ends.start + bracket);
    let low = number(expressions, trim(source, ends.start..dots), &unit)?;
    let high = number(expressions, trim(source, upper), &unit)?;
    let step = match word {
        Some(word) => Some(number(expressions, trim(source, word.end..range.end), &unit)?),
        None => None,
    };
    if low >= high || step.is_some_and(|step| step <= 0.0) {
        malformed(expressions, &range);
        return None;
    }
    Some(Limits { low, high, step })
}

/// A number, bare (then in `unit`) or with a unit of the same dimension; SI.
fn number(expressions: &mut Expressions, range: Range<usize>, unit: &Unit) -> Option<f64> {
    let text = &expressions.source[range.clone()];
    let (digits, unit) = match text.find('[') {
        Some(bracket) => (&text[..bracket], stated(expressions, range.start + bracket..range.end, unit)?),
        None => (text, unit.clone()),
    };
    let value = digits.trim().parse::<f64>().ok().map(|value| unit.to_si(value)).filter(|value| value.is_finite());
    if value.is_none() {
        malformed(expressions, &range);
    }
    value
}

/// `[rad/s]`, of the dimension of `unit`.
fn stated(expressions: &mut Expressions, range: Range<usize>, unit: &Unit) -> Option<Unit> {
    let text = &expressions.source[range.clone()];
    let Some(inner) = text.strip_prefix('[').and_then(|text| text.trim_end().strip_suffix(']')) else {
        malformed(expressions, &range);
        return None;
    };
    match Unit::parse(inner) {
        Ok(found) if found.dimension == unit.dimension => Some(found),
        Ok(found) => {
            let message = words("this unit has the wrong dimension", "esta unidad tiene una dimensión incorrecta");
            let place = span(&range);
            let mut diagnostic = dimension_error(message, (place, found.dimension), (place, unit.dimension));
            // Both labels would lie on one another.
            let expected = diagnostic.labels.pop().map(|label| label.text).unwrap_or_default();
            expressions.diagnostics.push(diagnostic.with_note(words!(
                "it must be {expected}",
                "debe ser {expected}",
                expected = expected
            )));
            None
        }
        Err(error) => {
            expressions.diagnostics.push(Diagnostic::of_unit(error, range.start + 1, span(&range)));
            None
        }
    }
}

fn malformed(expressions: &mut Expressions, range: &Range<usize>) {
    expressions.diagnostics.push(
        Diagnostic::error(
            "sweep",
            words("this is no range of values", "esto no es un intervalo de valores"),
            span(range),
        )
        .with_hint(words(
            "write numbers, the smaller one first: `omega in 1..12 [rad/s] step 0.1`",
            "escribe números, primero el menor: `omega in 1..12 [rad/s] step 0.1`",
        )),
    );
}
