//! One curve of a figure: `y'`, or `(h_l + h_r)/2 + y "Left level"`.

use crate::expressions::Expressions;
use crate::source::trim;
use model::{ExpressionKind, Span};
use program::{Curve, Model};
use std::ops::Range;

/// A curve or an abscissa, and where it stands.
pub struct Placed {
    /// What is drawn.
    pub curve: Curve,
    /// Where it stands, without its label.
    pub span: Span,
}

/// Takes the label at the end off: `y "Height"`.
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

/// Reads the curve that fills `range`.
pub fn read(expressions: &mut Expressions, range: Range<usize>) -> Option<Placed> {
    let (range, label) = labelled(expressions.source, range);
    let written = range.clone();
    expression(expressions, range, written, label)
}

/// A curve with the value of the expression in `range`, which is shown as what stands in `written`.
pub fn expression(
    expressions: &mut Expressions,
    range: Range<usize>,
    written: Range<usize>,
    label: Option<String>,
) -> Option<Placed> {
    let source = expressions.source;
    let value = expressions.number(range.clone())?.value;
    let span = Span::new(range.start, range.end);
    let label = label.or_else(|| label_of_name(expressions.model(), source, range));
    let expression = source[written].split_whitespace().collect::<Vec<_>>().join(" ");
    Some(Placed { curve: Curve { expression, label, value }, span })
}

/// The author's label of the name that fills `range`, if a name does.
fn label_of_name(model: &Model, source: &str, range: Range<usize>) -> Option<String> {
    let (expression, _, _) = model::parse_expression(source, range);
    let ExpressionKind::Name { name, order } = expression.kind else {
        return None;
    };
    let state = model.states.iter().find(|state| state.variable == name && state.order == order);
    if let Some(state) = state {
        return state.label.clone();
    }
    if order > 0 {
        return None;
    }
    let quantity = model.quantities.iter().find(|quantity| quantity.name == name).map(|quantity| &quantity.label);
    let parameter =
        || model.parameters.iter().find(|parameter| parameter.name == name).map(|parameter| &parameter.label);
    quantity.or_else(parameter)?.clone()
}
