//! Splitting of a line into cells.

/// Greatest number of columns of a table.
pub(super) const COLUMNS: usize = 10_000;

/// Delimiter between two cells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Delimiter {
    /// One tab.
    Tab,
    /// One semicolon.
    Semicolon,
    /// One comma.
    Comma,
    /// A comma followed by a blank; a comma without one is the decimal sign.
    CommaAndBlank,
    /// Any number of blanks and tabs.
    Blanks,
    /// Exactly one blank: two of them enclose an empty cell.
    Blank,
    /// This ASCII character.
    Other(u8),
}

impl Delimiter {
    /// The byte of a delimiter of one character.
    pub(super) fn byte(self) -> Option<u8> {
        match self {
            Self::Tab => Some(b'\t'),
            Self::Semicolon => Some(b';'),
            Self::Comma => Some(b','),
            Self::Blank => Some(b' '),
            Self::Other(byte) => Some(byte),
            Self::CommaAndBlank | Self::Blanks => None,
        }
    }
}

/// Delimiter declared by a line, as Excel allows in the first one of a file: `sep=;`.
pub(super) fn declared(line: &str) -> Option<u8> {
    let line = line.trim_end_matches(['\n', '\r']).trim_matches('"');
    let (_, sign) = line.split_once('=').filter(|(name, _)| name.eq_ignore_ascii_case("sep"))?;
    match sign.as_bytes() {
        [byte] if byte.is_ascii() && !byte.is_ascii_alphanumeric() => Some(*byte),
        b"\\t" => Some(b'\t'),
        _ => None,
    }
}

/// Cells of a line from left to right, without the blanks and quotation marks around them.
#[derive(Clone, Debug)]
pub(super) struct Cells<'a> {
    rest: Option<&'a str>,
    delimiter: Delimiter,
}

impl<'a> Cells<'a> {
    pub fn of(line: &'a str, delimiter: Delimiter) -> Self {
        let line = if delimiter == Delimiter::Blanks { line.trim() } else { line };
        let nothing = delimiter == Delimiter::Blanks && line.is_empty();
        Self { rest: (!nothing).then_some(line), delimiter }
    }

    /// Begin and end of the delimiter after the first cell of `text`.
    fn delimiter_in(&self, text: &str) -> Option<(usize, usize)> {
        match self.delimiter {
            Delimiter::Blanks => {
                let start = text.find([' ', '\t'])?;
                let blanks = text[start..].bytes().take_while(|byte| matches!(byte, b' ' | b'\t')).count();
                Some((start, start + blanks))
            }
            Delimiter::CommaAndBlank => {
                let start = text.find(", ").or_else(|| text.ends_with(',').then(|| text.len() - 1))?;
                Some((start, (start + 2).min(text.len())))
            }
            _ => {
                let start = text.find(char::from(self.delimiter.byte()?))?;
                Some((start, start + 1))
            }
        }
    }
}

impl<'a> Iterator for Cells<'a> {
    type Item = &'a str;

    fn next(&mut self) -> Option<&'a str> {
        let text = self.rest?;
        // A delimiter between quotation marks does not count.
        let blanks = if self.delimiter == Delimiter::Tab {
            text.len() - text.trim_start_matches(' ').len()
        } else {
            text.len() - text.trim_start().len()
        };
        let quoted = text[blanks..].strip_prefix('"').and_then(|inside| inside.find('"'));
        let from = quoted.map_or(0, |length| blanks + length + 2);
        let (end, next) = match self.delimiter_in(&text[from..]) {
            Some((end, next)) => (from + end, Some(from + next)),
            None => (text.len(), None),
        };
        self.rest = next.map(|next| &text[next..]);
        Some(match quoted {
            // Text after the closing quotation mark belongs to the cell and makes it a word.
            Some(length) if text[from..end].trim().is_empty() => text[blanks + 1..blanks + 1 + length].trim(),
            _ => text[..end].trim(),
        })
    }
}

/// Cells of each line. The delimiter is the character after the first cell if that is in quotation marks, else a tab.
pub(crate) fn cells_of(text: &str) -> impl Iterator<Item = Vec<&str>> {
    let quoted = text.trim_start_matches('\u{feff}').strip_prefix('"');
    let behind = quoted.and_then(|rest| rest.split_once('"')).and_then(|(_, rest)| rest.bytes().next());
    let delimiter = behind.filter(|byte| matches!(byte, b',' | b';')).map_or(Delimiter::Tab, Delimiter::Other);
    text.lines().map(move |line| Cells::of(line, delimiter).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_fall_into_cells() {
        let cases: &[(&str, Delimiter, &[&str])] = &[
            ("1\t\t 2\t", Delimiter::Tab, &["1", "", "2", ""]),
            (" 1  2\t3 ", Delimiter::Blanks, &["1", "2", "3"]),
            ("", Delimiter::Blanks, &[]),
            ("", Delimiter::Comma, &[""]),
            ("1  2 ", Delimiter::Blank, &["1", "", "2", ""]),
            ("1,5, 2,5", Delimiter::CommaAndBlank, &["1,5", "2,5"]),
            ("1,5, 2,", Delimiter::CommaAndBlank, &["1,5", "2", ""]),
            ("\"1,5\", \"a \" ,3", Delimiter::Comma, &["1,5", "a", "3"]),
            ("\"a,b\"c,d", Delimiter::Comma, &["\"a,b\"c", "d"]),
            ("\"open,d", Delimiter::Comma, &["\"open", "d"]),
            ("\"a b\" c", Delimiter::Blanks, &["a b", "c"]),
            ("1|2", Delimiter::Other(b'|'), &["1", "2"]),
        ];
        for (line, delimiter, expected) in cases {
            assert_eq!(Cells::of(line, *delimiter).collect::<Vec<_>>(), *expected, "{line:?}");
        }
    }
}
