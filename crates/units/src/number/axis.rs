//! Numbers in a figure: exact labels of ticks, and values as fine as the resolution of the figure.

use super::plain::mantissa;
use super::sign::{dress, place_point};
use super::{Style, unit_text};
use crate::Unit;

/// Ten to an integer power; exact up to 10^22, otherwise to about the last digit.
fn power_of_ten(exponent: i32) -> f64 {
    const EXACT: [f64; 23] = [
        1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19,
        1e20, 1e21, 1e22,
    ];
    match usize::try_from(exponent).ok().and_then(|index| EXACT.get(index)) {
        Some(power) => *power,
        None => libm::pow(10.0, f64::from(exponent)),
    }
}

/// `value * 10^exponent`, correctly rounded if that power of ten is exact.
pub fn scaled_by(value: f64, exponent: i32) -> f64 {
    if exponent < 0 { value / power_of_ten(-exponent) } else { value * power_of_ten(exponent) }
}

/// Decimal exponent of the leading digit of a positive number.
pub fn leading_exponent(value: f64) -> i32 {
    let guess = libm::floor(libm::log10(value)) as i32;
    if scaled_by(1.0, guess) > value {
        guess - 1
    } else if scaled_by(1.0, guess + 1) <= value {
        guess + 1
    } else {
        guess
    }
}

/// Power of ten factored out of numbers of this magnitude: a multiple of three, or 0 if plain numbers are short.
pub fn common_power(magnitude: f64) -> i32 {
    if !magnitude.is_finite() || magnitude == 0.0 || (1e-3..1e5).contains(&magnitude) {
        0
    } else {
        leading_exponent(magnitude).div_euclid(3) * 3
    }
}

/// Label of a tick: exactly `digits * 10^exponent`, with as many decimals as a negative exponent requires; zero is `0`.
pub fn tick(digits: i64, exponent: i32, style: Style) -> String {
    if digits == 0 {
        return "0".to_owned();
    }
    let text = place_point(&digits.unsigned_abs().to_string(), exponent);
    dress(&if digits < 0 { ["-", &text].concat() } else { text }, style)
}

/// `value` divided by 10^`power`, with its last digit no coarser than `resolution`.
pub fn resolved(value: f64, resolution: f64, power: i32, style: Style) -> String {
    let finest = if resolution > 0.0 && resolution.is_finite() { leading_exponent(resolution) } else { 0 };
    let decimals = (power - finest).clamp(0, 15);
    mantissa(value, power - decimals, power, style)
}

/// Unit of numbers from which a power of ten was factored out, and the power that remains: `mm` and 0 for `m` and -3; `1/s`
/// and -3 because that unit takes no prefix.
pub fn axis_unit(unit: &str, power: i32) -> (String, i32) {
    let prefixed = Some(unit).filter(|unit| power != 0 && !unit.is_empty());
    let prefixed = prefixed.and_then(|unit| Unit::parse(unit).ok()?.with_power(power));
    match prefixed {
        Some(prefixed) => (unit_text(&prefixed.text), 0),
        None => (unit.to_owned(), power),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const POINT: Style = Style::POINT;
    const COMMA: Style = Style::COMMA;

    #[test]
    fn labels_of_ticks_are_exact() {
        for (digits, exponent, style, expected) in [
            (0, -2, POINT, "0"),
            (5, -1, POINT, "0.5"),
            (-15, -1, POINT, "−1.5"),
            (10, -1, POINT, "1.0"),
            (25, -2, COMMA, "0,25"),
            (-2, -4, COMMA, "−0,0002"),
            (3, 0, POINT, "3"),
            (2, 3, POINT, "2000"),
            (123_456, -3, POINT, "123.456"),
            (-9_007_199_254_740_993, 0, POINT, "−9007199254740993"),
            (1, -5, POINT, "0.00001"),
        ] {
            assert_eq!(tick(digits, exponent, style), expected);
        }
    }

    #[test]
    fn values_show_what_the_resolution_allows() {
        for (value, resolution, power, style, expected) in [
            (0.412_34, 0.000_5, 0, POINT, "0.4123"),
            (-0.412_34, 0.01, 0, COMMA, "−0,41"),
            (-0.000_01, 0.01, 0, POINT, "0.00"),
            (1234.5, 10.0, 0, POINT, "1234"),
            (1_250_000.0, 10_000.0, 6, POINT, "1.25"),
            (-3.5e-7, 1e-9, -9, POINT, "−350"),
            (f64::NAN, 1.0, 0, POINT, "–"),
            (2.0, 0.0, 0, POINT, "2"),
            (0.1, 1e-300, 0, POINT, "0.100000000000000"),
        ] {
            assert_eq!(resolved(value, resolution, power, style), expected);
        }
    }

    #[test]
    fn powers_become_prefixes() {
        for (unit, power, expected) in [
            ("m", -3, ("mm", 0)),
            ("m/s²", -6, ("µm/s²", 0)),
            ("Pa·s", -3, ("mPa·s", 0)),
            ("J", 6, ("MJ", 0)),
            ("m", 6, ("m", 6)),
            ("1/s", -3, ("1/s", -3)),
            ("m²", -6, ("mm²", 0)),
            ("°", -3, ("°", -3)),
            ("", 3, ("", 3)),
            ("swings", 3, ("swings", 3)),
            ("m", 0, ("m", 0)),
        ] {
            assert_eq!(axis_unit(unit, power), (expected.0.to_owned(), expected.1), "{unit} {power}");
        }
    }

    #[test]
    fn leading_exponents_are_exact_at_the_powers() {
        for exponent in -300..=300 {
            let power = scaled_by(1.0, exponent);
            assert_eq!(leading_exponent(power), exponent);
            assert_eq!(leading_exponent(power * 9.999), exponent);
            assert_eq!(leading_exponent(power * 0.999), exponent - 1);
        }
    }

    #[test]
    fn common_powers_are_multiples_of_three() {
        let cases =
            [(0.0, 0), (0.5, 0), (99_999.0, 0), (1e5, 3), (2e6, 6), (5e-4, -6), (1e-3, 0), (1e-9, -9), (1e300, 300)];
        for (magnitude, expected) in cases {
            assert_eq!(common_power(magnitude), expected, "{magnitude}");
        }
    }
}
