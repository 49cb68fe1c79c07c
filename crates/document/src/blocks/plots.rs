//! Figures: `"Phase portrait": y' against y`, `"Orbits": y_1 against x_1, y_2 against x_2, equal axes`,
//! `"Section": points theta' against theta every 2*pi/Omega`, `... at drive`,
//! `"Resonance": A against omega in 1..12 [rad/s]`, `"Bifurcations": points x from 50 against r in 2.5..4`.

use super::curves;
use super::curves::Placed;
use super::members;
use super::profiles;
use super::profiles::HISTOGRAM;
use super::sweeps;
use crate::expressions::{Expressions, dimension_error};
use crate::text::scan::{find_word, leading_text, split, statements};
use crate::text::source::trim;
use model::{Diagnostic, Span};
use program::{Curve, Drawing, Every, Node, NodeId, Plot, Profile};
use std::ops::Range;
use units::{Words, words};

/// Maximum number of figures of a document, and of curves in a figure.
const PLOTS: usize = 24;
const CURVES: usize = 12;

/// Reads the figures in `range` and appends them to `plots`. `until`: end of a run (SI), if the document states one.
pub fn read(expressions: &mut Expressions, range: Range<usize>, until: Option<f64>, plots: &mut Vec<Plot>) {
    for statement in statements(expressions.source, range) {
        if plots.len() == PLOTS {
            expressions.error("too-large", words!("a document cannot have more than {PLOTS} plots"), span(&statement));
            return;
        }
        plots.extend(plot(expressions, statement, until));
    }
}

fn span(range: &Range<usize>) -> Span {
    Span::new(range.start, range.end)
}

fn plot(expressions: &mut Expressions, statement: Range<usize>, until: Option<f64>) -> Option<Plot> {
    let source = expressions.source;
    let malformed = |message: Words, range: &Range<usize>| {
        curves::malformed(message, range).with_hint(words("a plot is `\"Title\": y, y' against t`"))
    };
    let title = leading_text(source, statement.clone());
    let Some((title, title_end)) = title.filter(|(title, _)| !title.trim().is_empty()) else {
        let untitled = malformed(words("a plot begins with its title in quotation marks"), &statement);
        let what = source[statement.clone()].replace('"', "").split_whitespace().collect::<Vec<_>>().join(" ");
        let before = Span::new(statement.start, statement.start);
        expressions.diagnostics.push(untitled.with_fix(before, format!("\"{what}\": ")));
        return None;
    };
    let rest = trim(source, title_end..statement.end);
    if !source[rest.clone()].starts_with(':') {
        expressions.diagnostics.push(malformed(words("a colon must follow the title"), &(statement.start..title_end)));
        return None;
    }
    let rest = trim(source, rest.start + 1..rest.end);
    if begins_with(HISTOGRAM, &source[rest.clone()]) {
        return profiles::histogram(expressions, title, trim(source, rest.start + HISTOGRAM.len()..rest.end));
    }
    let points = begins_with(POINTS, &source[rest.clone()]);
    let mut parts = split(source, rest.start + if points { POINTS.len() } else { 0 }..rest.end, ',');
    let equal = parts.pop_if(|part| is_equal_axes(&source[part.clone()])).is_some();
    if parts.len() > CURVES {
        expressions.error("too-large", words!("a plot cannot have more than {CURVES} curves"), span(&statement));
        return None;
    }
    let mut kind = sweeps::Kind::Lines;
    let mut at_moments = None;
    if points && members::find(source, parts.last()?.clone()).is_none() {
        let part = parts.last_mut()?;
        let against = find_word(source, part.clone(), "against");
        if let Some(against) = against.filter(|against| sweeps::find(source, against.end..part.end).is_some()) {
            kind = sweeps::Kind::Points(points_of_runs(expressions, part, against.end)?);
        } else {
            at_moments = Some(moments(expressions, part)?);
        }
    }
    let last = parts.last().map_or(rest.end, |part| part.end);
    let mut plot: Option<Plot> = None;
    let mut members = Vec::new();
    // Curves whose abscissa has not been read yet.
    let mut waiting = Vec::new();
    for part in parts {
        let against = find_word(source, part.clone(), "against");
        waiting.push(part.start..against.as_ref().map_or(part.end, |against| against.start));
        if let Some(against) = against {
            let across = against.end..part.end;
            if let Some(found) = members::find(source, across.clone()).filter(|_| at_moments.is_none()) {
                let curves = std::mem::take(&mut waiting);
                profiles::read(expressions, curves, found, title, (&mut plot, &mut members))?;
                continue;
            }
            if let Some(swept) = sweeps::find(source, across.clone()).filter(|_| at_moments.is_none() && plot.is_none())
            {
                if part.end != last {
                    expressions.diagnostics.push(malformed(
                        words("a plot over a range of values has one range, after all its curves"),
                        &statement,
                    ));
                    return None;
                }
                let (x, curves, sweep) = sweeps::read(expressions, waiting, (&swept, kind), until)?;
                let curves = curves.into_iter().map(|placed| placed.curve).collect();
                let (title, others, drawing) = (title.to_owned(), Vec::new(), Drawing::Sweep(sweep));
                return Some(Plot { title, x: x.curve, curves, others, equal, drawing });
            }
            let x = curves::read(expressions, across).and_then(|x| changing(expressions, x));
            let read = waiting.drain(..).filter_map(|part| Some(curves::read(expressions, part)?.curve));
            let curves: Vec<Curve> = read.collect();
            curves::add(expressions, &mut plot, title, curves, x?)?;
        }
    }
    if !waiting.is_empty() || plot.is_none() {
        let unclear = malformed(words("the plot does not say what it is drawn against"), &statement);
        let other = AGAINST.iter().find_map(|word| find_word(source, rest.clone(), word));
        expressions.diagnostics.push(match other {
            Some(word) => unclear.with_fix(span(&word), "against"),
            None => unclear,
        });
        return None;
    }
    let plot = plot.filter(|plot| !plot.curves.is_empty())?;
    let drawing = match at_moments {
        Some(drawing) => drawing,
        None if members.is_empty() => Drawing::Run,
        None if members.len() == plot.curves.len() => Drawing::Profile(Profile { members, points }),
        None => {
            profiles::refuse_mixture(expressions, &statement);
            return None;
        }
    };
    Some(Plot { equal, drawing, ..plot })
}

/// Words used elsewhere for `against`.
const AGAINST: [&str; 5] = ["vs", "versus", "over", "contra", "frente"];

/// Keyword for drawing single points.
pub const POINTS: &str = "points";

/// True if `text` begins with `word` as a keyword, followed by another word. Before an operator or a comma it is a name.
pub fn begins_with(word: &str, text: &str) -> bool {
    let Some(rest) = text.strip_prefix(word) else { return false };
    let next = rest.trim_start();
    rest.starts_with(char::is_whitespace)
        && next.starts_with(|letter: char| letter.is_alphanumeric() || letter == '(')
        && !next
            .split(|letter: char| !letter.is_alphanumeric())
            .next()
            .is_some_and(|word| ["against", "in"].contains(&word))
}

/// Times at which points are drawn: `every 2*pi/Omega`, or `at drive`, the firings of an event. Removed from the end of
/// `part`.
fn moments(expressions: &mut Expressions, part: &mut Range<usize>) -> Option<Drawing> {
    let source = expressions.source;
    let at = find_word(source, part.clone(), "at");
    if let Some(at) = at.filter(|_| find_word(source, part.clone(), "every").is_none()) {
        let event = trim(source, at.end..part.end);
        part.end = at.start;
        return firings(expressions, event).map(Drawing::At);
    }
    every(expressions, part).map(Drawing::Every)
}

/// Node that counts the event at which points of runs are taken: `at drive` at the end of `part`, after the parameter,
/// which begins at byte `across`. Removed from `part`. `Some(None)` for a discrete independent variable: one point at each
/// count.
fn points_of_runs(expressions: &mut Expressions, part: &mut Range<usize>, across: usize) -> Option<Option<NodeId>> {
    let source = expressions.source;
    if let Some(at) = find_word(source, part.clone(), "at").filter(|at| at.start > across) {
        let event = trim(source, at.end..part.end);
        part.end = at.start;
        return firings(expressions, event).map(Some);
    }
    if expressions.model().independent.counts {
        return Some(None);
    }
    expressions.diagnostics.push(
        Diagnostic::error(
            "plot-syntax",
            words("it is not said at which moments of each run a point is drawn"),
            span(&trim(source, part.clone())),
        )
        .with_hint(words(
            "name an event and draw at its firings: `every 2*pi/Omega as drive { }` in the model, and `at drive` here",
        )),
    );
    None
}

/// Node that counts the firings of the event named in `range`.
fn firings(expressions: &mut Expressions, range: Range<usize>) -> Option<NodeId> {
    let name = &expressions.source[range.clone()];
    let count = expressions.model().lookup(&format!("{name}.count"), 0).filter(|_| !name.contains('.'));
    if count.is_none() {
        let message = words!("there is no event `{name}`");
        let hint = match name.split_once('.') {
            Some((event, _)) => words!("write its name alone: `at {event}`"),
            None => words!("name it: when ... as {name} {{ ... }}"),
        };
        expressions.diagnostics.push(Diagnostic::error("unknown-name", message, span(&range)).with_hint(hint));
    }
    count.map(|count| count.node)
}

/// `every 2*pi/Omega from 10 [s]` at the end of `part`, from which it is removed.
fn every(expressions: &mut Expressions, part: &mut Range<usize>) -> Option<Every> {
    let source = expressions.source;
    let Some(word) = find_word(source, part.clone(), "every") else {
        if expressions.model().independent.counts {
            return Some(Every { period: expressions.graph().constant(1.0), from: None });
        }
        expressions.diagnostics.push(
            Diagnostic::error(
                "plot-syntax",
                words("it is not said when a point is drawn"),
                span(&trim(source, part.clone())),
            )
            .with_hint(words("write `points y against x every 2 [s]`: a point at each multiple of that")),
        );
        return None;
    };
    let from = find_word(source, word.end..part.end, "from");
    let period = word.end..from.as_ref().map_or(part.end, |from| from.start);
    let first = from.map(|from| trim(source, from.end..part.end));
    part.end = word.start;
    let period = moment(expressions, period, &words("the period"))?;
    let from = match first {
        Some(range) => {
            let place = span(&range);
            let first = moment(expressions, range, &words("the first moment"))?;
            let Node::Constant(bits) = expressions.model().graph.node(first) else {
                expressions.error("plot-syntax", words("the first moment must be a number"), place);
                return None;
            };
            let from = f64::from_bits(bits);
            if !(from.is_finite() && from >= 0.0) {
                expressions.error(
                    "plot-syntax",
                    words("the first moment must not lie before 0, where the run begins"),
                    place,
                );
                return None;
            }
            Some(from)
        }
        None => None,
    };
    Some(Every { period, from })
}

/// Compiles a value of the independent variable that is constant during a run.
fn moment(expressions: &mut Expressions, range: Range<usize>, what: &Words) -> Option<program::NodeId> {
    let placed = expressions.constant(range, what)?;
    let (found, expected) = (placed.value.dimension(), expressions.model().independent.unit.dimension);
    if found != expected {
        let message = words!("{what} has the wrong dimension");
        let mut diagnostic = dimension_error(message, (placed.span, found), (placed.span, expected));
        // Both labels would be at the same place.
        let expected = diagnostic.labels.pop().map(|label| label.text).unwrap_or_default();
        expressions.diagnostics.push(diagnostic.with_note(words!("it must be {expected}")));
        return None;
    }
    Some(placed.value.node)
}

/// True for a part after a comma that asks for equal scales on both axes.
pub fn is_equal_axes(part: &str) -> bool {
    part.split_whitespace().eq(["equal", "axes"])
}

/// Requires an abscissa that varies during a run; otherwise the curve would be a point.
fn changing(expressions: &mut Expressions, x: Placed) -> Option<Placed> {
    let dependence = expressions.model().depends(x.curve.value.node);
    if dependence.varies() {
        return Some(x);
    }
    let name = &x.curve.expression;
    let diagnostic = Diagnostic::error(
        "constant-abscissa",
        words!("`{name}` stays the same during a run, so nothing can be drawn against it"),
        x.span,
    );
    let model = expressions.model();
    let parameter = model.parameters.iter().find(|parameter| parameter.name == *name);
    let hint = match parameter {
        Some(parameter) => {
            let unit = &parameter.unit;
            let (low, high) =
                parameter.range.map_or((1.0, 10.0), |(low, high)| (unit.from_si(low), unit.from_si(high)));
            let stated = if unit.text.is_empty() { String::new() } else { format!(" [{unit}]") };
            words!("for a curve over its values write them: `against {name} in {low}..{high}{stated}`")
        }
        None => {
            let time = &model.independent.name;
            words!(
                "draw against `{time}`, against something that changes with it, or over the values of a parameter: `in LOW..HIGH`"
            )
        }
    };
    expressions.diagnostics.push(diagnostic.with_hint(hint));
    None
}
