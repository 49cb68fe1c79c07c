//! Curves of a figure: `y'`, or `(h_l + h_r)/2 + y "Left level"`.

use crate::expressions::{Expressions, dimension_error};
use crate::text::source::trim;
use model::{Diagnostic, Span};
use program::{Curve, Drawing, Plot};
use std::ops::Range;
use units::{Words, words};

/// A curve or an abscissa, and its place.
pub struct Placed {
    /// The curve.
    pub curve: Curve,
    /// Place without its label.
    pub span: Span,
}

/// Error for text that is not a plot.
pub fn malformed(message: Words, range: &Range<usize>) -> Diagnostic {
    Diagnostic::error("plot-syntax", message, Span::new(range.start, range.end))
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

/// Splits off the label at the end: `y "Height"`.
pub fn labelled(source: &str, range: Range<usize>) -> (Range<usize>, Option<String>) {
    let range = trim(source, range);
    if let Some(opening) = source[range.clone()].strip_suffix('"').and_then(|text| text.rfind('"')) {
        let quote = range.start + opening;
        if quote > range.start {
            return (trim(source, range.start..quote), Some(source[quote + 1..range.end - 1].to_owned()));
        }
    }
    (range, None)
}

/// Parses and compiles the curve in `range`.
pub fn read(expressions: &mut Expressions, range: Range<usize>) -> Option<Placed> {
    let (range, label) = labelled(expressions.source, range);
    let value = expressions.number(range.clone())?;
    Some(placed(expressions, value, range.clone(), range, label))
}

/// A curve with the value of the expression in `range`. Without a label it gets the label of the name in `named`, if there
/// is one.
pub fn placed(
    expressions: &Expressions,
    value: crate::expressions::Placed,
    range: Range<usize>,
    named: Range<usize>,
    label: Option<String>,
) -> Placed {
    let source = expressions.source;
    let span = Span::new(range.start, range.end);
    let is_named = label.is_some();
    let label = label.or_else(|| label_of_name(expressions, named));
    let shown = without_unit(&source[range.clone()]).len();
    let expression = model::spaced(source, range.start..range.start + shown);
    Placed { curve: Curve { expression, label, named: is_named, value: value.value }, span }
}

/// An expression without its stated unit, which is shown beside its name anyway.
fn without_unit(text: &str) -> &str {
    let stated = text.trim_end().strip_suffix(']').and_then(|text| text.rsplit_once('['));
    let before = stated.and_then(|(before, _)| before.trim_end().strip_suffix("in"));
    before.filter(|before| before.ends_with(char::is_whitespace)).unwrap_or(text)
}

/// Label of the name in `range`; `None` if the text is not a name or has no label.
fn label_of_name(expressions: &Expressions, range: Range<usize>) -> Option<String> {
    let name = expressions.name(range)?;
    let model = expressions.model();
    if let Some(state) = model.states.iter().find(|state| state.name() == name) {
        return state.label.clone();
    }
    let quantity = model.quantities.iter().find(|quantity| quantity.name == name).map(|quantity| &quantity.label);
    let parameter =
        || model.parameters.iter().find(|parameter| parameter.name == name).map(|parameter| &parameter.label);
    quantity.or_else(parameter)?.clone()
}
