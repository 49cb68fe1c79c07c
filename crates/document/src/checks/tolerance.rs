//! Tolerances of claims: `1e-6` and `0.1 %` are fractions, `1 [mm]` is a quantity.

use crate::blocks::tolerances;
use crate::blocks::tolerances::Form;
use crate::expressions::{Expressions, Placed};
use model::{Diagnostic, Span};
use program::Tolerance;
use units::number::shortest;
use units::words;

const FORM: Form = Form {
    code: "check-syntax",
    other_dimension: words("the tolerance and the value have different dimensions"),
    hint: words("write a fraction, `1e-6` or `0.1 %`, or a quantity such as `1 [mm]`"),
    bare_is_fraction: true,
};

/// Reads the tolerance at `span`, for `value`. `of_zero`: true if the expected value is 0, for which a fraction is
/// useless.
pub fn tolerance(expressions: &mut Expressions, span: Span, value: &Placed, of_zero: bool) -> Option<Tolerance> {
    let is_percent = expressions.source[span.range()].ends_with('%');
    let tolerance = tolerances::read(expressions, span, value, &FORM)?;
    if of_zero && matches!(tolerance, Tolerance::Relative(_)) {
        let unit = value.value.unit.text.as_str();
        let example = if unit.is_empty() { "abs(x) < 0.001".to_owned() } else { format!("within 0.001 [{unit}] of 0") };
        expressions.diagnostics.push(
            Diagnostic::error("check-syntax", words("a fraction of 0 is 0, so nothing is near enough"), span)
                .with_hint(words!("state how near with a unit, as in `{example}`")),
        );
        return None;
    }
    if let (Tolerance::Relative(part), false, true) = (tolerance, is_percent, value.value.dimension().is_none()) {
        expressions.diagnostics.push(bare(part, span));
    }
    Some(tolerance)
}

/// Warns of `within 0.5`, which could be meant as a fraction or as a difference.
fn bare(part: f64, span: Span) -> Diagnostic {
    let percent = percent(part);
    let message = words!("a tolerance without a unit is a fraction: {percent} % of what the value should be");
    Diagnostic::warning("bare-tolerance", message, span)
        .with_hint(words!("for the fraction write `{percent} %`"))
        .with_hint(words!("for a difference write `{percent} [%]`, which is {}", shortest(part)))
        .with_fix(span, format!("{percent} %"))
        .with_fix(span, format!("{percent} [%]"))
}

/// A hundred times a number, without rounding its digits.
fn percent(part: f64) -> String {
    let written = format!("{part:e}");
    let moved = written.split_once('e').and_then(|(digits, exponent)| {
        let exponent: i32 = exponent.parse().ok()?;
        format!("{digits}e{}", exponent + 2).parse::<f64>().ok()
    });
    shortest(moved.unwrap_or(100.0 * part))
}
