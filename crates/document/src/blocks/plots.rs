//! Figures: `"Phase portrait": y' against y`, `"Orbits": y_1 against x_1, y_2 against x_2, equal axes`,
//! `"Section": points theta' against theta every 2*pi/Omega`, `... at drive`,
//! `"Resonance": A against omega in 1..12 [rad/s]`, `"Bifurcations": points x from 50 against r in 2.5..4`.

use super::curves;
use super::curves::Placed;
use super::members;
use super::profiles;
use super::sweeps;
use crate::expressions::{Expressions, wrong_dimension};
use crate::text::grammar::{AGAINST, HISTOGRAM, POINTS};
use model::{Diagnostic, Phrase, Sentence, Span};
use program::{Curve, Drawing, Every, Node, NodeId, Plot, Profile};
use units::{Words, words};

/// Maximum number of figures of a document, and of curves in a figure.
const PLOTS: usize = 24;
const CURVES: usize = 12;

/// Reads figures and appends them to `plots`. `until`: end of a run (SI), if the document states one.
pub fn read(expressions: &mut Expressions, sentences: &[Sentence], until: Option<f64>, plots: &mut Vec<Plot>) {
    for sentence in sentences {
        if plots.len() == PLOTS {
            expressions.error("too-large", words!("a document cannot have more than {PLOTS} plots"), sentence.span);
            return;
        }
        plots.extend(plot(expressions, sentence, until));
    }
}

fn plot(expressions: &mut Expressions, sentence: &Sentence, until: Option<f64>) -> Option<Plot> {
    let mut plot = in_own_units(expressions, sentence, until)?;
    curves::turn(expressions, &mut plot);
    Some(plot)
}

/// Reads a plot in which each curve keeps its unit.
fn in_own_units(expressions: &mut Expressions, sentence: &Sentence, until: Option<f64>) -> Option<Plot> {
    let source = expressions.source;
    let malformed = |message: Words, span: Span| {
        curves::malformed(message, span).with_hint(words("a plot is `\"Title\": y, y' against t`"))
    };
    let Some(title) = sentence.title_text(source) else {
        let untitled = malformed(words("a plot begins with its title in quotation marks"), sentence.span);
        let what = source[sentence.span.range()].replace('"', "").split_whitespace().collect::<Vec<_>>().join(" ");
        let before = Span::new(sentence.span.start, sentence.span.start);
        expressions.diagnostics.push(untitled.with_fix(before, format!("\"{what}\": ")));
        return None;
    };
    if sentence.colon.is_none() {
        let place = sentence.title.unwrap_or(sentence.span);
        expressions.diagnostics.push(malformed(words("a colon must follow the title"), place));
        return None;
    }
    let kind = sentence.kind.map(|kind| kind.word);
    if kind == Some(HISTOGRAM) {
        return profiles::histogram(expressions, title, sentence);
    }
    let points = kind == Some(POINTS);
    let mut parts: Vec<Phrase> = sentence.phrases().collect();
    if parts.len() > CURVES {
        expressions.error("too-large", words!("a plot cannot have more than {CURVES} curves"), sentence.span);
        return None;
    }
    let mut kind = sweeps::Kind::Lines;
    let mut at_moments = None;
    if points && members::find(*parts.last()?).is_none() {
        let part = parts.last_mut()?;
        let over = part.split_last(&["against"]).filter(|against| sweeps::find(against.after).is_some());
        if let Some(against) = over {
            kind = sweeps::Kind::Points(points_of_runs(expressions, part, against.keyword.span)?);
        } else {
            at_moments = Some(moments(expressions, part)?);
        }
    }
    let mut plot: Option<Plot> = None;
    let mut members = Vec::new();
    // Curves whose abscissa has not been read yet.
    let mut waiting = Vec::new();
    let last = parts.len().saturating_sub(1);
    for (number, part) in parts.into_iter().enumerate() {
        let Some(against) = part.split_last(&["against"]).filter(|against| !against.before.is_empty()) else {
            waiting.push(part);
            continue;
        };
        waiting.push(against.before);
        let across = against.after;
        if let Some(found) = members::find(across).filter(|_| at_moments.is_none()) {
            let curves = std::mem::take(&mut waiting);
            profiles::read(expressions, curves, found, title, (&mut plot, &mut members))?;
            continue;
        }
        if let Some(swept) = sweeps::find(across).filter(|_| at_moments.is_none() && plot.is_none()) {
            if number != last {
                expressions.diagnostics.push(malformed(
                    words("a plot over a range of values has one range, after all its curves"),
                    sentence.span,
                ));
                return None;
            }
            let (x, curves, sweep) = sweeps::read(expressions, waiting, (swept, kind), until)?;
            let curves = curves.into_iter().map(|placed| placed.curve).collect();
            let (title, others, drawing) = (title.to_owned(), Vec::new(), Drawing::Sweep(sweep));
            return Some(Plot { title, x: x.curve, curves, others, equal: sentence.ending.is_some(), drawing });
        }
        let x = curves::read(expressions, across).and_then(|x| changing(expressions, x));
        let read = waiting.drain(..).filter_map(|part| Some(curves::read(expressions, part)?.curve));
        let curves: Vec<Curve> = read.collect();
        curves::add(expressions, &mut plot, title, curves, x?)?;
    }
    if !waiting.is_empty() || plot.is_none() {
        let unclear = malformed(words("the plot does not say what it is drawn against"), sentence.span);
        let other = |word: &&str| sentence.phrases().rev().find_map(|part| part.split_last(&[word]));
        expressions.diagnostics.push(match AGAINST.iter().find_map(other) {
            Some(other) => unclear.with_fix(other.keyword.span, "against"),
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
            profiles::refuse_mixture(expressions, sentence.span);
            return None;
        }
    };
    Some(Plot { equal: sentence.ending.is_some(), drawing, ..plot })
}

/// Times at which points are drawn: `every 2*pi/Omega`, or `at drive`, the firings of an event. Removed from the end of
/// `part`.
fn moments(expressions: &mut Expressions, part: &mut Phrase) -> Option<Drawing> {
    if let Some(at) = part.split_last(&["at"]).filter(|_| part.split_last(&["every"]).is_none()) {
        *part = at.before;
        return firings(expressions, at.after.span()).map(Drawing::At);
    }
    every(expressions, part).map(Drawing::Every)
}

/// Node that counts the event at which points of runs are taken: `at drive` at the end of `part`, after the parameter, which
/// follows the word at `against`. Removed from `part`. `Some(None)` for a discrete independent variable: one point at each
/// count.
fn points_of_runs(expressions: &mut Expressions, part: &mut Phrase, against: Span) -> Option<Option<NodeId>> {
    if let Some(at) = part.split_last(&["at"]).filter(|at| at.keyword.span.start > against.end) {
        *part = at.before;
        return firings(expressions, at.after.span()).map(Some);
    }
    if expressions.model().independent.counts {
        return Some(None);
    }
    expressions.diagnostics.push(
        Diagnostic::error(
            "plot-syntax",
            words("it is not said at which moments of each run a point is drawn"),
            part.span(),
        )
        .with_hint(words(
            "name an event and draw at its firings: `every 2*pi/Omega as drive { }` in the model, and `at drive` here",
        )),
    );
    None
}

/// Node that counts the firings of the event named in `range`.
fn firings(expressions: &mut Expressions, place: Span) -> Option<NodeId> {
    let name = &expressions.source[place.range()];
    let count = expressions.model().lookup(&format!("{name}.count"), 0).filter(|_| !name.contains('.'));
    if count.is_none() {
        let message = words!("there is no event `{name}`");
        let hint = match name.split_once('.') {
            Some((event, _)) => words!("write its name alone: `at {event}`"),
            None => words!("name it: when ... as {name} {{ ... }}"),
        };
        expressions.diagnostics.push(Diagnostic::error("unknown-name", message, place).with_hint(hint));
    }
    count.map(|count| count.node)
}

/// `every 2*pi/Omega from 10 [s]` at the end of `part`, from which it is removed.
fn every(expressions: &mut Expressions, part: &mut Phrase) -> Option<Every> {
    let Some(every) = part.split_last(&["every"]) else {
        if expressions.model().independent.counts {
            return Some(Every { period: expressions.graph().constant(1.0), from: None });
        }
        expressions.diagnostics.push(
            Diagnostic::error("plot-syntax", words("it is not said when a point is drawn"), part.span())
                .with_hint(words("write `points y against x every 2 [s]`: a point at each multiple of that")),
        );
        return None;
    };
    *part = every.before;
    let from = every.after.split_last(&["from"]);
    let period = moment(expressions, from.map_or(every.after, |from| from.before), &words("the period"))?;
    let Some(from) = from else { return Some(Every { period, from: None }) };
    let place = from.after.span();
    let first = moment(expressions, from.after, &words("the first moment"))?;
    let Node::Constant(bits) = expressions.model().graph.node(first) else {
        expressions.error("plot-syntax", words("the first moment must be a number"), place);
        return None;
    };
    let from = f64::from_bits(bits);
    if !(from.is_finite() && from >= 0.0) {
        expressions.error("plot-syntax", words("the first moment must not lie before 0, where the run begins"), place);
        return None;
    }
    Some(Every { period, from: Some(from) })
}

/// Compiles a value of the independent variable that is constant during a run.
fn moment(expressions: &mut Expressions, phrase: Phrase, what: &Words) -> Option<NodeId> {
    let placed = expressions.constant(phrase.span().range(), what)?;
    let (found, expected) = (placed.value.dimension(), expressions.model().independent.unit.dimension);
    if found != expected {
        let message = words!("{what} has the wrong dimension");
        expressions.diagnostics.push(wrong_dimension(message, placed.span, found, expected));
        return None;
    }
    Some(placed.value.node)
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
