//! Tolerances of answers and of checks: `0.1 %` is a fraction, `1 [mm]` a quantity.

use crate::expressions::{Expressions, Placed, dimension_error};
use crate::text::source::trim;
use model::{Diagnostic, ExpressionKind, Span};
use program::Tolerance;
use units::{Unit, Words, words};

/// Rules for tolerances in one kind of block, and texts for errors.
pub struct Form {
    /// Code of the diagnostics.
    pub code: &'static str,
    /// Message for a tolerance whose dimension differs from that of the value.
    pub other_dimension: Words,
    /// Hint with the form of tolerances.
    pub hint: Words,
    /// True if a number without a unit is a fraction of the value, false if it is a dimensionless quantity.
    pub bare_is_fraction: bool,
}

/// Reads the tolerance at `span`, for `value`.
pub fn read(expressions: &mut Expressions, span: Span, value: &Placed, form: &Form) -> Option<Tolerance> {
    let source = expressions.source;
    let percent =
        source[span.range()].strip_suffix('%').map(|number| trim(source, span.start..span.start + number.len()));
    let (expression, _, found) = model::parse_expression(source, percent.clone().unwrap_or(span.range()));
    if model::has_errors(&found) {
        expressions.diagnostics.extend(found);
        return None;
    }
    let tolerance = match expression.kind {
        ExpressionKind::Number { value, unit: None } if percent.is_some() => Some(Tolerance::Relative(value / 100.0)),
        ExpressionKind::Number { value, unit: None } if form.bare_is_fraction => Some(Tolerance::Relative(value)),
        ExpressionKind::Number { value: number, unit } if percent.is_none() => {
            let unit = unit.unwrap_or_else(Unit::dimensionless);
            if unit.dimension != value.value.dimension() {
                let expected = (value.span, value.value.dimension());
                let diagnostic = dimension_error(form.other_dimension.clone(), (span, unit.dimension), expected);
                expressions.diagnostics.push(diagnostic);
                return None;
            }
            Some(Tolerance::Absolute(unit.to_si_of(number, &value.value.unit)))
        }
        _ => None,
    };
    let is_sensible = |tolerance: &Tolerance| {
        let (Tolerance::Relative(amount) | Tolerance::Absolute(amount)) = tolerance;
        amount.is_finite() && *amount > 0.0
    };
    let tolerance = tolerance.filter(is_sensible);
    if tolerance.is_none() {
        let wrong = words("a tolerance is a positive number");
        expressions.diagnostics.push(Diagnostic::error(form.code, wrong, span).with_hint(form.hint.clone()));
    }
    tolerance
}
