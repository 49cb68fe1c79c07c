//! Typography of numbers: minus sign, decimal sign, powers of ten, units with superscripts.

use super::{DASH, Style};
use crate::Unit;

/// Replaces decimal point and minus by the signs of the style. Zero gets no minus.
pub(super) fn dress(text: &str, style: Style) -> String {
    let zero = !text.bytes().any(|byte| (b'1'..=b'9').contains(&byte));
    let text = if zero { text.trim_start_matches('-') } else { text };
    let text = text.replace('-', "−");
    if style.decimal_comma { text.replace('.', ",") } else { text }
}

/// `digits * 10^exponent` as decimal number with a point: `15` and -1 give `1.5`, `15` and 2 give `1500`.
pub(super) fn place_point(digits: &str, exponent: i32) -> String {
    if exponent >= 0 {
        let zeros = if digits == "0" { 0 } else { exponent as usize };
        return [digits, &"0".repeat(zeros)].concat();
    }
    let decimals = exponent.unsigned_abs() as usize;
    let padded = format!("{digits:0>width$}", width = decimals + 1);
    let (whole, rest) = padded.split_at(padded.len() - decimals);
    [whole, ".", rest].concat()
}

/// Appends `×10⁻⁶`; nothing for an exponent of 0.
pub(super) fn push_power(out: &mut String, exponent: i32) {
    if exponent != 0 {
        out.push('×');
        write_power(out, exponent);
    }
}

/// Appends a power of ten, `10⁻⁶`.
pub fn write_power(out: &mut String, exponent: i32) {
    out.push_str("10");
    out.push_str(&superscript(exponent));
}

/// An integer as superscript, `⁻³`.
pub fn superscript(number: i32) -> String {
    number.to_string().chars().map(raise).collect()
}

fn raise(character: char) -> char {
    match character {
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
    }
}

/// Displayed form of a symbol: `°` for `deg`, `kΩ` for `kohm`.
pub(crate) fn symbol_text(symbol: &str) -> String {
    if symbol == "deg" { "°".to_owned() } else { symbol.replace("ohm", "Ω") }
}

/// Displayed form of a unit: `kg/m³` for `kg/m^3`, `Pa·s` for `Pa s`, `°/s` for `deg/s`.
pub fn unit_text(text: &str) -> String {
    let mut out = String::new();
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let symbol = rest.find(|letter: char| !letter.is_alphabetic()).unwrap_or(rest.len());
        if symbol > 0 {
            let (symbol, after) = rest.split_at(symbol);
            out.push_str(&symbol_text(symbol));
            rest = after;
            continue;
        }
        rest = &rest[first.len_utf8()..];
        let sign = usize::from(rest.starts_with('-'));
        let digits = sign + rest[sign..].bytes().take_while(u8::is_ascii_digit).count();
        match first {
            '^' if digits > sign => {
                out.extend(rest[..digits].chars().map(raise));
                rest = &rest[digits..];
            }
            ' ' | '*' => out.push('·'),
            other => out.push(other),
        }
    }
    out
}

/// A number with its unit: `0.05 m²`, `30°`. A dash gets no unit.
pub fn with_unit(number: &str, unit: &Unit) -> String {
    if unit.text.is_empty() || number == DASH {
        return number.to_owned();
    }
    match unit_text(&unit.text).as_str() {
        "°" => [number, "°"].concat(),
        text => [number, " ", text].concat(),
    }
}

/// A value and its error, as written by [`super::with_error`], with a unit for both: `(0.5 ± 0.7) mm/s`.
pub fn error_with_unit(text: &str, unit: &str) -> String {
    if unit.is_empty() || text == DASH {
        return text.to_owned();
    }
    let alone = text.starts_with('(') || !text.contains('±');
    let text = if alone { text.to_owned() } else { ["(", text, ")"].concat() };
    if unit == "°" { text + "°" } else { [&text, " ", unit].concat() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_have_raised_exponents_and_dots() {
        for (unit, expected) in [
            ("m/s^2", "m/s²"),
            ("kg m^-1 s^-2", "kg·m⁻¹·s⁻²"),
            ("Pa s", "Pa·s"),
            ("m^(1/2)", "m^(1/2)"),
            ("m^-", "m^-"),
            ("deg", "°"),
            ("deg/s^2", "°/s²"),
            ("N m/deg", "N·m/°"),
            ("kohm", "kΩ"),
            ("", ""),
        ] {
            assert_eq!(unit_text(unit), expected, "{unit}");
        }
    }

    #[test]
    fn units_follow_their_numbers() {
        for (number, unit, expected) in
            [("0.05", "m^2", "0.05 m²"), ("30", "deg", "30°"), ("5", "%", "5 %"), ("2", "", "2"), (DASH, "m", DASH)]
        {
            assert_eq!(with_unit(number, &Unit::parse(unit).unwrap()), expected, "{number} {unit}");
        }
    }

    #[test]
    fn the_point_stands_where_the_exponent_says() {
        for (digits, exponent, expected) in
            [("15", -1, "1.5"), ("15", 2, "1500"), ("0", -2, "0.00"), ("0", 2, "0"), ("7", -3, "0.007")]
        {
            assert_eq!(place_point(digits, exponent), expected);
        }
    }
}
