//! Numbers as programs write them: `-1.686115217E2`, `-1,686115217E2`, `−0,5`, `.5`.

/// Powers of ten that are exact.
const POWERS: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20,
    1e21, 1e22,
];

/// What stands in a cell.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Cell {
    /// A finite number.
    Number(f64),
    /// Nothing, or a word for nothing.
    Gap,
    /// Anything else.
    Word,
}

/// What a cell without the blanks around it holds.
pub(super) fn cell(text: &str, decimal: u8) -> Cell {
    if text.is_empty() {
        return Cell::Gap;
    }
    match scan(text.as_bytes(), decimal) {
        Some((number, length)) if length == text.len() => return Cell::Number(number),
        _ => {}
    }
    if text.contains(['\u{2212}', '–']) {
        let plain = text.replace(['\u{2212}', '–'], "-");
        if let Some((number, length)) = scan(plain.as_bytes(), decimal)
            && length == plain.len()
        {
            return Cell::Number(number);
        }
    }
    const GAPS: [&str; 12] = ["nan", "na", "n/a", "#n/a", "-", "--", "\u{2014}", "null", "none", "nil", "?", "1.#qnan"];
    if GAPS.iter().any(|gap| text.eq_ignore_ascii_case(gap)) || text == "–" { Cell::Gap } else { Cell::Word }
}

/// The number at the beginning of `bytes` and its length; `None` if there is none, or it is too large.
///
/// A number of up to 15 digits with a small exponent is one exact operation on exact numbers, and so correctly rounded;
/// the others are left to the standard library.
#[inline]
pub(super) fn scan(bytes: &[u8], decimal: u8) -> Option<(f64, usize)> {
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
            // What overflows is not used.
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
            assert_eq!(cell(&comma, b','), Cell::Number(expected), "{comma}");
        }
    }

    #[test]
    fn words_are_no_numbers() {
        for text in ["1e999", "1.5.2", "1,5", "e5", "inf", "1.5 m", "0x10", "1_000", "--5", "ten", "1.234,5"] {
            assert_eq!(cell(text, b'.'), Cell::Word, "{text}");
        }
        for text in ["", "NaN", "-", "n/a", "NULL", "–", "—"] {
            assert_eq!(cell(text, b'.'), Cell::Gap, "{text}");
        }
        assert_eq!(cell("−0,5", b','), Cell::Number(-0.5));
        assert_eq!(scan(b"1.5e x", b'.'), Some((1.5, 3)));
    }
}
