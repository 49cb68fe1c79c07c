//! Single numbers with a given number of digits or decimals.

use super::sign::{dress, place_point, push_power};
use super::{DASH, Style};

/// Smallest exponent of the first digit of a number that is written in full with any number of decimals.
const LEAST: i32 = -3;

/// Maximum number of decimals of smaller numbers written in full.
const DECIMALS: i32 = 5;

/// Exponent of the first digit from which on a power of ten is factored out, unless more digits are asked for.
const LARGE: i32 = 6;

/// At most `digits` significant digits, without trailing zeros: for constant values.
///
/// Examples: `0.05`, `13534`, `1.2×10⁶`, `−3`; [`DASH`] if `value` is not finite.
pub fn plain(value: f64, digits: usize, style: Style) -> String {
    significant(value, digits, style, true)
}

/// Exactly `digits` significant digits: `1.40`.
pub fn steady(value: f64, digits: usize, style: Style) -> String {
    significant(value, digits, style, false)
}

/// Exactly `decimals` digits after the decimal sign, for numbers of any size.
pub fn fixed(value: f64, decimals: usize, style: Style) -> String {
    let last = -i32::try_from(decimals.min(400)).unwrap_or(0);
    rounded(value, last, 0, style)
}

/// Number of decimals of a value rounded to `digits` significant digits, without trailing zeros: 2 for 0.05, 0 for 20.
pub fn decimals(value: f64, digits: usize) -> usize {
    if value == 0.0 || !value.is_finite() {
        return 0;
    }
    let last = exponent(value, digits) + 1 - digits.clamp(1, 17) as i32;
    let figures = units_of(value, last);
    let zeros = figures.len() - figures.trim_end_matches('0').len();
    usize::try_from(-last - zeros as i32).unwrap_or(0)
}

/// A number close to one, such as a coefficient of determination, with two significant digits of its difference from 1:
/// `0.99948`.
pub fn near_one(value: f64, style: Style) -> String {
    let lack = 1.0 - value;
    let decimals = if lack > 0.0 && lack < 0.1 { (1 - exponent(lack, 2)).clamp(2, 12) } else { 2 };
    rounded(value, -decimals, 0, style)
}

/// The roundest decimal number between `low` and `high`: the one with the fewest significant digits, then the one nearest
/// to the middle. Sliders use it to stop at 50, not at 49.837.
pub fn roundest(low: f64, high: f64) -> f64 {
    let middle = low + (high - low) / 2.0;
    if low <= 0.0 && high >= 0.0 {
        return 0.0;
    }
    (0..16)
        .filter_map(|decimals| super::decimal(&format!("{middle:.decimals$e}")))
        .find(|candidate| (low..=high).contains(candidate))
        .unwrap_or(middle)
}

fn significant(value: f64, digits: usize, style: Style, trim: bool) -> String {
    if !value.is_finite() {
        return DASH.to_owned();
    }
    let digits = digits.clamp(1, 17);
    if value == 0.0 {
        return if trim { "0".to_owned() } else { rounded(0.0, 1 - digits as i32, 0, style) };
    }
    let first = exponent(value, digits);
    let mut last = first + 1 - digits as i32;
    if trim {
        let figures = units_of(value, last);
        last += (figures.len() - figures.trim_end_matches('0').len()) as i32;
    }
    let power = power_shown(first, last, digits);
    rounded(value, if power == 0 { last.min(0) } else { last }, power, style)
}

/// `value` divided by 10^`power`, rounded to the digit of 10^`last`, followed by the power.
pub(super) fn rounded(value: f64, last: i32, power: i32, style: Style) -> String {
    let mut text = mantissa(value, last, power, style);
    if value.is_finite() {
        push_power(&mut text, power);
    }
    text
}

/// [`rounded`] without the power.
pub(super) fn mantissa(value: f64, last: i32, power: i32, style: Style) -> String {
    if !value.is_finite() {
        return DASH.to_owned();
    }
    let text = place_point(&units_of(value, last), last - power);
    let text = if value < 0.0 { ["-", &text].concat() } else { text };
    dress(&text, style)
}

/// Decimal exponent of the first digit, after rounding to `digits` significant digits.
pub(super) fn exponent(value: f64, digits: usize) -> i32 {
    let scientific = format!("{:.*e}", digits.clamp(1, 17) - 1, value.abs());
    scientific.split_once('e').and_then(|(_, exponent)| exponent.parse().ok()).unwrap_or(0)
}

/// Power of ten factored out of a number with digits from 10^`first` to 10^`last`: 0 if the number is easily read as it is
/// or has at most `digits` digits, otherwise a multiple of three.
pub(super) fn power_shown(first: i32, last: i32, digits: usize) -> i32 {
    let large = LARGE.max(digits as i32);
    if (LEAST..large).contains(&first) || (first < LEAST && last >= -DECIMALS) { 0 } else { first.div_euclid(3) * 3 }
}

/// Magnitude of `value` in units of 10^`last`, rounded to an integer, as decimal digits. It is rounded once, in decimal,
/// ties to even.
fn units_of(value: f64, last: i32) -> String {
    let size = value.abs();
    if size == 0.0 || !size.is_finite() {
        return "0".to_owned();
    }
    // 18 significant digits distinguish every double from the next power of ten.
    let first = exponent_of(&format!("{size:.17e}"));
    let Ok(digits) = usize::try_from(first - last) else {
        let up = match usize::try_from(-last) {
            // Exact; half a unit in decimal is not.
            Ok(decimals) => format!("{size:.decimals$}").ends_with('1'),
            Err(_) => super::decimal(&place_point("5", last - 1)).is_some_and(|half| size > half),
        };
        return if up { "1" } else { "0" }.to_owned();
    };
    let text = format!("{size:.digits$e}");
    let figures = text.bytes().take_while(|byte| *byte != b'e').filter(u8::is_ascii_digit);
    let mut figures: String = figures.map(char::from).collect();
    // 9.96 rounded to a tenth is 10.0: one digit more.
    if exponent_of(&text) > first {
        figures.push('0');
    }
    figures
}

fn exponent_of(scientific: &str) -> i32 {
    scientific.split_once('e').and_then(|(_, exponent)| exponent.parse().ok()).unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;

    const POINT: Style = Style::POINT;
    const COMMA: Style = Style::COMMA;

    #[test]
    fn values_that_stand_still() {
        for (value, digits, expected) in [
            (0.05, 6, "0.05"),
            (13534.0, 6, "13534"),
            (13534.0, 4, "13534"),
            (123_456.7, 3, "123457"),
            (-3.0, 6, "−3"),
            (0.0, 6, "0"),
            (-0.0, 6, "0"),
            (1.0 / 3.0, 4, "0.3333"),
            (1_234_567.0, 4, "1.235×10⁶"),
            (1_234_567.0, 15, "1234567"),
            (9.999_999, 3, "10"),
            (999_999.9, 3, "1×10⁶"),
            (999_999.9, 4, "1×10⁶"),
            (0.000_12, 3, "0.00012"),
            (0.000_123_456, 6, "123.456×10⁻⁶"),
            (1.26e-6, 2, "1.3×10⁻⁶"),
            (0.0012, 3, "0.0012"),
            (0.001_312_3, 3, "0.00131"),
            (1000.0, 3, "1000"),
            (1e300, 3, "1×10³⁰⁰"),
            (5e-324, 3, "4.94×10⁻³²⁴"),
            (f64::NAN, 3, "–"),
            (f64::INFINITY, 3, "–"),
        ] {
            assert_eq!(plain(value, digits, POINT), expected, "{value}");
        }
        assert_eq!(plain(1.4e-6, 3, COMMA), "1,4×10⁻⁶");
    }

    #[test]
    fn digits_and_decimals_can_be_fixed() {
        for (value, digits, expected) in [
            (0.5, 4, "0.5000"),
            (-12.0, 4, "−12.00"),
            (0.0, 3, "0.00"),
            (1.4, 3, "1.40"),
            (1.4e-6, 3, "1.40×10⁻⁶"),
            (12345.6, 3, "12346"),
        ] {
            assert_eq!(steady(value, digits, POINT), expected, "{value}");
        }
        for (value, decimals, expected) in [
            (-0.001, 2, "0.00"),
            (-0.004, 2, "0.00"),
            (12.345, 1, "12.3"),
            (-1234.55, 1, "−1234.5"),
            (9.96, 1, "10.0"),
            (0.5, 0, "0"),
            (1.5, 0, "2"),
            (0.6, 0, "1"),
            (0.05, 0, "0"),
            (0.096, 1, "0.1"),
            (1e22, 1, "10000000000000000000000.0"),
            (f64::NAN, 1, "–"),
        ] {
            assert_eq!(fixed(value, decimals, POINT), expected, "{value}");
        }
        assert_eq!(fixed(-1234.55, 1, COMMA), "−1234,5");
    }

    #[test]
    fn decimals_are_counted() {
        for (value, expected) in
            [(0.05, 2), (0.1 + 0.2, 1), (20.0, 0), (1e-6, 6), (1.0 / 3.0, 3), (0.0, 0), (f64::NAN, 0)]
        {
            assert_eq!(decimals(value, 3), expected, "{value}");
        }
    }

    #[test]
    fn rounding_is_that_of_the_standard_library() {
        for value in [0.5, 0.05, 0.049_999, 0.25, 0.35, 1.005, 2.675, 99.995, 0.95, 1e-9, 123_456.789, 8.5e-4] {
            for decimals in 0..8 {
                assert_eq!(fixed(value, decimals, POINT), format!("{value:.decimals$}"), "{value} {decimals}");
            }
        }
    }

    #[test]
    fn what_is_near_to_one_shows_what_it_lacks() {
        for (value, expected) in
            [(0.999_481, "0.99948"), (0.5, "0.50"), (1.0, "1.00"), (-3.0, "−3.00"), (0.97, "0.970"), (f64::NAN, DASH)]
        {
            assert_eq!(near_one(value, POINT), expected);
        }
    }

    #[test]
    fn sliders_stop_at_round_numbers() {
        assert_eq!(roundest(49.2, 51.3), 50.0);
        assert_eq!(roundest(0.234, 0.236), 0.235);
        assert_eq!(roundest(-1.0, 1.0), 0.0);
        assert_eq!(roundest(19_900.0, 20_000.0), 20_000.0);
    }
}
