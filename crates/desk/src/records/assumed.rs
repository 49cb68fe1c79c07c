//! Units of columns for which neither the file nor the user states one.

use crate::records::recognise::observed;
use crate::records::record::{Record, Use};
use analysis::assumed_unit::{AssumedUnit, Expectation, assumed_unit};
use document::Document;

impl Record {
    /// True if the unit of a used column is assumed.
    pub(crate) fn assumes_unit(&self, uses: &[Use], column: usize) -> bool {
        let own = self.table.columns.get(column).filter(|own| own.unit.is_none());
        let used = uses.get(column).filter(|used| !used.stated && !used.meaning.quantity.is_empty());
        own.is_some() && used.is_some() && column < self.read_columns() && !self.asks_for_unit(uses, column)
    }

    /// Unit that a document declares for the quantity of a column, and the size of the numbers beside its own run; `None` if
    /// the column measures nothing or the independent variable.
    pub(crate) fn expectation(&self, document: &Document, uses: &[Use], column: usize) -> Option<Expectation> {
        let model = &document.program.model;
        let quantity = &uses.get(column)?.meaning.quantity;
        let observed = observed(model, quantity).filter(|_| *quantity != model.independent.name)?;
        let own = self.table.columns.get(column)?;
        let clock = &uses.get(own.independent)?.meaning.unit;
        let times = self.table.columns.get(own.independent)?.values.iter().map(|time| clock.to_si(*time));
        Some(Expectation::new(model, &observed, &times.collect::<Vec<f64>>(), &own.values))
    }

    /// Decides the units of all columns that state none. `before`: earlier uses of the columns, with units that stay unless
    /// they make the numbers out of proportion to the run of the document.
    pub(super) fn assume_units(&mut self, document: &Document, before: &[Use]) {
        for column in 0..self.uses.len() {
            if !self.assumes_unit(&self.uses, column) {
                continue;
            }
            let own = &self.uses[column].meaning.unit;
            let alike = |used: &&Use| !used.meaning.quantity.is_empty() && used.meaning.unit.dimension == own.dimension;
            let earlier = before.get(column).filter(alike);
            let present = earlier.map(|used| &used.meaning.unit);
            // The unit that a person has stated holds for every document.
            let stated = earlier.is_some_and(|used| used.stated);
            if !stated && own.is_coherent() && present.is_none_or(|present| present.is_coherent()) {
                continue;
            }
            let decided = match self.expectation(document, &self.uses, column) {
                Some(expectation) if !stated => assumed_unit(present, &[expectation]),
                _ => None,
            };
            let unit = match decided {
                Some(AssumedUnit::Unit(unit)) => Some(unit),
                Some(AssumedUnit::Open(_)) | None => present.cloned(),
            };
            if let (Some(used), Some(unit)) = (self.uses.get_mut(column), unit) {
                (used.meaning.unit, used.stated) = (unit, stated);
            }
        }
    }
}
