//! MathML of names, numbers, units and texts.

use crate::Unit;
use crate::alphabet::greek_letter;
use crate::markup::escaped;
use crate::number::symbol_text;

/// Parts of a name: ω with the subscript d for `omega_d`, h with 1 for `h1`, r with x for the component `r.x`.
struct NameParts {
    base: String,
    subscript: Vec<String>,
}

fn name_parts(name: &str) -> NameParts {
    let (name, component) = component(name);
    let (name, member) = match name.strip_suffix(']').and_then(|name| name.split_once('[')) {
        Some((family, numbers)) => (family, numbers),
        None => (name, ""),
    };
    let (base, mut lower) = match name.split_once('_') {
        Some((base, lower)) if !base.is_empty() && !lower.is_empty() => (base, vec![lower]),
        _ => (name, Vec::new()),
    };
    let letters = base.trim_end_matches(|c: char| c.is_ascii_digit());
    let digits = &base[letters.len()..];
    let single = |text: &str| text.chars().count() == 1 || greek_letter(text).is_some();
    let base = if !digits.is_empty() && single(letters) {
        lower.insert(0, digits);
        letters
    } else {
        base
    };
    let lower = lower.iter().flat_map(|part| part.split('_'));
    let numbers = member.split(',').filter(|number| !number.is_empty());
    let subscript = lower.chain(numbers).chain(component).map(identifier).collect();
    NameParts { base: identifier(base), subscript }
}

/// Splits `r.x` into vector and component. A value remembered by an event has a word before the point and is not split.
fn component(name: &str) -> (&str, Option<&str>) {
    // Fast path: few names have a point, and each name in a formula is examined several times.
    if !name.as_bytes().contains(&b'.') {
        return (name, None);
    }
    match name.rsplit_once('.') {
        Some((vector, axis @ ("x" | "y" | "z"))) if !is_word(vector.split('[').next().unwrap_or(vector)) => {
            (vector, Some(axis))
        }
        _ => (name, None),
    }
}

/// MathML of one part of a name: a Greek letter for its name, a number, a letter, or a word, which `mi` sets upright.
fn identifier(word: &str) -> String {
    if word == "pi" {
        return "<mi mathvariant=\"normal\">π</mi>".to_owned();
    }
    if let Some(letter) = greek_letter(word) {
        return format!("<mi>{letter}</mi>");
    }
    // A difference or small change: `Deltax` for Δx.
    for prefix in ["Delta", "delta"] {
        if let Some(rest) = word.strip_prefix(prefix)
            && (rest.chars().count() == 1 || greek_letter(rest).is_some())
        {
            let sign = greek_letter(prefix).unwrap_or('Δ');
            let rest = greek_letter(rest).map_or_else(|| escaped(rest), String::from);
            return format!("<mrow><mi mathvariant=\"normal\">{sign}</mi><mi>{rest}</mi></mrow>");
        }
    }
    if word.bytes().all(|byte| byte.is_ascii_digit()) {
        return ["<mn>", word, "</mn>"].concat();
    }
    if let Some(digits) = word.strip_prefix('-') {
        return format!("<mrow><mo>−</mo><mn>{digits}</mn></mrow>");
    }
    ["<mi>", &escaped(word), "</mi>"].concat()
}

/// Superscript of a derivative: primes up to order four, then the order in parentheses; `None` for order 0.
fn order_sign(order: u32) -> Option<String> {
    match order {
        0 => None,
        1 => Some("<mo>′</mo>".to_owned()),
        2 => Some("<mo>″</mo>".to_owned()),
        3 => Some("<mo>‴</mo>".to_owned()),
        4 => Some("<mo>⁗</mo>".to_owned()),
        _ => Some(format!("<mrow><mo>(</mo><mn>{order}</mn><mo>)</mo></mrow>")),
    }
}

/// MathML of a name with `order` primes and an exponent: y′² has a single superscript, not a nested one.
pub fn name(name: &str, order: u32, exponent: Option<String>) -> String {
    indexed(name, &[], order, exponent)
}

/// [`name`] with further subscripts given as MathML: the indices of a member of a family.
pub fn indexed(name: &str, indices: &[String], order: u32, exponent: Option<String>) -> String {
    arranged(name_parts(name), indices, order, exponent)
}

/// [`indexed`] for a vector, with an arrow above.
pub fn vector(name: &str, indices: &[String], order: u32, exponent: Option<String>) -> String {
    let NameParts { base, subscript } = name_parts(name);
    let base = format!("<mover>{base}<mo stretchy=\"false\">→</mo></mover>");
    arranged(NameParts { base, subscript }, indices, order, exponent)
}

fn arranged(parts: NameParts, indices: &[String], order: u32, exponent: Option<String>) -> String {
    let NameParts { base, mut subscript } = parts;
    subscript.extend_from_slice(indices);
    let subscript = match subscript.as_slice() {
        [] => None,
        [one] => Some(one.clone()),
        several => Some(format!("<mrow>{}</mrow>", several.join("<mo>,</mo>"))),
    };
    let above = match (order_sign(order), exponent) {
        (None, None) => None,
        (Some(one), None) | (None, Some(one)) => Some(one),
        (Some(sign), Some(exponent)) => Some(format!("<mrow>{sign}{exponent}</mrow>")),
    };
    match (subscript, above) {
        (None, None) => base,
        (Some(below), None) => ["<msub>", &base, &below, "</msub>"].concat(),
        (None, Some(above)) => ["<msup>", &base, &above, "</msup>"].concat(),
        (Some(below), Some(above)) => ["<msubsup>", &base, &below, &above, "</msubsup>"].concat(),
    }
}

/// True if a name is set as a word, not as a letter, so that its neighbours need a space.
pub fn is_word(name: &str) -> bool {
    let (name, _) = component(name);
    let base = name.split('_').next().unwrap_or(name).trim_end_matches(|c: char| c.is_ascii_digit());
    base.chars().count() > 1 && greek_letter(base).is_none() && !base.starts_with("Delta")
}

/// True if [`number`] writes `value` with a power of ten, which is a product.
pub fn has_power_of_ten(value: f64) -> bool {
    value != 0.0 && !(1e-4..1e6).contains(&value.abs())
}

/// MathML of a number in shortest form; very large and small numbers with a power of ten.
pub fn number(value: f64) -> String {
    let (sign, size) = if value < 0.0 { ("<mo>−</mo>", -value) } else { ("", value) };
    if !has_power_of_ten(size) {
        return if sign.is_empty() {
            format!("<mn>{size}</mn>")
        } else {
            format!("<mrow>{sign}<mn>{size}</mn></mrow>")
        };
    }
    let text = format!("{size:e}");
    let (digits, tens) = text.split_once('e').unwrap_or((&text, "0"));
    let tens = match tens.strip_prefix('-') {
        Some(tens) => format!("<mrow><mo>−</mo><mn>{tens}</mn></mrow>"),
        None => format!("<mn>{tens}</mn>"),
    };
    let power = format!("<msup><mn>10</mn>{tens}</msup>");
    if digits == "1" {
        return if sign.is_empty() { power } else { format!("<mrow>{sign}{power}</mrow>") };
    }
    format!("<mrow>{sign}<mn>{digits}</mn><mo>×</mo>{power}</mrow>")
}

/// Unit after a number, in upright type. The degree sign of an angle follows without space.
pub fn unit_after_number(unit: &Unit) -> String {
    match unit.text.as_str() {
        "" => String::new(),
        "°" | "deg" => "<mi mathvariant=\"normal\">°</mi>".to_owned(),
        text => format!("<mspace width=\"0.1667em\"/>{}", unit_row(text)),
    }
}

/// MathML of a unit such as `kg m/s^2`: upright symbols with spaces, slashes and exponents.
fn unit_row(text: &str) -> String {
    let mut row = String::from("<mrow>");
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let symbol_end = rest.find([' ', '/', '(', ')', '^']).unwrap_or(rest.len()).max(first.len_utf8());
        let (piece, after) = rest.split_at(symbol_end);
        rest = after;
        let piece = match piece {
            " " => "<mspace width=\"0.1667em\"/>".to_owned(),
            "/" => "<mo lspace=\"0\" rspace=\"0\">/</mo>".to_owned(),
            "(" => "<mo form=\"prefix\" stretchy=\"false\">(</mo>".to_owned(),
            ")" => "<mo form=\"postfix\" stretchy=\"false\">)</mo>".to_owned(),
            "1" => "<mn>1</mn>".to_owned(),
            symbol => format!("<mi mathvariant=\"normal\">{}</mi>", escaped(&symbol_text(symbol))),
        };
        match exponent(rest) {
            Some((exponent, after)) => {
                row += &format!("<msup>{piece}{}</msup>", exponent_row(exponent));
                rest = after;
            }
            None => row += &piece,
        }
    }
    row + "</mrow>"
}

/// The exponent at the beginning of `text`, without parentheses, and the rest; `None` if there is none.
fn exponent(text: &str) -> Option<(&str, &str)> {
    let text = text.strip_prefix('^')?;
    if let Some(inside) = text.strip_prefix('(') {
        return inside.split_once(')');
    }
    Some(text.split_at(text.find(|c: char| c != '-' && !c.is_ascii_digit()).unwrap_or(text.len())))
}

/// MathML of an exponent such as `-1/2`.
fn exponent_row(text: &str) -> String {
    let unsigned = text.strip_prefix('-');
    let numbers: Vec<String> = unsigned.unwrap_or(text).split('/').map(|number| format!("<mn>{number}</mn>")).collect();
    let sign = if unsigned.is_some() { "<mo>−</mo>" } else { "" };
    format!("<mrow>{sign}{}</mrow>", numbers.join("<mo lspace=\"0\" rspace=\"0\">/</mo>"))
}

/// A name with its primes (`omega_0`, `y'`) as an inline `<math>` element.
pub fn typeset_name(text: &str) -> String {
    let plain = text.trim_end_matches('\'');
    let order = u32::try_from(text.len() - plain.len()).unwrap_or(u32::MAX);
    format!("<math>{}</math>", name(plain, order, None))
}
