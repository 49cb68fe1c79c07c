//! Numbers as people read them on a figure: exact decimals, a true minus sign, powers of ten.

use std::fmt::Write;

/// Ten to an integer power; exact where a double can be, to the last digit or so elsewhere.
pub(crate) fn power_of_ten(exponent: i32) -> f64 {
    const EXACT: [f64; 23] = [
        1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19,
        1e20, 1e21, 1e22,
    ];
    match usize::try_from(exponent).ok().and_then(|index| EXACT.get(index)) {
        Some(power) => *power,
        None => libm::pow(10.0, f64::from(exponent)),
    }
}

/// `value * 10^exponent`, rounded once where ten to that power is exact.
pub(crate) fn scaled(value: f64, exponent: i32) -> f64 {
    if exponent < 0 { value / power_of_ten(-exponent) } else { value * power_of_ten(exponent) }
}

/// The exponent of the leading digit of a positive number.
pub(crate) fn leading_exponent(value: f64) -> i32 {
    let guess = libm::floor(libm::log10(value)) as i32;
    if scaled(1.0, guess) > value {
        guess - 1
    } else if scaled(1.0, guess + 1) <= value {
        guess + 1
    } else {
        guess
    }
}

/// The power of ten, a multiple of three, that is taken out of numbers of this magnitude; 0 where plain numbers are short.
pub(crate) fn common_power(magnitude: f64) -> i32 {
    if !magnitude.is_finite() || magnitude == 0.0 || (1e-3..1e5).contains(&magnitude) {
        0
    } else {
        leading_exponent(magnitude).div_euclid(3) * 3
    }
}

/// Writes `digits * 10^exponent` exactly, with as many decimals as a negative exponent says.
pub(crate) fn write_decimal(out: &mut String, digits: i64, exponent: i32, decimal_comma: bool) {
    if digits == 0 {
        out.push('0');
        return;
    }
    if digits < 0 {
        out.push('−');
    }
    let start = out.len();
    // Writing to a string cannot fail.
    let _ = write!(out, "{}", digits.unsigned_abs());
    if exponent >= 0 {
        out.extend((0..exponent).map(|_| '0'));
    } else {
        let decimals = exponent.unsigned_abs() as usize;
        while out.len() - start <= decimals {
            out.insert(start, '0');
        }
        out.insert(out.len() - decimals, if decimal_comma { ',' } else { '.' });
    }
}

/// Writes a power of ten, `10⁻⁶`.
pub(crate) fn write_power(out: &mut String, exponent: i32) {
    const RAISED: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let start = out.len();
    let _ = write!(out, "{exponent}");
    let raised: String = out[start..]
        .chars()
        .map(|character| character.to_digit(10).map_or('⁻', |digit| RAISED[digit as usize]))
        .collect();
    out.truncate(start);
    out.push_str("10");
    out.push_str(&raised);
}

/// Writes a value as finely as `resolution` asks: its last digit is no coarser than that. Where the axis has a common
/// power of ten the value is written with it, `1.25×10⁶`.
pub(crate) fn write_value(out: &mut String, value: f64, resolution: f64, power: i32, decimal_comma: bool) {
    if !value.is_finite() {
        out.push('–');
        return;
    }
    let finest = if resolution > 0.0 && resolution.is_finite() { leading_exponent(resolution) } else { 0 };
    let decimals = (power - finest).clamp(0, 15) as usize;
    let start = out.len();
    let _ = write!(out, "{:.decimals$}", scaled(value, -power));
    if out[start..].starts_with('-') {
        out.remove(start);
        if out[start..].contains(|character: char| ('1'..='9').contains(&character)) {
            out.insert(start, '−');
        }
    }
    if decimal_comma && let Some(point) = out[start..].find('.') {
        out.replace_range(start + point..=start + point, ",");
    }
    if power != 0 {
        out.push('×');
        write_power(out, power);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decimals_are_exact() {
        let cases: [(i64, i32, bool, &str); 11] = [
            (0, -2, false, "0"),
            (5, -1, false, "0.5"),
            (-15, -1, false, "−1.5"),
            (10, -1, false, "1.0"),
            (25, -2, true, "0,25"),
            (-2, -4, true, "−0,0002"),
            (3, 0, false, "3"),
            (2, 3, false, "2000"),
            (123_456, -3, false, "123.456"),
            (-9_007_199_254_740_993, 0, false, "−9007199254740993"),
            (1, -5, false, "0.00001"),
        ];
        for (digits, exponent, comma, expected) in cases {
            let mut text = String::new();
            write_decimal(&mut text, digits, exponent, comma);
            assert_eq!(text, expected);
        }
    }

    #[test]
    fn values_show_what_the_resolution_allows() {
        let cases: [(f64, f64, i32, bool, &str); 9] = [
            (0.412_34, 0.000_5, 0, false, "0.4123"),
            (-0.412_34, 0.01, 0, true, "−0,41"),
            (-0.000_01, 0.01, 0, false, "0.00"),
            (1234.5, 10.0, 0, false, "1234"),
            (1_250_000.0, 10_000.0, 6, false, "1.25×10⁶"),
            (-3.5e-7, 1e-9, -9, false, "−350×10⁻⁹"),
            (f64::NAN, 1.0, 0, false, "–"),
            (2.0, 0.0, 0, false, "2"),
            (0.1, 1e-300, 0, false, "0.100000000000000"),
        ];
        for (value, resolution, power, comma, expected) in cases {
            let mut text = String::new();
            write_value(&mut text, value, resolution, power, comma);
            assert_eq!(text, expected);
        }
    }

    #[test]
    fn leading_exponents_are_exact_at_the_powers() {
        for exponent in -300..=300 {
            let power = scaled(1.0, exponent);
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
