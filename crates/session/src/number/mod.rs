//! Numbers for people: significant digits, engineering exponents (`1.5×10³`), a true minus, the decimal sign of the
//! language; and the way back from what people type.

mod read;

pub use read::parse;

/// How a language writes its numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub struct Style {
    /// A comma separates the decimals.
    pub decimal_comma: bool,
}

impl Style {
    /// The style of a language tag such as `es` or `en-GB`; a point where the language is unknown.
    pub fn of(language: &str) -> Self {
        let primary = language.split(['-', '_']).next().unwrap_or_default();
        let comma = ["es", "de", "fr", "it", "pt", "ca", "gl", "nl", "pl", "ru", "sv", "da", "nb", "fi", "cs", "tr"];
        Self { decimal_comma: comma.contains(&primary.to_ascii_lowercase().as_str()) }
    }
}

/// Shown for a number that is not finite.
pub const DASH: &str = "–";

/// At most `digits` significant digits, without trailing zeros: for values that stand still.
///
/// `0.05`, `13534`, `1.2×10⁶`, `−3`; [`DASH`] where `value` is not finite.
pub fn plain(value: f64, digits: usize, style: Style) -> String {
    write(value, digits, style, true)
}

/// Exactly `digits` significant digits: for values that change while one looks.
pub fn steady(value: f64, digits: usize, style: Style) -> String {
    write(value, digits, style, false)
}

/// A value with its uncertainty, both to the decimals that the uncertainty calls for: two digits of it, as the guide of
/// the Particle Data Group has it where the first three are below 355, else one. `0.3867 ± 0.0012`, `(1.20 ± 0.05)×10⁶`.
pub fn uncertain(value: f64, spread: Option<f64>, style: Style) -> String {
    let Some(spread) = spread.filter(|spread| spread.is_finite() && *spread > 0.0 && value.is_finite()) else {
        return plain(value, 6, style);
    };
    let scientific = format!("{spread:.2e}");
    let (mantissa, exponent) = scientific.split_once('e').unwrap_or((&scientific, "0"));
    let exponent: i32 = exponent.parse().unwrap_or(0);
    let digits = if mantissa.parse::<f64>().unwrap_or(9.0) < 3.55 { 1 } else { 0 };
    let power = power_shown(decimal_exponent(value.abs().max(spread), 3), 6);
    let unit: f64 = format!("1e{power}").parse().unwrap_or(1.0);
    let decimals = digits - exponent + power;
    // Places before the decimal sign are rounded too.
    let whole: f64 = format!("1e{}", (-decimals).max(0)).parse().unwrap_or(1.0);
    let shown = |value: f64| fixed((value / unit / whole).round_ties_even() * whole, 0, style);
    let text = match usize::try_from(decimals) {
        Ok(decimals) => format!("{} ± {}", fixed(value / unit, decimals, style), fixed(spread / unit, decimals, style)),
        Err(_) => format!("{} ± {}", shown(value), shown(spread)),
    };
    if power == 0 { text } else { format!("({text})×10{}", superscript(power)) }
}

/// As many decimals as `digits` significant digits of `scale`, the greatest size the value has had, need: a swinging
/// value then keeps its width and its resolution.
pub fn scaled(value: f64, scale: f64, digits: usize, style: Style) -> String {
    if !value.is_finite() {
        return DASH.to_owned();
    }
    if scale == 0.0 || !scale.is_finite() {
        return plain(value, digits, style);
    }
    let exponent = decimal_exponent(scale, digits);
    let power = power_shown(exponent, digits);
    let decimals = (digits as i32 - 1 - exponent + power).max(0) as usize;
    if power == 0 {
        return fixed(value, decimals, style);
    }
    let unit: f64 = format!("1e{power}").parse().unwrap_or(1.0);
    format!("{}×10{}", fixed(value / unit, decimals, style), superscript(power))
}

/// The exponent of the first of `digits` significant decimal digits.
fn decimal_exponent(value: f64, digits: usize) -> i32 {
    let scientific = format!("{:.*e}", digits.clamp(1, 17) - 1, value.abs());
    scientific.split_once('e').and_then(|(_, exponent)| exponent.parse().ok()).unwrap_or(0)
}

/// The power of ten to be written out: none between 0.001 and 10^6 (or as many digits as are asked for), else a
/// multiple of three.
fn power_shown(exponent: i32, digits: usize) -> i32 {
    if (-3..6.max(digits as i32)).contains(&exponent) { 0 } else { exponent.div_euclid(3) * 3 }
}

/// Exactly `decimals` digits after the decimal sign, whatever the size: for the time.
pub fn fixed(value: f64, decimals: usize, style: Style) -> String {
    if !value.is_finite() {
        return DASH.to_owned();
    }
    let text = format!("{value:.decimals$}");
    let zero = !text.bytes().any(|byte| (b'1'..=b'9').contains(&byte));
    dress(&text, zero, style)
}

fn write(value: f64, digits: usize, style: Style, trim: bool) -> String {
    if !value.is_finite() {
        return DASH.to_owned();
    }
    let digits = digits.clamp(1, 17);
    // `{:e}` rounds correctly in decimal and is the same on every machine.
    let scientific = format!("{:.*e}", digits - 1, value.abs());
    let (mantissa, exponent) = scientific.split_once('e').unwrap_or((&scientific, "0"));
    let mut figures: String = mantissa.chars().filter(char::is_ascii_digit).collect();
    let exponent: i32 = exponent.parse().unwrap_or(0);
    if value == 0.0 {
        return dress(
            if trim || digits == 1 { "0".to_owned() } else { format!("0.{}", "0".repeat(digits - 1)) }.as_str(),
            true,
            style,
        );
    }
    if trim {
        figures.truncate(figures.trim_end_matches('0').len().max(1));
    }
    let scale = power_shown(exponent, digits);
    let mut text = String::new();
    if value < 0.0 {
        text.push('-');
    }
    text.push_str(&place_point(&figures, exponent - scale));
    let mut text = dress(&text, false, style);
    if scale != 0 {
        text.push_str("×10");
        text.push_str(&superscript(scale));
    }
    text
}

/// The digits `figures` with the decimal point after the digit of 10^0, the first one standing for 10^`exponent`.
fn place_point(figures: &str, exponent: i32) -> String {
    if exponent < 0 {
        return format!("0.{}{figures}", "0".repeat((-exponent - 1) as usize));
    }
    let whole = exponent as usize + 1;
    if figures.len() <= whole {
        return format!("{figures}{}", "0".repeat(whole - figures.len()));
    }
    let (left, right) = figures.split_at(whole);
    format!("{left}.{right}")
}

fn dress(text: &str, zero: bool, style: Style) -> String {
    let text = if zero { text.trim_start_matches('-') } else { text };
    let text = text.replace('-', "−");
    if style.decimal_comma { text.replace('.', ",") } else { text }
}

/// `⁻³`
pub fn superscript(number: i32) -> String {
    number
        .to_string()
        .chars()
        .map(|character| match character {
            '-' => '⁻',
            '1' => '¹',
            '2' => '²',
            '3' => '³',
            '4' => '⁴',
            '5' => '⁵',
            '6' => '⁶',
            '7' => '⁷',
            '8' => '⁸',
            '9' => '⁹',
            _ => '⁰',
        })
        .collect()
}

/// A unit's text for people: `kg/m^3` as `kg/m³`, `s^-1` as `s⁻¹`, `deg` as `°`.
pub fn unit_text(text: &str) -> String {
    if text == "deg" {
        return "°".to_owned();
    }
    let mut out = String::new();
    let mut characters = text.chars().peekable();
    while let Some(character) = characters.next() {
        match character {
            '^' => {
                let mut exponent = String::new();
                while let Some(&next) = characters.peek() {
                    if next.is_ascii_digit() || (next == '-' && exponent.is_empty()) {
                        exponent.push(next);
                        characters.next();
                    } else {
                        break;
                    }
                }
                match exponent.parse() {
                    Ok(number) => out.push_str(&superscript(number)),
                    Err(_) => {
                        out.push('^');
                        out.push_str(&exponent);
                    }
                }
            }
            '*' => out.push('·'),
            other => out.push(other),
        }
    }
    out
}

/// The roundest decimal number between `low` and `high`: the fewest significant digits, then nearest the middle.
/// For sliders, so that they stop at 50 and not at 49.837.
pub fn roundest(low: f64, high: f64) -> f64 {
    let middle = low + (high - low) / 2.0;
    if low <= 0.0 && high >= 0.0 {
        return 0.0;
    }
    (0..16)
        .filter_map(|decimals| format!("{middle:.decimals$e}").parse::<f64>().ok())
        .find(|candidate| (low..=high).contains(candidate))
        .unwrap_or(middle)
}

#[cfg(test)]
mod tests {
    use super::*;

    const POINT: Style = Style { decimal_comma: false };
    const COMMA: Style = Style { decimal_comma: true };

    #[test]
    fn values_that_stand_still() {
        for (value, digits, expected) in [
            (0.05, 6, "0.05"),
            (13534.0, 6, "13534"),
            (-3.0, 6, "−3"),
            (0.0, 6, "0"),
            (-0.0, 6, "0"),
            (1.0 / 3.0, 4, "0.3333"),
            (1_234_567.0, 4, "1.235×10⁶"),
            (9.999_999, 3, "10"),
            (999_999.9, 4, "1×10⁶"),
            (0.000_12, 3, "120×10⁻⁶"),
            (0.0012, 3, "0.0012"),
            (1e300, 3, "1×10³⁰⁰"),
            (f64::NAN, 3, "–"),
            (f64::INFINITY, 3, "–"),
        ] {
            assert_eq!(plain(value, digits, POINT), expected, "{value}");
        }
    }

    #[test]
    fn values_that_move_keep_their_width() {
        assert_eq!(steady(0.5, 4, POINT), "0.5000");
        assert_eq!(steady(0.5, 4, COMMA), "0,5000");
        assert_eq!(steady(-12.0, 4, POINT), "−12.00");
        assert_eq!(steady(0.0, 3, POINT), "0.00");
        assert_eq!(fixed(-0.001, 2, POINT), "0.00");
        assert_eq!(fixed(12.345, 1, COMMA), "12,3");
    }

    #[test]
    fn values_are_rounded_as_their_uncertainty_asks() {
        for (value, spread, expected) in [
            (0.386_718, 0.003_12, "0.3867 ± 0.0031"),
            (0.386_718, 0.003_6, "0.387 ± 0.004"),
            (9.609_27, 0.099_6, "9.61 ± 0.10"),
            (-0.000_2, 0.000_04, "(−200 ± 40)×10⁻⁶"),
            (13534.0, 250.0, "13530 ± 250"),
            (1.5e7, 2e5, "(15.00 ± 0.20)×10⁶"),
            (0.25, 0.0, "0.25"),
        ] {
            assert_eq!(uncertain(value, Some(spread), POINT), expected);
        }
        assert_eq!(uncertain(0.25, None, COMMA), "0,25");
        assert_eq!(uncertain(0.25, Some(f64::NAN), COMMA), "0,25");
    }

    #[test]
    fn units_have_raised_exponents() {
        assert_eq!(unit_text("kg/m^3"), "kg/m³");
        assert_eq!(unit_text("kg m^-1 s^-2"), "kg m⁻¹ s⁻²");
        assert_eq!(unit_text("m^(1/2)"), "m^(1/2)");
    }

    #[test]
    fn swinging_values_keep_their_resolution() {
        for (value, scale, expected) in [
            (0.5, 0.5, "0.5000"),
            (-1.2e-17, 0.5, "0.0000"),
            (0.04321, 0.5, "0.0432"),
            (123.456, 200.0, "123.5"),
            (1.5e7, 2e7, "15.00×10⁶"),
            (-2e-5, 4e-4, "−20.0×10⁻⁶"),
            (0.0, 0.0, "0"),
            (f64::NAN, 1.0, "–"),
        ] {
            assert_eq!(scaled(value, scale, 4, POINT), expected, "{value}");
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
