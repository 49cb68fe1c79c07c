//! Units of columns that state none, decided once for all theories of a ranking.

use crate::fits::ShownFits;
use crate::records::recognise::observed;
use crate::records::record::Record;
use crate::{Refusal, number, words};
use analysis::assumed_unit::{AssumedUnit, Expectation, assumed_unit, is_same};
use document::Document;
use units::Unit;

/// Unit of a column: id of the record, index of the column, unit.
pub(super) type ColumnUnit = (u32, usize, Unit);

impl<'a> ShownFits<'a> {
    /// Units in which all `theories` read the fitted columns of the records that take part, for columns whose units are
    /// assumed.
    ///
    /// # Errors
    /// A question for a unit: the theories declare different units that the numbers do not decide between, or another one
    /// than that in which the column is drawn.
    pub(super) fn shared_units(self, theories: &[(String, Document)]) -> Result<Vec<ColumnUnit>, Refusal> {
        let mut found = Vec::new();
        for record in self.taking_part().into_iter().filter_map(|id| self.records.get(id)) {
            let mut columns: Vec<(usize, Vec<Expectation>)> = Vec::new();
            for (_, document) in theories {
                let mut read = record.clone();
                read.take_for(document);
                for column in (0..read.uses().len()).filter(|column| read.uses()[*column].fitted) {
                    if !record.assumes_unit(read.uses(), column) {
                        continue;
                    }
                    let Some(expected) = read.expectation(document, read.uses(), column) else { continue };
                    match columns.iter_mut().find(|(known, _)| *known == column) {
                        Some((_, expectations)) => expectations.push(expected),
                        None => columns.push((column, vec![expected])),
                    }
                }
            }
            for (column, expectations) in columns {
                let present = self.present_unit(record, column);
                match assumed_unit(present, &expectations) {
                    Some(AssumedUnit::Unit(unit)) if present.is_none_or(|present| is_same(present, &unit)) => {
                        found.push((record.id(), column, unit));
                    }
                    Some(AssumedUnit::Unit(unit)) => {
                        return Err(self.asked(record, column, &[present.cloned().unwrap_or(unit.clone()), unit]));
                    }
                    Some(AssumedUnit::Open(units)) => return Err(self.asked(record, column, &units)),
                    None => {}
                }
            }
        }
        Ok(found)
    }

    /// Unit in which the open document reads a column; `None` if it does not use it.
    fn present_unit(self, record: &Record, column: usize) -> Option<&'a Unit> {
        let used = self.records.get(record.id())?.uses().get(column)?;
        observed(self.play.model(), &used.meaning.quantity).map(|_| &used.meaning.unit)
    }

    fn asked(self, record: &Record, column: usize, units: &[Unit]) -> Refusal {
        let language = self.play.basis().language();
        let name = record.table().label(column);
        let units: Vec<String> = units.iter().map(|unit| number::unit_text(&unit.text)).collect();
        Refusal::Fit { why: words::unit_asked(language, record.name(), &name, &language.join(&units)) }
    }
}
