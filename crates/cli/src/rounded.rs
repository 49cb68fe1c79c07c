//! Values and their errors as people write them: `9.61 ± 0.02`.

/// A value with its standard error, both with the same decimals: two digits of the error if it begins with 1, else one.
/// Without a useful error the value has four significant digits and the error is empty.
pub fn rounded(value: f64, error: f64) -> (String, String) {
    if !value.is_finite() {
        return ("–".to_owned(), String::new());
    }
    if !(error.is_finite() && error > 0.0) {
        let decimals = usize::try_from(3 - leading(value)).unwrap_or(0).min(12);
        return (with_minus(format!("{value:.decimals$}")), String::new());
    }
    let mut last = last_digit(error);
    // 0.0996 becomes 0.10.
    if last_digit(power(last) * (error / power(last)).round()) > last {
        last += 1;
    }
    let decimals = usize::try_from(-last).unwrap_or(0).min(300);
    let to_digit = |value: f64| if last > 0 { (value / power(last)).round() * power(last) } else { value };
    (with_minus(format!("{:.decimals$}", to_digit(value))), format!("{:.decimals$}", to_digit(error)))
}

/// The place of the last digit that an error shows.
fn last_digit(error: f64) -> i32 {
    let first = leading(error);
    if error / power(first) < 1.95 { first - 1 } else { first }
}

/// The exponent of the first digit; 0 for nothing.
fn leading(value: f64) -> i32 {
    let text = format!("{value:e}");
    text.split_once('e').and_then(|(_, exponent)| exponent.parse().ok()).unwrap_or(0)
}

fn power(exponent: i32) -> f64 {
    format!("1e{exponent}").parse().unwrap_or(f64::NAN)
}

/// A true minus sign, and none before a zero.
fn with_minus(text: String) -> String {
    match text.strip_prefix('-') {
        Some(size) if size.bytes().all(|byte| matches!(byte, b'0' | b'.')) => size.to_owned(),
        Some(size) => format!("−{size}"),
        None => text,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_follow_the_error() {
        for (value, error, expected) in [
            (9.6093, 0.0213, ("9.61", "0.02")),
            (9.6093, 0.0121, ("9.609", "0.012")),
            (9.6093, 0.0996, ("9.61", "0.10")),
            (9.6093, 0.0194, ("9.609", "0.019")),
            (9.6093, 0.0197, ("9.61", "0.02")),
            (-0.0026946, 0.00041, ("−0.0027", "0.0004")),
            (-0.0001, 0.02, ("0.00", "0.02")),
            (1234.0, 37.0, ("1230", "40")),
            (1234.0, 3.7, ("1234", "4")),
            (0.6, 12.0, ("1", "12")),
            (1.23456, 0.0, ("1.235", "")),
            (12345.6, f64::NAN, ("12346", "")),
            (f64::NAN, 1.0, ("–", "")),
        ] {
            assert_eq!(rounded(value, error), (expected.0.to_owned(), expected.1.to_owned()), "{value} ± {error}");
        }
    }
}
