//! Lines between the rows that are not rows.

/// Greatest number of lines between the rows that are kept, and greatest length of one in bytes.
const LINES: usize = 1000;
const LONGEST: usize = 4000;

/// Line between the rows that is not a row.
#[derive(Debug)]
pub(super) struct Between {
    /// Number of rows above it.
    pub row: usize,
    /// Line of the file, from 1.
    pub line: usize,
    pub text: String,
}

/// Keeps a line between the rows, within the bounds.
pub(super) fn keep(lines: &mut Vec<Between>, row: usize, line: usize, text: &str) {
    if row > 0 && lines.len() < LINES && text.len() <= LONGEST && !text.trim().is_empty() {
        lines.push(Between { row, line, text: text.to_owned() });
    }
}

/// True if the first number of a column stands below one of these lines.
pub(super) fn begins(lines: &[Between], column: &[f64]) -> bool {
    let first = column.iter().position(|value| value.is_finite());
    first.is_some_and(|row| lines.binary_search_by_key(&row, |line| line.row).is_ok())
}
