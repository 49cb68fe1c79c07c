//! Numbers as a report writes them: rounded to what is known of them.

use units::Unit;

/// Shown for a number that is not finite.
pub const DASH: &str = "–";

/// A value and its standard error with two significant digits, in the short form that gives the error in units of the
/// value's last digits: `9.6093(21)`, `−0.0027(12)`, `12.3(4.5)`, `1.235(23)×10⁴`. Without an error that is positive and
/// finite, the value alone with six digits.
///
/// The form and the two digits are those of the Guide to the Expression of Uncertainty in Measurement (JCGM 100:2008,
/// 7.2.2 and 7.2.6).
pub fn with_error(value: f64, error: Option<f64>, comma: bool) -> String {
    let Some(error) = error.filter(|error| *error > 0.0 && error.is_finite() && value.is_finite()) else {
        return plain(value, 6, comma);
    };
    // `{:e}` rounds correctly: 0.0996 has become 1.0e-1.
    let (figures, exponent) = scientific(error, 2);
    let last = exponent - 1;
    let leading = scientific(value, 6).1.max(exponent);
    let power = if last > 0 || !(-3..6).contains(&leading) { leading } else { 0 };
    let decimals = usize::try_from(power - last).unwrap_or(0);
    let mut text = shifted(value, power, decimals);
    text.push('(');
    match figures.split_at_checked(1) {
        // The decimal sign of the value lies between the digits of the error.
        Some((first, second)) if decimals == 1 => text.extend([first, ".", second]),
        _ => text.push_str(&figures),
    }
    text.push(')');
    finish(text, power, comma)
}

/// A standard error with two significant digits: `0.0020`.
pub fn error(value: f64, comma: bool) -> String {
    if !value.is_finite() {
        return DASH.to_owned();
    }
    let (_, exponent) = scientific(value, 2);
    let power = if value == 0.0 || (-5..2).contains(&exponent) { 0 } else { exponent };
    finish(shifted(value, power, usize::try_from(power - exponent + 1).unwrap_or(0)), power, comma)
}

/// A number with so many significant digits, without zeros at the end of its decimals: `0.00131`, `1.2×10⁻⁶`.
pub fn plain(value: f64, digits: usize, comma: bool) -> String {
    let text = significant(value, digits, comma);
    let (number, power) = text.split_at(text.find('×').unwrap_or(text.len()));
    let trimmed =
        if number.contains(['.', ',']) { number.trim_end_matches('0').trim_end_matches(['.', ',']) } else { number };
    [trimmed, power].concat()
}

/// A number with so many significant digits, zeros included: `1.40`.
pub fn significant(value: f64, digits: usize, comma: bool) -> String {
    if !value.is_finite() {
        return DASH.to_owned();
    }
    if value == 0.0 {
        return "0".to_owned();
    }
    let (_, exponent) = scientific(value, digits);
    let power = if (-3..6).contains(&exponent) { 0 } else { exponent };
    let decimals = usize::try_from(power - exponent + digits as i32 - 1).unwrap_or(0);
    finish(shifted(value, power, decimals), power, comma)
}

/// A number with so many decimals.
pub fn fixed(value: f64, decimals: usize, comma: bool) -> String {
    if !value.is_finite() {
        return DASH.to_owned();
    }
    finish(shifted(value, 0, decimals), 0, comma)
}

/// A coefficient of determination: with two digits of what it lacks to 1, `0.99948`.
pub fn share(value: f64, comma: bool) -> String {
    let lack = 1.0 - value;
    let decimals = if lack > 0.0 && lack < 0.1 { (1 - scientific(lack, 2).1).clamp(2, 12) } else { 2 };
    fixed(value, decimals as usize, comma)
}

/// The significant digits and the exponent of the first of them.
fn scientific(value: f64, digits: usize) -> (String, i32) {
    let text = format!("{:.*e}", digits - 1, value.abs());
    let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    (mantissa.chars().filter(char::is_ascii_digit).collect(), exponent.parse().unwrap_or(0))
}

/// `value` over ten to the `power` with so many decimals.
fn shifted(value: f64, power: i32, decimals: usize) -> String {
    let exact = format!("{value:.decimals$e}");
    let text = match exact.split_once('e') {
        // The digits of the value itself, rounded once.
        Some((mantissa, exponent)) if power != 0 && exponent.parse() == Ok(power) => mantissa.to_owned(),
        _ => {
            let unit: f64 = format!("1e{power}").parse().unwrap_or(1.0);
            format!("{:.decimals$}", value / unit)
        }
    };
    match text.strip_prefix('-') {
        // No minus before a zero.
        Some(rest) if !rest.bytes().any(|byte| (b'1'..=b'9').contains(&byte)) => rest.to_owned(),
        _ => text,
    }
}

/// The power of ten, a true minus, and the decimal sign.
fn finish(text: String, power: i32, comma: bool) -> String {
    let mut out = String::with_capacity(text.len() + 12);
    for character in text.chars() {
        out.push(match character {
            '-' => '−',
            '.' if comma => ',',
            other => other,
        });
    }
    if power != 0 {
        out.push_str("×10");
        out.push_str(&raised(&power.to_string()));
    }
    out
}

/// A whole number as an exponent: `⁻³`.
fn raised(number: &str) -> String {
    const DIGITS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    number
        .chars()
        .map(|digit| match digit.to_digit(10) {
            Some(digit) => DIGITS[digit as usize],
            None => '⁻',
        })
        .collect()
}

/// A unit as it is printed: `m/s²` for `m/s^2`, `Pa·s` for `Pa s`.
pub fn unit(text: &str) -> String {
    let mut out = String::new();
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        rest = &rest[first.len_utf8()..];
        let digits = rest.find(|c: char| c != '-' && !c.is_ascii_digit()).unwrap_or(rest.len());
        match first {
            '^' if digits > 0 => {
                out.push_str(&raised(&rest[..digits]));
                rest = &rest[digits..];
            }
            ' ' | '*' => out.push('·'),
            other => out.push(other),
        }
    }
    if out == "deg" { "°".to_owned() } else { out }
}

/// A unit in which differences of about `size` (SI) are easy to read: the unit itself, or a thousandth or a millionth of
/// it where these have a name (`mm`, `µm/s`). The part of it, and how it is printed.
pub fn readable(shown: &Unit, size: f64) -> (f64, String) {
    let own = (shown.from_si(size) - shown.from_si(0.0)).abs();
    for (prefix, part, below) in [("m", 1e-3, 0.05), ("u", 1e-6, 5e-5)].into_iter().rev() {
        let named = Unit::parse(&[prefix, &shown.text].concat()).ok();
        let fits = |unit: &Unit| {
            let ratio = unit.factor / (part * shown.factor);
            unit.dimension == shown.dimension && (ratio - 1.0).abs() < 1e-9
        };
        if own < below && own > 0.0 && !shown.text.is_empty() && named.as_ref().is_some_and(fits) {
            let sign = if prefix == "u" { "µ" } else { prefix };
            return (part, [sign, &unit(&shown.text)].concat());
        }
    }
    (1.0, unit(&shown.text))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_are_rounded_to_their_errors() {
        for (value, error, expected) in [
            (9.609_270_46, 0.002_134, "9.6093(21)"),
            (0.386_718_345, 0.002_149, "0.3867(21)"),
            (-0.002_694_6, 0.001_23, "−0.0027(12)"),
            (12.34, 4.5, "12.3(4.5)"),
            (12.34, 0.996, "12.3(1.0)"),
            (12.34, 0.0996, "12.34(10)"),
            (12.34, 0.0994, "12.340(99)"),
            (123.4, 23.0, "123(23)"),
            (12_345.6, 234.0, "1.235(23)×10⁴"),
            (3.904e-6, 2.06e-7, "3.90(21)×10⁻⁶"),
            (1.0e-9, 2.06e-7, "0.0(2.1)×10⁻⁷"),
            (0.0, 0.013, "0.000(13)"),
            (-0.000_4, 0.013, "0.000(13)"),
            (1e7, 1.5, "1.00000000(15)×10⁷"),
            (6.022e23, 1.1e20, "6.0220(11)×10²³"),
            (99.96, 0.31, "99.96(31)"),
        ] {
            assert_eq!(with_error(value, Some(error), false), expected, "{value} {error}");
        }
        assert_eq!(with_error(9.609_270_46, Some(0.002_134), true), "9,6093(21)");
        assert_eq!(with_error(12.34, Some(4.5), true), "12,3(4,5)");
        for none in [None, Some(0.0), Some(f64::NAN), Some(f64::INFINITY), Some(-1.0)] {
            assert_eq!(with_error(9.609_270_46, none, false), "9.60927");
        }
        assert_eq!(with_error(f64::NAN, Some(1.0), false), DASH);
    }

    #[test]
    fn plain_numbers() {
        for (value, digits, expected) in [
            (0.001_312_3, 3, "0.00131"),
            (1.26e-6, 2, "1.3×10⁻⁶"),
            (0.5, 6, "0.5"),
            (1000.0, 3, "1000"),
            (-3.0, 6, "−3"),
            (123_456.7, 3, "123457"),
            (999_999.9, 3, "1×10⁶"),
            (0.0, 3, "0"),
            (f64::INFINITY, 3, DASH),
        ] {
            assert_eq!(plain(value, digits, false), expected, "{value}");
        }
        for (value, expected) in
            [(0.002, "0.0020"), (0.0996, "0.10"), (99.6, "1.0×10²"), (23.4, "23"), (2.34e-7, "2.3×10⁻⁷"), (0.0, "0.0")]
        {
            assert_eq!(error(value, false), expected);
        }
        assert_eq!(significant(1.4, 3, true), "1,40");
        assert_eq!(significant(1.4e-6, 3, false), "1.40×10⁻⁶");
        assert_eq!(plain(1.4e-6, 3, true), "1,4×10⁻⁶");
        assert_eq!(fixed(-0.004, 2, false), "0.00");
        assert_eq!(fixed(-1234.55, 1, true), "−1234,5");
        for (value, expected) in
            [(0.999_481, "0.99948"), (0.5, "0.50"), (1.0, "1.00"), (-3.0, "−3.00"), (0.97, "0.970"), (f64::NAN, DASH)]
        {
            assert_eq!(share(value, false), expected);
        }
    }

    #[test]
    fn units_are_printed() {
        assert_eq!(unit("m/s^2"), "m/s²");
        assert_eq!(unit("kg m^-1 s^-2"), "kg·m⁻¹·s⁻²");
        assert_eq!(unit("m^(1/2)"), "m^(1/2)");
        assert_eq!(unit("deg"), "°");
        assert_eq!(unit(""), "");
        for (text, size, expected) in [
            ("m", 0.001_41, (1e-3, "mm")),
            ("m", 0.2, (1.0, "m")),
            ("m", 2e-6, (1e-6, "µm")),
            ("m/s", 0.003, (1e-3, "mm/s")),
            ("mm", 2e-6, (1.0, "mm")),
            ("1/s", 0.003, (1.0, "1/s")),
            ("rad", 0.003, (1e-3, "mrad")),
            ("kg", 1e-3, (1.0, "kg")),
            ("", 1e-3, (1.0, "")),
            ("m", f64::NAN, (1.0, "m")),
        ] {
            let (part, printed) = readable(&Unit::parse(text).unwrap(), size);
            assert_eq!((part, printed.as_str()), expected, "{text} {size}");
        }
    }
}
