//! A sheet as text with tabs between its cells: a line for each row, so that a workbook is read by the same rules as a text
//! and a message about a line is about a row.

use super::moment::Moment;
use super::refusal::WorkbookError;

/// What a sheet can have (ECMA-376, 18.3.1.73; LibreOffice has as many).
pub(super) const MOST_ROWS: u32 = 1_048_576;
pub(super) const MOST_COLUMNS: u32 = 16_384;

/// No cell holds a longer text, in bytes: 32767 characters.
pub(super) const LONGEST_VALUE: usize = 4 * 32_767;

/// Cells in the order of reading, as they become a text.
#[derive(Debug)]
pub(super) struct Lines {
    text: String,
    row: u32,
    column: u32,
    /// Longer it may not become, in bytes.
    most: usize,
}

impl Lines {
    pub fn new(most: usize) -> Self {
        Self { text: String::new(), row: 0, column: 0, most }
    }

    /// Moves on to a cell, counted from 0. `called` is for the message if that is not possible.
    pub fn go_to(&mut self, row: u32, column: u32, called: &dyn Fn() -> String) -> Result<(), WorkbookError> {
        if row >= MOST_ROWS || column >= MOST_COLUMNS || (row, column) < (self.row, self.column) {
            return Err(WorkbookError::Place { cell: called().chars().take(40).collect() });
        }
        if row > self.row {
            self.text.extend(std::iter::repeat_n('\n', (row - self.row) as usize));
            (self.row, self.column) = (row, 0);
        }
        self.text.extend(std::iter::repeat_n('\t', (column - self.column) as usize));
        self.column = column;
        if self.text.len() > self.most { Err(self.too_large()) } else { Ok(()) }
    }

    fn too_large(&self) -> WorkbookError {
        WorkbookError::TooLarge { most: self.most >> 20 }
    }

    /// Writes a number as it stands in the file.
    pub fn number(&mut self, digits: &str) {
        self.word(digits.trim());
    }

    /// Writes a text, without what would end the cell or its line.
    pub fn word(&mut self, text: &str) {
        let kept = |character: char| if matches!(character, '\t' | '\n' | '\r' | '"') { ' ' } else { character };
        self.text.extend(text.chars().map(kept));
    }

    /// Writes a date, a time or a duration.
    pub fn moment(&mut self, moment: Moment) {
        moment.write(&mut self.text);
    }

    /// Repeats the row that was written last so many times.
    pub fn repeat_row(&mut self, times: u32) -> Result<(), WorkbookError> {
        let start = self.text.rfind('\n').map_or(0, |end| end + 1);
        let line = format!("\n{}", self.text.get(start..).unwrap_or_default());
        let rows = u64::from(self.row) + u64::from(times);
        let length = (times as usize).checked_mul(line.len()).and_then(|more| more.checked_add(self.text.len()));
        if rows >= u64::from(MOST_ROWS) || length.is_none_or(|length| length > self.most) {
            return Err(self.too_large());
        }
        self.text.extend(std::iter::repeat_n(line.as_str(), times as usize));
        self.row += times;
        Ok(())
    }

    /// The text.
    pub fn finish(self) -> String {
        self.text
    }
}
