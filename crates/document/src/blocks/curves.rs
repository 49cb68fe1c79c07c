//! Curves of a figure: `y'`, or `(h_l + h_r)/2 + y "Left level"`.

use crate::expressions::{Expressions, dimension_error};
use model::{Diagnostic, Phrase, Span, inside};
use program::{Curve, Drawing, Plot, Taken};
use units::{Words, words};

/// A curve or an abscissa, and its place.
pub struct Placed {
    /// The curve.
    pub curve: Curve,
    /// Place without its label.
    pub span: Span,
}

/// Error for text that is not a plot.
pub fn malformed(message: Words, span: Span) -> Diagnostic {
    Diagnostic::error("plot-syntax", message, span)
}

/// Adds curves against `x` to a plot. All abscissas must have one dimension.
pub fn add(
    expressions: &mut Expressions,
    plot: &mut Option<Plot>,
    title: &str,
    curves: Vec<Curve>,
    x: Placed,
) -> Option<()> {
    let Some(plot) = plot else {
        let (title, others, equal, drawing) = (title.to_owned(), Vec::new(), false, Drawing::Run);
        *plot = Some(Plot { title, x: x.curve, curves, others, equal, drawing });
        return Some(());
    };
    let (found, expected) = (x.curve.value.dimension(), plot.x.value.dimension());
    if found != expected {
        let message = words!("`{}` cannot share the horizontal axis with `{}`", x.curve.expression, plot.x.expression);
        let mut diagnostic = dimension_error(message, (x.span, found), (x.span, expected));
        // Both labels would be at the same place.
        let expected = diagnostic.labels.pop().map(|label| label.text).unwrap_or_default();
        expressions
            .diagnostics
            .push(diagnostic.with_note(words!("the axis is {expected}")).with_hint(words("make it a plot of its own")));
        return None;
    }
    for curve in curves {
        if x.curve != plot.x {
            plot.others.push((plot.curves.len(), x.curve.clone()));
        }
        plot.curves.push(curve);
    }
    Some(())
}

/// Converts curves that count cycles to angles, or the reverse, if the first curve of their axis counts those: a frequency of
/// 1 Hz is drawn at 2 pi on an axis in rad/s.
pub fn turn(expressions: &mut Expressions, plot: &mut Plot) {
    for index in 0..plot.curves.len() {
        let (before, after) = plot.curves.split_at_mut(index);
        let Some(curve) = after.first_mut() else { continue };
        let Some(first) = before.iter().find(|one| one.value.dimension() == curve.value.dimension()) else { continue };
        let (own, axis) = (curve.value.unit.clone(), first.value.unit.clone());
        curve.value = expressions.turned(curve.value.clone(), &axis);
        let graph = expressions.graph();
        match &mut plot.drawing {
            Drawing::Sweep(sweep) => {
                if let Some(Taken::Run(node)) = sweep.taken.get_mut(index) {
                    *node = model::turned(graph, *node, &own, &axis);
                }
            }
            Drawing::Profile(profile) => {
                for node in profile.members.get_mut(index).into_iter().flat_map(|members| &mut members.y) {
                    *node = model::turned(graph, *node, &own, &axis);
                }
            }
            _ => {}
        }
    }
    for (_, x) in &mut plot.others {
        x.value = expressions.turned(x.value.clone(), &plot.x.value.unit);
    }
}

/// Label of a phrase: `y "Height"`.
pub fn label(source: &str, phrase: Phrase) -> Option<String> {
    phrase.label().map(|label| inside(source, label).to_owned())
}

/// Parses and compiles a curve.
pub fn read(expressions: &mut Expressions, phrase: Phrase) -> Option<Placed> {
    let (span, label) = (phrase.unlabelled(), label(expressions.source, phrase));
    let value = expressions.number(span.range())?;
    Some(placed(expressions, value, span, span, label))
}

/// A curve with the value of the expression at `span`. Without a label it gets the label of the name at `named`, if there is
/// one.
pub fn placed(
    expressions: &Expressions,
    value: crate::expressions::Placed,
    span: Span,
    named: Span,
    label: Option<String>,
) -> Placed {
    let source = expressions.source;
    let is_named = label.is_some();
    let label = label.or_else(|| label_of_name(expressions, named));
    let shown = without_unit(&source[span.range()]).len();
    let expression = model::spaced(source, span.start..span.start + shown);
    Placed { curve: Curve { expression, label, named: is_named, value: value.value }, span }
}

/// An expression without its stated unit, which is shown beside its name anyway.
fn without_unit(text: &str) -> &str {
    let stated = text.trim_end().strip_suffix(']').and_then(|text| text.rsplit_once('['));
    let before = stated.and_then(|(before, _)| before.trim_end().strip_suffix("in"));
    before.filter(|before| before.ends_with(char::is_whitespace)).unwrap_or(text)
}

/// Label of the name at `span`; `None` if the text is not a name or has no label.
fn label_of_name(expressions: &Expressions, span: Span) -> Option<String> {
    let name = expressions.name(span.range())?;
    let model = expressions.model();
    if let Some(state) = model.states.iter().find(|state| state.name() == name) {
        return state.label.clone();
    }
    let quantity = model.quantities.iter().find(|quantity| quantity.name == name).map(|quantity| &quantity.label);
    let parameter =
        || model.parameters.iter().find(|parameter| parameter.name == name).map(|parameter| &parameter.label);
    quantity.or_else(parameter)?.clone()
}
