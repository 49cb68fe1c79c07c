//! Common interface of the formats of workbooks, which provide sheets one after the other.

use super::refusal::WorkbookError;

/// Format of a workbook. Only the formats that a program constructs become part of it.
pub(super) trait SheetSource: std::fmt::Debug {
    /// Reads about `budget` more bytes of the expanded workbook.
    fn advance(&mut self, budget: u64) -> Result<Progress, WorkbookError>;

    /// True if another sheet follows the one that was completed last.
    fn has_more(&mut self) -> bool;

    /// Progress in the present sheet, from 0 to 1.
    fn progress(&self) -> f64;

    /// True if each sheet is a text in any form, false if it was made from cells.
    fn holds_texts(&self) -> bool {
        false
    }

    /// True if a sheet of this name is listed before the sheets are read.
    fn lists(&self, _name: &str) -> bool {
        false
    }
}

/// Sheet as text: a line for each row, and tabs between the cells. Numbers have a decimal point; percentages have their
/// sign, `5%`; dates and times are written as `2024-05-01T12:00:00.05` and `00:00:00.05`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SheetText {
    /// Name of the tab.
    pub name: String,
    /// Lines of the sheet.
    pub text: String,
}

/// Result of reading a slice.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Progress {
    /// There is more to read.
    More,
    /// A sheet is complete.
    Sheet(SheetText),
    /// There are no more sheets.
    End,
}
