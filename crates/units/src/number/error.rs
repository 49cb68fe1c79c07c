//! A value with its standard error, both written to the same digit.

use super::digits::is_error;
use super::plain::{exponent, mantissa, plain, power_shown};
use super::sign::push_power;
use super::{Layout, Style};

/// Value and error as text: `0.387 ± 0.003`, `0.3867 ± 0.0021`, `(1.20 ± 0.05)×10⁶`. The error has two significant digits
/// if its first digit is 1 or 2, otherwise one. Without a positive, finite error: the value with six digits.
pub fn with_error(value: f64, error: Option<f64>, style: Style) -> String {
    let known = known(value, error).and_then(|error| Some((error, Layout::of_errors([(value, error)])?)));
    match known {
        Some((error, layout)) => layout.with_error(value, error, style),
        None => plain(value, 6, style),
    }
}

/// Value and error in concise form, with the error in units of the last digits of the value: `9.6093(21)`, `−0.0027(12)`,
/// `12.3(4.5)`, `12.35(23)×10³`. The error has two significant digits. Without a positive, finite error: the value with six
/// digits.
///
/// Form and number of digits follow the Guide to the Expression of Uncertainty in Measurement (JCGM 100:2008, 7.2.2 and
/// 7.2.6).
pub fn concise(value: f64, error: Option<f64>, style: Style) -> String {
    let Some(error) = known(value, error) else {
        return plain(value, 6, style);
    };
    let last = exponent(error, 2) - 1;
    let mut power = power_shown(exponent(value.abs().max(error), 3), last, 0);
    // The digits in parentheses must not end left of the decimal sign.
    while power < last {
        power += 3;
    }
    let mut text = mantissa(value, last, power, style);
    text.push('(');
    let digits = match power - last {
        // The decimal sign of the value falls between the two digits of the error.
        1 => mantissa(error, last, power, style),
        _ => mantissa(error, last, last, style),
    };
    text.push_str(&digits);
    text.push(')');
    push_power(&mut text, power);
    text
}

fn known(value: f64, error: Option<f64>) -> Option<f64> {
    error.filter(|error| is_error(value, *error))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::DASH;

    const POINT: Style = Style::POINT;
    const COMMA: Style = Style::COMMA;

    #[test]
    fn value_and_error_end_at_the_same_digit() {
        for (value, error, expected) in [
            (0.386_718, 0.003_12, "0.387 ± 0.003"),
            (0.386_718, 0.002_12, "0.3867 ± 0.0021"),
            (0.386_718, 0.003_6, "0.387 ± 0.004"),
            (9.609_27, 0.099_6, "9.61 ± 0.10"),
            (9.609_27, 0.029_4, "9.609 ± 0.029"),
            (9.609_27, 0.029_6, "9.61 ± 0.03"),
            (-0.000_2, 0.000_04, "−0.00020 ± 0.00004"),
            (0.000_5, 0.000_7, "0.0005 ± 0.0007"),
            (0.5e-6, 0.7e-6, "(0.5 ± 0.7)×10⁻⁶"),
            (-2.04e-6, 0.04e-6, "(−2.04 ± 0.04)×10⁻⁶"),
            (13534.0, 250.0, "13530 ± 250"),
            (1234.0, 37.0, "1230 ± 40"),
            (0.6, 12.0, "1 ± 12"),
            (1.5e7, 2e5, "(15.00 ± 0.20)×10⁶"),
            (0.25, 0.0, "0.25"),
            // Rounding errors do not count as errors.
            (0.3, 4.4e-17, "0.3"),
            (10.471_975_511_965_976, 1.1e-15, "10.472"),
            (-0.5e-15, 0.5e-15, "(−0.5 ± 0.5)×10⁻¹⁵"),
        ] {
            assert_eq!(with_error(value, Some(error), POINT), expected, "{value} {error}");
        }
        assert_eq!(with_error(0.386_718, Some(0.002_12), COMMA), "0,3867 ± 0,0021");
        assert_eq!(with_error(0.25, None, COMMA), "0,25");
        assert_eq!(with_error(0.25, Some(f64::NAN), COMMA), "0,25");
        assert_eq!(with_error(f64::NAN, Some(1.0), POINT), DASH);
    }

    #[test]
    fn the_short_form_has_two_digits_of_the_error() {
        for (value, error, expected) in [
            (9.609_270_46, 0.002_134, "9.6093(21)"),
            (0.386_718_345, 0.002_149, "0.3867(21)"),
            (-0.002_694_6, 0.001_23, "−0.0027(12)"),
            (0.000_5, 0.000_7, "0.00050(70)"),
            (12.34, 4.5, "12.3(4.5)"),
            (12.34, 0.996, "12.3(1.0)"),
            (12.34, 0.0996, "12.34(10)"),
            (12.34, 0.0994, "12.340(99)"),
            (123.4, 23.0, "123(23)"),
            (12_345.6, 234.0, "12.35(23)×10³"),
            (12_345.6, 2340.0, "12.3(2.3)×10³"),
            (3.904e-6, 2.06e-7, "3.90(21)×10⁻⁶"),
            (1.0e-9, 2.06e-7, "0.00(21)×10⁻⁶"),
            (0.0, 0.013, "0.000(13)"),
            (-0.000_4, 0.013, "0.000(13)"),
            (1e7, 1.5, "10.0000000(15)×10⁶"),
            (6.022e23, 1.1e20, "602.20(11)×10²¹"),
            (99.96, 0.31, "99.96(31)"),
        ] {
            assert_eq!(concise(value, Some(error), POINT), expected, "{value} {error}");
        }
        assert_eq!(concise(9.609_270_46, Some(0.002_134), COMMA), "9,6093(21)");
        assert_eq!(concise(12.34, Some(4.5), COMMA), "12,3(4,5)");
        for none in [None, Some(0.0), Some(f64::NAN), Some(f64::INFINITY), Some(-1.0)] {
            assert_eq!(concise(9.609_270_46, none, POINT), "9.60927");
        }
        assert_eq!(concise(f64::NAN, Some(1.0), POINT), DASH);
    }
}
