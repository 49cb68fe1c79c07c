//! Numbers in the notations of programs: `-1.686115217E2`, `-1,686115217E2`, `−0,5`, `.5`.

use super::cells::Delimiter;
use super::notation;

/// Powers of ten that `f64` represents exactly.
const POWERS: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20,
    1e21, 1e22,
];

#[cfg(test)]
thread_local! {
    /// Number of calls of [`scan`].
    pub(super) static SCANNED: std::cell::Cell<usize> = const { std::cell::Cell::new(0) };
}

/// Content of a cell.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Cell {
    /// Finite number.
    Number(f64),
    /// Empty cell, or a word for a missing value.
    Gap,
    /// Anything else.
    Word,
}

/// Decimal and thousands signs of the numbers of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Signs {
    /// `b'.'` or `b','`.
    pub decimal: u8,
    /// The other one of the two, if it groups the digits of large numbers.
    pub thousands: Option<u8>,
}

impl Signs {
    pub fn plain(decimal: u8) -> Self {
        Self { decimal, thousands: None }
    }
}

/// Content of a cell without surrounding blanks.
pub(super) fn cell(text: &str, signs: Signs) -> Cell {
    if text.is_empty() {
        return Cell::Gap;
    }
    if let Some(number) = whole(text, signs) {
        return Cell::Number(number);
    }
    const GAPS: [&str; 11] = ["nan", "na", "n/a", "-", "--", "\u{2014}", "null", "none", "nil", "?", "1.#qnan"];
    if GAPS.iter().any(|gap| text.eq_ignore_ascii_case(gap)) || text == "–" { Cell::Gap } else { Cell::Word }
}

/// Number, if the whole text is one.
fn whole(text: &str, signs: Signs) -> Option<f64> {
    let exact = |text: &str| scan(text.as_bytes(), signs.decimal).filter(|(_, length)| *length == text.len());
    if let Some((number, _)) = exact(text) {
        return Some(number);
    }
    const MINUS: [char; 7] = ['\u{2212}', '–', '\u{2010}', '\u{2011}', '\u{2012}', '\u{fe63}', '\u{ff0d}'];
    if text.contains(MINUS) {
        return whole(&text.replace(MINUS, "-"), signs);
    }
    if let Some(number) = notation::read(text, |plain| whole(plain, signs)) {
        return Some(number);
    }
    let separator = |character: char| {
        matches!(character, ' ' | '\u{a0}' | '\u{2009}' | '\u{202f}' | '\'' | '’')
            || signs.thousands.is_some_and(|sign| character == char::from(sign))
    };
    let plain = ungrouped(text, signs.decimal, separator)?;
    exact(&plain).map(|(number, _)| number)
}

/// Removes separators: `1,234,567.8` becomes `1234567.8`. All must be equal and followed by three digits.
fn ungrouped(text: &str, decimal: u8, separator: impl Fn(char) -> bool) -> Option<String> {
    let whole = text.find(char::from(decimal)).map_or(text, |place| &text[..place]);
    let found = whole.chars().find(|character| separator(*character))?;
    let mut groups = whole.split(found);
    let first = groups.next()?.trim_start_matches(['-', '+']);
    let digits = |group: &str| group.bytes().all(|byte| byte.is_ascii_digit());
    if first.is_empty() || first.len() > 3 || first.starts_with('0') || !digits(first) {
        return None;
    }
    if !groups.all(|group| group.len() == 3 && digits(group)) {
        return None;
    }
    Some(format!("{}{}", whole.replace(found, ""), &text[whole.len()..]))
}

/// True if `sign` occurs once and could separate groups of three digits: `1,295` but not `0,5`.
pub(super) fn could_be_grouped(text: &str, sign: u8) -> bool {
    let sign = char::from(sign);
    text.matches(sign).count() == 1
        && ungrouped(text, b' ', |character| character == sign).is_some_and(|plain| {
            plain.trim_start_matches(['-', '+', '\u{2212}']).bytes().all(|byte| byte.is_ascii_digit())
        })
}

/// Number followed by a unit in the same cell, `12.3 cm`, `45°`, and the text of the unit.
pub(super) fn with_unit(text: &str, signs: Signs) -> Option<(f64, &str)> {
    let end = text.find(|character: char| character.is_alphabetic() || matches!(character, '°' | 'º' | '%' | 'µ'))?;
    // The e of an exponent does not begin a unit.
    let end = match scan(text.as_bytes(), signs.decimal) {
        Some((_, length)) if length > end => length,
        _ => end,
    };
    let (number, unit) = text.split_at_checked(end)?;
    let unit = unit.trim();
    if unit.is_empty() || unit.len() > 16 {
        return None;
    }
    Some((whole(number.trim(), signs)?, unit))
}

/// True if a number has a notation that other readers may read otherwise: `(0.15)`, `3.13(4)`, `4.19k`.
pub(super) fn is_unusual(text: &str) -> bool {
    text.contains(['(', '±', '×', '·', '=', 'k']) || text.ends_with('-')
}

/// True if a cell holds a spreadsheet error: `#DIV/0!`, `#N/A`, `#WERT!`.
pub(super) fn is_spreadsheet_error(text: &str) -> bool {
    let Some(word) = text.strip_prefix('#') else { return false };
    const WITHOUT_MARK: [&str; 6] = ["N/A", "N/D", "NV", "N/V", "NULL", "I/T"];
    let named = word.starts_with(|character: char| character.is_uppercase() || matches!(character, '¡' | '¿'))
        && word.ends_with(['!', '?'])
        && word.len() <= 16;
    named || WITHOUT_MARK.contains(&word) || (!word.is_empty() && word.bytes().all(|byte| byte == b'#'))
}

/// Number at the beginning of `bytes` and its length in bytes; `None` if there is none, or it overflows.
///
/// A mantissa below 2^53 with an exponent of at most 22 needs one operation on exact numbers, so the result is correctly
/// rounded. Other numbers are parsed by the standard library.
#[inline]
pub(super) fn scan(bytes: &[u8], decimal: u8) -> Option<(f64, usize)> {
    #[cfg(test)]
    SCANNED.with(|count| count.set(count.get() + 1));
    let mut at = 0;
    let negative = bytes.first() == Some(&b'-');
    if negative || bytes.first() == Some(&b'+') {
        at = 1;
    }
    let (mut mantissa, mut digits, mut exponent) = (0_u64, 0_usize, 0_i64);
    let mut fraction = false;
    while let Some(&byte) = bytes.get(at) {
        let digit = byte.wrapping_sub(b'0');
        if digit < 10 {
            // May wrap for more than 19 digits; then the mantissa is not used.
            mantissa = mantissa.wrapping_mul(10).wrapping_add(u64::from(digit));
            digits += 1;
            exponent -= i64::from(fraction);
        } else if byte == decimal && !fraction {
            fraction = true;
        } else {
            break;
        }
        at += 1;
    }
    if digits == 0 {
        return None;
    }
    if matches!(bytes.get(at), Some(b'e' | b'E')) {
        let sign = bytes.get(at + 1).copied();
        let mut end = at + 1 + usize::from(matches!(sign, Some(b'-' | b'+')));
        let first = end;
        let mut power = 0_i64;
        while let Some(digit) = bytes.get(end).map(|byte| byte.wrapping_sub(b'0')).filter(|digit| *digit < 10) {
            power = (power * 10 + i64::from(digit)).min(100_000);
            end += 1;
        }
        if end > first {
            exponent += if sign == Some(b'-') { -power } else { power };
            at = end;
        }
    }
    if digits <= 19 && mantissa < 1 << 53 && exponent.unsigned_abs() <= 22 {
        let power = POWERS[exponent.unsigned_abs() as usize];
        let size = if exponent < 0 { mantissa as f64 / power } else { mantissa as f64 * power };
        return Some((if negative { -size } else { size }, at));
    }
    let text = core::str::from_utf8(&bytes[..at]).ok()?;
    let number: f64 = if decimal == b',' { text.replace(',', ".").parse().ok()? } else { text.parse().ok()? };
    number.is_finite().then_some((number, at))
}

/// Reads a line that holds only numbers, gaps and delimiters. Returns false for any other.
pub(super) fn plain(line: &[u8], (delimiter, decimal): (Delimiter, u8), row: &mut Vec<f64>) -> bool {
    let any_blanks = delimiter == Delimiter::Blanks;
    let delimiter = match delimiter.byte() {
        Some(byte) => byte,
        None if any_blanks => b' ',
        None => return false,
    };
    let is_blank = |byte: u8| byte != delimiter && matches!(byte, b' ' | b'\t') || any_blanks && byte == b'\t';
    let mut at = 0;
    let skip = |mut at: usize| {
        while line.get(at).is_some_and(|byte| is_blank(*byte) || any_blanks && *byte == b' ') {
            at += 1;
        }
        at
    };
    loop {
        at = skip(at);
        match scan(&line[at..], decimal) {
            Some((value, length)) => {
                row.push(value);
                at += length;
            }
            None if line.get(at).is_none_or(|byte| *byte == delimiter) => row.push(f64::NAN),
            None => return false,
        }
        let after = skip(at);
        match line.get(after) {
            None => return true,
            // The skipped blanks are the delimiter.
            Some(_) if any_blanks && after > at => at = after,
            Some(byte) if !any_blanks && *byte == delimiter => at = after + 1,
            Some(_) => return false,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_read_to_the_last_bit() {
        for text in [
            "0",
            "-0",
            "1.5",
            "-1.686115217E2",
            "9.999900000E-2",
            "0.03333333333333212",
            "1e22",
            "1e-22",
            "1e23",
            "5e-324",
            "1.7976931348623157e308",
            "123456789012345678901234567890",
            "0.000000000000000000000000000001",
            "+3",
            ".5",
            "5.",
            "9007199254740993",
            "8.41e21",
            "1E+05",
            "18446744073709551617",
            "0.1234567890123456789",
        ] {
            let expected: f64 = text.parse().expect("a number");
            assert_eq!(
                scan(text.as_bytes(), b'.').map(|(number, length)| (number.to_bits(), length)),
                Some((expected.to_bits(), text.len())),
                "{text}"
            );
            let comma = text.replace('.', ",");
            assert_eq!(cell(&comma, Signs::plain(b',')), Cell::Number(expected), "{comma}");
        }
    }

    #[test]
    fn words_are_no_numbers() {
        for text in ["1e999", "1.5.2", "1,5", "e5", "inf", "1.5 m", "0x10", "1_000", "--5", "ten", "1.234,5"] {
            assert_eq!(cell(text, Signs::plain(b'.')), Cell::Word, "{text}");
        }
        for text in ["", "NaN", "-", "n/a", "NULL", "–", "—"] {
            assert_eq!(cell(text, Signs::plain(b'.')), Cell::Gap, "{text}");
        }
        assert_eq!(cell("−0,5", Signs::plain(b',')), Cell::Number(-0.5));
        assert_eq!(scan(b"1.5e x", b'.'), Some((1.5, 3)));
    }

    #[test]
    fn digits_may_stand_in_groups() {
        let comma = Signs { decimal: b'.', thousands: Some(b',') };
        let point = Signs { decimal: b',', thousands: Some(b'.') };
        for (text, signs, expected) in [
            ("1,295", comma, Some(1295.0)),
            ("-1,234,567.25", comma, Some(-1_234_567.25)),
            ("8.454,31", point, Some(8454.31)),
            ("1.234.567", point, Some(1_234_567.0)),
            ("12 345,5", point, Some(12345.5)),
            ("1\u{202f}234", comma, Some(1234.0)),
            ("1'234.5", comma, Some(1234.5)),
            ("0,295", comma, None),
            ("1,29", comma, None),
            ("1234,567", comma, None),
            ("1,234 567", comma, None),
            ("1.5.2", comma, None),
        ] {
            let expected = expected.map_or(Cell::Word, Cell::Number);
            assert_eq!(cell(text, signs), expected, "{text}");
        }
        assert!(could_be_grouped("1,295", b',') && could_be_grouped("-12,295", b','));
        for text in ["0,295", "1,2", "1,2345", "1,295,000", "1,295e3", "926", ",295"] {
            assert!(!could_be_grouped(text, b','), "{text}");
        }
    }

    #[test]
    fn a_unit_may_stand_in_the_cell() {
        let signs = Signs::plain(b'.');
        assert_eq!(with_unit("12.3 cm", signs), Some((12.3, "cm")));
        assert_eq!(with_unit("-45°", signs), Some((-45.0, "°")));
        assert_eq!(with_unit("5%", signs), Some((5.0, "%")));
        assert_eq!(with_unit("1e3", signs), None);
        assert_eq!(with_unit("1e3 V", signs), Some((1000.0, "V")));
        for text in ["cm", "1,5 cm", "x 5 cm", "5 of twelve little ones", "3"] {
            assert_eq!(with_unit(text, signs), None, "{text}");
        }
    }

    #[test]
    fn failed_formulas_are_known() {
        for text in ["#DIV/0!", "#N/A", "#WERT!", "#¡DIV/0!", "#NAME?", "#NV", "####"] {
            assert!(is_spreadsheet_error(text), "{text}");
        }
        for text in ["#", "# t", "#multi:", "N/A", "#5", "#1 !"] {
            assert!(!is_spreadsheet_error(text), "{text}");
        }
    }
}
