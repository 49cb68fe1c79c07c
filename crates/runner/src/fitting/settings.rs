//! Settings of a fit, as a person states them.

use crate::names::{Assignment, Observe};
use crate::records::Stated;
use analysis::fit::Loss;
use analysis::import::DateOrder;
use document::Document;
use program::Seat;

/// Settings of a fit. Values are texts as typed: numbers in the declared unit, numbers with their own, or expressions.
#[derive(Clone, Debug, Default)]
pub struct FitSettings {
    /// Observed quantities, each perhaps with its column.
    pub observe: Vec<Observe>,
    /// Columns of the independent variable.
    pub against: Vec<String>,
    /// Units of columns that the file does not state.
    pub unit: Vec<Assignment>,
    /// Order of day and month in dates, where the numbers do not show it.
    pub dates: Option<DateOrder>,
    /// Seat whose assigned values are taken.
    pub seat: Option<Seat>,
    /// Varied numbers; empty: those of the document's front matter.
    pub vary: Vec<String>,
    /// Varied numbers that have one value in all records.
    pub share: Vec<String>,
    /// Fixed parameters, perhaps with a value for each record.
    pub fix: Vec<Assignment>,
    /// Values of varied numbers at which the search begins.
    pub start: Vec<Assignment>,
    /// Ranges of varied numbers, `LO..HI`.
    pub bounds: Vec<Assignment>,
    /// Standard error of each observed quantity: a value, or the column that holds it.
    pub error: Vec<Assignment>,
    /// Parameters whose values are expressions of others; `L:2` is the parameter L in the second record.
    pub tie: Vec<Assignment>,
    /// Cost of residuals.
    pub loss: Loss,
    /// Beginning of the fitted part.
    pub from: Option<String>,
    /// End of the fitted part.
    pub until: Option<String>,
    /// Rows that are left out: by number, by a range of a column, or by a column that is not 0 in them.
    pub exclude: Vec<String>,
}

impl FitSettings {
    /// Statements of these settings and a document about the columns of a record.
    pub fn stated<'a>(&'a self, document: &'a Document) -> Stated<'a> {
        let variable = &document.program.model.independent;
        Stated {
            units: &self.unit,
            dates: self.dates,
            against: &self.against,
            variable: Some((&variable.name, variable.unit.dimension)),
            observed: &self.observe,
        }
    }
}
