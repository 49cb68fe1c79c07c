//! How far off a claim may be: `1e-6` and `0.1 %` are fractions, `1 [mm]` is a quantity.

use crate::expressions::{Expressions, Placed, dimension_error};
use model::{Diagnostic, ExpressionKind, Span};
use program::Tolerance;
use std::ops::Range;
use units::words;

/// The tolerance that fills `range`, for `value`. `of_zero` says that the value should be 0, of which a fraction is 0 too.
pub fn tolerance(
    expressions: &mut Expressions,
    range: Range<usize>,
    value: &Placed,
    of_zero: bool,
) -> Option<Tolerance> {
    let span = Span::new(range.start, range.end);
    let text = &expressions.source[range.clone()];
    let tolerance = if let Some(percent) = text.strip_suffix('%') {
        percent.trim().parse().ok().map(|percent: f64| Tolerance::Relative(percent / 100.0))
    } else {
        match model::parse_expression(expressions.source, range).0.kind {
            ExpressionKind::Number { value, unit: None } => Some(Tolerance::Relative(value)),
            ExpressionKind::Number { value: number, unit: Some(unit) } => {
                if unit.dimension != value.value.dimension() {
                    let message = words(
                        "the tolerance and the value have different dimensions",
                        "la tolerancia y el valor tienen dimensiones distintas",
                    );
                    let expected = (value.span, value.value.dimension());
                    expressions.diagnostics.push(dimension_error(message, (span, unit.dimension), expected));
                    return None;
                }
                Some(Tolerance::Absolute(unit.to_si(number)))
            }
            _ => None,
        }
    };
    let is_sensible = |tolerance: &Tolerance| {
        let (Tolerance::Relative(amount) | Tolerance::Absolute(amount)) = tolerance;
        amount.is_finite() && *amount > 0.0
    };
    let Some(tolerance) = tolerance.filter(is_sensible) else {
        expressions.diagnostics.push(
            Diagnostic::error(
                "check-syntax",
                words("a tolerance is a positive number", "una tolerancia es un número positivo"),
                span,
            )
            .with_hint(words(
                "write a fraction, `1e-6` or `0.1 %`, or a quantity such as `1 [mm]`",
                "escribe una fracción, `1e-6` o `0.1 %`, o una magnitud, por ejemplo `1 [mm]`",
            )),
        );
        return None;
    };
    if of_zero && matches!(tolerance, Tolerance::Relative(_)) {
        let unit = value.value.unit.text.as_str();
        let example = if unit.is_empty() { "abs(x) < 0.001".to_owned() } else { format!("within 0.001 [{unit}] of 0") };
        expressions.diagnostics.push(
            Diagnostic::error(
                "check-syntax",
                words(
                    "a fraction of 0 is 0, so nothing is near enough",
                    "una fracción de 0 es 0, así que nada está lo bastante cerca",
                ),
                span,
            )
            .with_hint(words!(
                "state how near with a unit, as in `{example}`",
                "indica la tolerancia con una unidad, como en `{example}`"
            )),
        );
        return None;
    }
    Some(tolerance)
}
