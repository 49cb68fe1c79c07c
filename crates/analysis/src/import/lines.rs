//! Normalised line ends, and line ends inside quoted cells.

use std::borrow::Cow;

/// Greatest length of a quoted cell in bytes; otherwise the quotation mark is an ordinary character.
const LONGEST_CELL: usize = 2000;

/// Text with `\n` or `\r\n` at the ends of its lines, and nowhere else.
pub(super) fn settled(text: Cow<'_, str>) -> Cow<'_, str> {
    let text = if has_lone_return(text.as_bytes()) {
        Cow::Owned(text.replace("\r\n", "\n").replace('\r', "\n"))
    } else {
        text
    };
    if text.contains('"') { joined(text) } else { text }
}

/// True if a carriage return alone ends a line anywhere, as on an old Macintosh.
fn has_lone_return(bytes: &[u8]) -> bool {
    let mut rest = bytes;
    while let Some(place) = rest.iter().position(|byte| *byte == b'\r') {
        if rest.get(place + 1) != Some(&b'\n') {
            return true;
        }
        rest = &rest[place + 2..];
    }
    false
}

/// Replaces each line end inside a quoted cell by a blank.
fn joined(text: Cow<'_, str>) -> Cow<'_, str> {
    let bytes = text.as_bytes();
    let mut changed: Vec<usize> = Vec::new();
    let mut at = 0;
    while let Some(open) = bytes[at..].iter().position(|byte| *byte == b'"').map(|place| at + place) {
        at = open + 1;
        let begins = open == 0 || matches!(bytes[open - 1], b'\n' | b'\r' | b'\t' | b',' | b';' | b'|' | b' ');
        if !begins {
            continue;
        }
        let Some(close) = closing(bytes, at) else { continue };
        changed.extend((at..close).filter(|place| matches!(bytes[*place], b'\n' | b'\r')));
        at = close + 1;
    }
    if changed.is_empty() {
        return text;
    }
    let mut whole = text.into_owned().into_bytes();
    for place in changed {
        whole[place] = b' ';
    }
    // Replacing one ASCII character by another keeps the text valid.
    Cow::Owned(String::from_utf8(whole).unwrap_or_default())
}

/// Position of the quotation mark that ends a cell; a doubled mark stands for one inside it.
fn closing(bytes: &[u8], from: usize) -> Option<usize> {
    let mut at = from;
    let end = bytes.len().min(from + LONGEST_CELL);
    while at < end {
        if bytes[at] != b'"' {
            at += 1;
        } else if bytes.get(at + 1) == Some(&b'"') {
            at += 2;
        } else {
            let next = bytes.get(at + 1).copied().unwrap_or(b'\n');
            return matches!(next, b'\n' | b'\r' | b'\t' | b',' | b';' | b'|' | b' ').then_some(at);
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_end_in_any_way() {
        for (text, expected) in [
            ("a\rb\n\rc\r\nd", "a\nb\n\nc\nd"),
            ("a\r\nb\r\n", "a\r\nb\r\n"),
            ("a,\"b\nc\",d\ne", "a,\"b c\",d\ne"),
            ("a,\"b \"\"x\"\"\r\nc\"\n", "a,\"b \"\"x\"\"  c\"\n"),
            ("5\" pipe\n\"open\nend", "5\" pipe\n\"open\nend"),
        ] {
            assert_eq!(settled(Cow::Borrowed(text)), expected);
        }
    }
}
