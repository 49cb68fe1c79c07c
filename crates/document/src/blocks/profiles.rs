//! Plots of one moment, `"Shape": x[i] against i*a for i in 0..N+1`, and histograms, `"Speeds": histogram v[i] for i in
//! 1..N`.

use super::curves;
use super::curves::{add, malformed};
use super::members;
use super::members::Index;
use crate::expressions::Expressions;
use model::{Diagnostic, Phrase, Sentence, Span};
use program::{Drawing, Members, Plot};
use units::words;

/// Adds the curves in `parts` against the expression in `across`, with one point for each value of the index.
pub fn read(
    expressions: &mut Expressions,
    parts: Vec<Phrase>,
    (across, index): (Phrase, Index),
    title: &str,
    (plot, all): (&mut Option<Plot>, &mut Vec<Members>),
) -> Option<()> {
    let values = members::values(expressions, index)?;
    let several = values.start() < values.end();
    let x = members::read(expressions, across, index, values.clone())?;
    if several && x.nodes.windows(2).all(|pair| pair[0] == pair[1]) {
        let name = &x.curve.curve.expression;
        let message = words!("`{name}` is the same for all members");
        expressions.diagnostics.push(
            Diagnostic::error("constant-abscissa", message, x.curve.span)
                .with_hint(words("a curve for each member along the run is written `x[1], x[2] against t`")),
        );
        return None;
    }
    let mut curves = Vec::new();
    for part in parts {
        let read = members::read(expressions, part, index, values.clone())?;
        all.push(Members { x: x.nodes.clone(), y: read.nodes });
        curves.push(read.curve.curve);
    }
    add(expressions, plot, title, curves, x.curve)
}

/// Reads the histogram of `v[i] for i in 1..N`, the members at the moment shown, or of `x`, its values during the run.
pub fn histogram(expressions: &mut Expressions, title: &str, sentence: &Sentence) -> Option<Plot> {
    let mut parts = sentence.phrases();
    let one = parts.next().filter(|part| part.split_last(&["against"]).is_none());
    let Some(part) = one.filter(|_| parts.next().is_none() && sentence.ending.is_none()) else {
        let message = words("a histogram counts the values of one quantity");
        expressions.diagnostics.push(
            malformed(message, sentence.body).with_hint(words("write `histogram v[i] for i in 1..N` or `histogram x`")),
        );
        return None;
    };
    let (curve, nodes) = match members::find(part) {
        Some((before, index)) => {
            let values = members::values(expressions, index)?;
            let read = members::read(expressions, before, index, values)?;
            (read.curve, read.nodes)
        }
        None => (curves::read(expressions, part)?, Vec::new()),
    };
    if nodes.is_empty() && !expressions.model().depends(curve.curve.value.node).varies() {
        let message = words!("`{}` stays the same during a run, so there is nothing to count", curve.curve.expression);
        expressions.error("constant-abscissa", message, curve.span);
        return None;
    }
    let (title, x, curves) = (title.to_owned(), curve.curve.clone(), vec![curve.curve]);
    Some(Plot { title, x, curves, others: Vec::new(), equal: false, drawing: Drawing::Histogram(nodes) })
}

/// Reports a plot that mixes curves at one moment with other curves.
pub fn refuse_mixture(expressions: &mut Expressions, span: Span) {
    let message = words("curves over members and curves along the run cannot share a plot");
    expressions
        .diagnostics
        .push(Diagnostic::error("plot-syntax", message, span).with_hint(words("make them two plots")));
}
