//! The recorded run as a table.

use crate::Session;
use std::ops::Range;

impl Session {
    /// `t [s]`, `y [m]`, ...: the heads of the columns.
    pub fn table_header(&self) -> Vec<String> {
        Vec::new()
    }

    /// How many rows are recorded.
    pub fn table_length(&self) -> usize {
        0
    }

    /// Some rows, their cells in the session's language.
    pub fn table_rows(&mut self, rows: Range<usize>) -> Vec<Vec<String>> {
        let _ = rows;
        Vec::new()
    }

    /// The row at the time shown.
    pub fn table_row_now(&self) -> usize {
        0
    }

    /// The whole run as CSV, the same bytes as the command line writes for the same run.
    pub fn csv(&mut self) -> String {
        String::new()
    }
}
