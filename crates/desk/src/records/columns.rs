//! Columns of a record: text of their cells, and the user's choice of quantity, unit and use in fits.

use crate::records::recognise::{Meaning, measurable};
use crate::records::{Records, ShownRecords};
use crate::{Announcement, Changes, OpenDocument, Refusal, number};

impl ShownRecords<'_> {
    /// Text of some cells of a record's column, to 6 significant digits; empty for gaps and rows that do not exist.
    pub fn cells(self, id: u32, column: usize, rows: std::ops::Range<usize>) -> Vec<String> {
        let values =
            self.records.get(id).and_then(|record| record.table.columns.get(column)).map(|column| &column.values);
        let rows = values.and_then(|values| values.get(rows.start..rows.end.min(values.len()))).unwrap_or_default();
        let cell = |value: &f64| {
            if value.is_nan() { String::new() } else { number::plain(*value, 6, self.open.play.basis().style()) }
        };
        rows.iter().map(cell).collect()
    }

    /// Quantities of the document that a column can measure: name and symbol.
    pub fn measurable(self) -> Vec<(String, String)> {
        measurable(self.open.document).into_iter().map(|(name, _)| (name.clone(), play::symbol(&name))).collect()
    }
}

impl Records {
    /// Sets the quantity that a column measures; an empty name sets none. The unit is kept if its dimension fits.
    pub fn set_quantity(&mut self, open: OpenDocument<'_>, id: u32, column: usize, quantity: &str) -> Changes {
        let units = measurable(open.document);
        let unit = units.into_iter().find(|(name, _)| name == quantity).map(|(_, unit)| unit);
        let independent = &open.play.model().independent.name;
        let Some(record) = self.get_mut(id) else { return Changes::NONE };
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
            used.fitted &= !quantity.is_empty() && quantity != *independent;
            used.chosen = true;
        }
        Changes::RECORDS
    }

    /// Sets the unit of a column.
    ///
    /// # Errors
    /// The text is not a unit, or its dimension differs from that of the column's quantity.
    pub fn set_unit(
        &mut self,
        open: OpenDocument<'_>,
        id: u32,
        column: usize,
        typed: &str,
    ) -> Result<Changes, Refusal> {
        let known = measurable(open.document);
        let used = self.get_mut(id).and_then(|record| record.uses.get_mut(column));
        let Some(used) = used else { return Ok(Changes::NONE) };
        let own = known.iter().find(|(name, _)| *name == used.meaning.quantity).map(|(_, own)| own);
        let unit = number::typed::unit(typed, own).map_err(play::Refusal::from)?;
        used.meaning.unit = unit;
        (used.chosen, used.stated) = (true, true);
        Ok(Changes::RECORDS)
    }

    /// Leaves a row of a record out of fits, or takes it back. It is drawn in any case.
    pub fn exclude(&mut self, id: u32, row: usize, excluded: bool) -> Changes {
        let Some(record) = self.get_mut(id).filter(|record| row < record.table.rows()) else { return Changes::NONE };
        let changed = if excluded { record.excluded.insert(row) } else { record.excluded.remove(&row) };
        if !changed {
            return Changes::NONE;
        }
        let (record, row) = (record.name.clone(), row + 1);
        Changes::RECORDS.announcing(Announcement::RowLeftOut { record, row, counts: !excluded })
    }

    /// Leaves a row of a record out of fits if it counts, and takes it back if it does not.
    pub fn exclude_or_include(&mut self, id: u32, row: usize) -> Changes {
        let counts = self.get(id).is_some_and(|record| !record.excluded.contains(&row));
        self.exclude(id, row, counts)
    }

    /// Takes back all rows of a record that are left out of fits.
    pub fn include_all(&mut self, id: u32) -> Changes {
        let Some(record) = self.get_mut(id) else { return Changes::NONE };
        Changes::RECORDS.only_if(!std::mem::take(&mut record.excluded).is_empty())
    }

    /// Sets whether fits use a column.
    pub fn set_fitted(&mut self, id: u32, column: usize, fitted: bool) -> Changes {
        let used = self.get_mut(id).and_then(|record| record.uses.get_mut(column));
        let Some(used) = used else { return Changes::NONE };
        used.fitted = fitted;
        Changes::RECORDS
    }
}
