//! Unusual notations of numbers: `- 0.15`, `(0.15)`, `0.15-`, `3.13(4)`, `3.13±0.04`, `1.2×10⁻¹`, `4.19k`, `="3.1"`.

use super::head::superscript;

/// Number in an unusual notation, whose parts are read by `plain`; `None` for other texts.
///
/// Parentheses around a number and a minus sign behind it are the negative signs of accounting. Parentheses behind a number
/// and `±` state its error, which is left out.
pub(super) fn read(text: &str, plain: impl Fn(&str) -> Option<f64>) -> Option<f64> {
    let first = text.chars().next()?;
    // Nearly all words begin with a letter.
    if first.is_alphabetic() || text.len() > 40 || !text.contains(is_digit) {
        return None;
    }
    if text.contains(|letter| ('０'..='９').contains(&letter)) {
        return plain(&text.chars().map(narrow).collect::<String>());
    }
    if let Some(inside) = text.strip_prefix("=\"").and_then(|rest| rest.strip_suffix('"')) {
        return plain(inside.trim());
    }
    if let Some(inside) = text.strip_prefix('(').and_then(|rest| rest.strip_suffix(')')) {
        return unsigned(inside.trim()).then(|| plain(inside.trim())).flatten().map(|number| -number);
    }
    if let Some(rest) = text.strip_prefix("- ") {
        return unsigned(rest.trim_start()).then(|| plain(rest.trim_start())).flatten().map(|number| -number);
    }
    if let Some(rest) = text.strip_suffix('-').filter(|rest| rest.ends_with(is_digit)) {
        return unsigned(rest).then(|| plain(rest)).flatten().map(|number| -number);
    }
    if let Some((number, error)) = text.split_once('±').or_else(|| text.split_once("+/-")) {
        return plain(error.trim()).and_then(|_| plain(number.trim()));
    }
    if let Some((number, error)) = text.strip_suffix(')').and_then(|rest| rest.split_once('(')) {
        let digits =
            !error.is_empty() && error.chars().all(|letter| letter.is_ascii_digit() || matches!(letter, '.' | ','));
        return plain(number.trim()).filter(|_| digits);
    }
    if let Some(number) = text.strip_suffix('k').filter(|rest| rest.ends_with(is_digit)) {
        return plain(&format!("{number}e3"));
    }
    power(text, plain)
}

fn is_digit(letter: char) -> bool {
    letter.is_ascii_digit() || ('０'..='９').contains(&letter)
}

fn unsigned(text: &str) -> bool {
    text.starts_with(|first: char| first.is_ascii_digit() || matches!(first, '.' | ','))
}

/// ASCII character of a full-width digit or sign.
fn narrow(letter: char) -> char {
    match letter {
        '\u{ff01}'..='\u{ff5e}' => char::from_u32(letter as u32 - 0xfee0).unwrap_or(letter),
        _ => letter,
    }
}

/// Reads `1.2×10⁻¹`, `1.2·10^-1`, `1.2 x 10^3`.
fn power(text: &str, plain: impl Fn(&str) -> Option<f64>) -> Option<f64> {
    let (mantissa, rest) = ['×', '·', '*', 'x'].iter().find_map(|sign| text.split_once(*sign))?;
    let exponent = rest.trim_start().strip_prefix("10")?;
    let exponent = exponent.strip_prefix("**").or_else(|| exponent.strip_prefix('^')).unwrap_or(exponent);
    let exponent: String =
        exponent.trim_matches(['{', '}', ' ']).chars().map(|letter| superscript(letter).unwrap_or(letter)).collect();
    let digits = exponent.trim_start_matches(['-', '+']);
    let is_whole = !digits.is_empty() && digits.len() <= 3 && digits.bytes().all(|byte| byte.is_ascii_digit());
    is_whole.then(|| plain(&format!("{}e{exponent}", mantissa.trim()))).flatten()
}
