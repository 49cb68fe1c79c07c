//! Lines of a source and their places.

use std::ops::Range;

/// A line of a text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Line {
    /// First byte.
    pub start: usize,
    /// Byte after the last character, before the line end.
    pub end: usize,
    /// First byte of the next line.
    pub next: usize,
}

impl Line {
    /// Text without the line end.
    pub fn text<'a>(&self, source: &'a str) -> &'a str {
        &source[self.start..self.end]
    }

    /// Byte range without the line end.
    pub fn range(&self) -> Range<usize> {
        self.start..self.end
    }
}

/// Lines in `range` of `source`; the bounds must lie on character boundaries. Lines end in LF or CR LF.
pub fn lines(source: &str, range: Range<usize>) -> impl Iterator<Item = Line> {
    let mut start = range.start;
    std::iter::from_fn(move || {
        if start >= range.end {
            return None;
        }
        let found = source[start..range.end].find('\n');
        let next = found.map_or(range.end, |at| start + at + 1);
        let mut end = found.map_or(range.end, |at| start + at);
        if source[start..end].ends_with('\r') {
            end -= 1;
        }
        let line = Line { start, end, next };
        start = next;
        Some(line)
    })
}

/// `range` of `source` without outer blanks.
pub fn trim(source: &str, range: Range<usize>) -> Range<usize> {
    let text = &source[range.clone()];
    let start = range.start + (text.len() - text.trim_start().len());
    start..start + text.trim().len()
}

/// [`trim`], but the beginning of `range` instead of its end if it is blank.
pub fn trimmed(source: &str, range: Range<usize>) -> Range<usize> {
    if source[range.clone()].trim().is_empty() { range.start..range.start } else { trim(source, range) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_keep_their_places() {
        let source = "a\r\nbc\n\nd";
        let found: Vec<_> = lines(source, 0..source.len()).map(|line| line.text(source)).collect();
        assert_eq!(found, ["a", "bc", "", "d"]);
        assert_eq!(lines(source, 3..5).collect::<Vec<_>>(), [Line { start: 3, end: 5, next: 5 }]);
    }
}
