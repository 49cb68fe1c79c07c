//! Columns of a record: text of their cells, and the user's choice of quantity, unit and use in fits.

use crate::records::recognise::Meaning;
use crate::{Desk, Refusal, number};
use units::Unit;

impl Desk {
    /// Text of some cells of a record's column, to 6 significant digits; empty for gaps and rows that do not exist.
    pub fn record_cells(&self, id: u32, column: usize, rows: std::ops::Range<usize>) -> Vec<String> {
        let values = self.record(id).and_then(|record| record.table.columns.get(column)).map(|column| &column.values);
        let rows = values.and_then(|values| values.get(rows.start..rows.end.min(values.len()))).unwrap_or_default();
        let cell =
            |value: &f64| if value.is_nan() { String::new() } else { number::plain(*value, 6, self.play.style()) };
        rows.iter().map(cell).collect()
    }

    /// Quantities of the document that a column can measure: name and symbol.
    pub fn measurable(&self) -> Vec<(String, String)> {
        crate::records::recognise::measurable(&self.document)
            .into_iter()
            .map(|(name, _)| (name.clone(), play::symbol(&name)))
            .collect()
    }

    /// Sets the quantity that a column measures; an empty name sets none. The unit is kept if its dimension fits.
    pub fn set_column_quantity(&mut self, id: u32, column: usize, quantity: &str) {
        let units = crate::records::recognise::measurable(&self.document);
        let unit = units.into_iter().find(|(name, _)| name == quantity).map(|(_, unit)| unit);
        let independent = self.play.model().independent.name.clone();
        let Some(record) = self.record_mut(id) else { return };
        if let Some(used) = record.uses.get_mut(column) {
            let unit = match unit {
                Some(unit)
                    if unit.dimension != used.meaning.unit.dimension
                        && !used.meaning.unit.dimension.lacks_scale_for(unit.dimension) =>
                {
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

    /// Sets the unit of a column.
    ///
    /// # Errors
    /// The text is not a unit, or its dimension differs from that of the column's quantity.
    pub fn set_column_unit(&mut self, id: u32, column: usize, typed: &str) -> Result<(), Refusal> {
        let unit = Unit::parse(typed)
            .map_err(|_| play::Refusal::UnknownUnit { typed: typed.trim().chars().take(40).collect() })?;
        let known = crate::records::recognise::measurable(&self.document);
        let Some(used) = self.record_mut(id).and_then(|record| record.uses.get_mut(column)) else { return Ok(()) };
        let own = known.iter().find(|(name, _)| *name == used.meaning.quantity).map(|(_, own)| own);
        if let Some(own) = own.filter(|own| own.dimension != unit.dimension) {
            return Err(play::Refusal::WrongUnit {
                typed: typed.trim().chars().take(40).collect(),
                expected: number::unit_text(&own.text),
            }
            .into());
        }
        used.meaning.unit = unit;
        (used.chosen, used.stated) = (true, true);
        self.records_changed();
        Ok(())
    }

    /// Sets whether fits use a column.
    pub fn set_column_fitted(&mut self, id: u32, column: usize, fitted: bool) {
        if let Some(used) = self.record_mut(id).and_then(|record| record.uses.get_mut(column)) {
            used.fitted = fitted;
            self.records_changed();
        }
    }
}
