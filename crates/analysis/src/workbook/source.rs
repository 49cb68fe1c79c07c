//! Sheets of a workbook, whatever its form, one after the other.

use super::refusal::WorkbookError;

/// A form of workbook. Only the forms that a program constructs become part of it.
pub(super) trait SheetSource: std::fmt::Debug {
    /// Reads on for about `budget` bytes of what the workbook expands to.
    fn advance(&mut self, budget: u64) -> Result<Progress, WorkbookError>;

    /// True if another sheet follows the one that was completed last.
    fn has_more(&mut self) -> bool;

    /// Part of the present sheet that has been read, from 0 to 1.
    fn progress(&self) -> f64;

    /// True if each sheet is a text in any form, and not one that was made of cells.
    fn holds_texts(&self) -> bool {
        false
    }

    /// True if there is a sheet of this name, as far as the workbook lists its sheets before they are read.
    fn lists(&self, _name: &str) -> bool {
        false
    }
}

/// A sheet as text: a line for each row, tabs between the cells, numbers with a decimal point, numbers that are shown as
/// percentages with their sign, `5%`, dates and times as `2024-05-01T12:00:00.05` and `00:00:00.05`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SheetText {
    /// The name on its tab.
    pub name: String,
    /// Its lines.
    pub text: String,
}

/// Result of a slice of reading.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Progress {
    /// There is more to read.
    More,
    /// A sheet is complete.
    Sheet(SheetText),
    /// There are no more sheets.
    End,
}
