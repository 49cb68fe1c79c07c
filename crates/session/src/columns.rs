//! What a person says of a record's columns: quantity, unit, whether a fit follows it.

use crate::recognise::Meaning;
use crate::{Refusal, Session, number};
use units::Unit;

impl Session {
    /// Takes a column for another quantity; for none where the name is empty. Its unit stays if it can.
    pub fn set_column_quantity(&mut self, id: u32, column: usize, quantity: &str) {
        let units = crate::recognise::measurable(&self.document);
        let unit = units.into_iter().find(|(name, _)| name == quantity).map(|(_, unit)| unit);
        let independent = self.model().independent.name.clone();
        let Some(record) = self.record_mut(id) else { return };
        if let Some(used) = record.uses.get_mut(column) {
            let unit = match unit {
                Some(unit) if unit.dimension != used.meaning.unit.dimension => {
                    used.stated = false;
                    unit
                }
                _ => used.meaning.unit.clone(),
            };
            used.meaning = Meaning { quantity: quantity.to_owned(), unit };
            used.fitted &= !quantity.is_empty() && quantity != independent;
            used.chosen = true;
        }
        self.records_changed();
    }

    /// Gives a column another unit.
    ///
    /// # Errors
    /// What is no unit, or that of something else than the column's quantity.
    pub fn set_column_unit(&mut self, id: u32, column: usize, typed: &str) -> Result<(), Refusal> {
        let unit =
            Unit::parse(typed).map_err(|_| Refusal::UnknownUnit { typed: typed.trim().chars().take(40).collect() })?;
        let known = crate::recognise::measurable(&self.document);
        let Some(used) = self.record_mut(id).and_then(|record| record.uses.get_mut(column)) else { return Ok(()) };
        let own = known.iter().find(|(name, _)| *name == used.meaning.quantity).map(|(_, own)| own);
        if let Some(own) = own.filter(|own| own.dimension != unit.dimension) {
            return Err(Refusal::WrongUnit {
                typed: typed.trim().chars().take(40).collect(),
                expected: number::unit_text(&own.text),
            });
        }
        used.meaning.unit = unit;
        (used.chosen, used.stated) = (true, true);
        self.records_changed();
        Ok(())
    }

    /// Lets a fit follow a column or not.
    pub fn set_column_fitted(&mut self, id: u32, column: usize, fitted: bool) {
        if let Some(used) = self.record_mut(id).and_then(|record| record.uses.get_mut(column)) {
            used.fitted = fitted;
            self.records_changed();
        }
    }
}
