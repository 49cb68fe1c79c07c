//! Changes of a record that follow from other work: a new text of its film, results of a fit, values typed for a fit.

use crate::films::Kept;
use crate::records::Records;
use crate::records::record::{LONGEST_SAVED, Origin};
use crate::{Changes, LONGEST_RECORD, OpenDocument, Refusal, number};
use analysis::finding::Finding;
use analysis::inspection::inspect;
use analysis::reading;
use program::Parameter;

impl Records {
    /// Replaces the text of a record. The user's meanings of the columns are kept, except units where the text states
    /// one.
    pub(crate) fn replace(
        &mut self,
        open: OpenDocument<'_>,
        id: u32,
        text: &str,
        kept: Kept,
    ) -> Result<Changes, Refusal> {
        let why = |error: reading::ReadingError| error.message(open.language());
        let contents = reading::read(text.as_bytes().to_vec(), LONGEST_RECORD)
            .map_err(|error| Refusal::Film { why: why(error) })?;
        let (inspection, table) = (inspect(&contents.import.table), contents.import.table);
        let Some(record) = self.get_mut(id) else { return Ok(Changes::NONE) };
        let made: Vec<_> = record.differentiated().collect();
        let same = record.read_columns() == table.columns.len()
            && record.table.columns.iter().zip(&table.columns).all(|(one, other)| one.name == other.name);
        record.excluded.retain(|row| same && *row < table.rows());
        record.uses.truncate(if same { table.columns.len() } else { 0 });
        for (used, column) in record.uses.iter_mut().zip(&table.columns) {
            if let Some(unit) = &column.unit {
                (used.meaning.unit, used.stated) = (unit.clone(), false);
            }
            used.offset = if kept.offsets { used.offset } else { 0.0 };
        }
        let offsets: Vec<f64> = record.uses.iter().map(|used| used.offset).collect();
        (record.said, record.settled) = (contents.import.findings.clone(), false);
        record.findings = contents.import.findings.into_iter().chain(inspection.findings).collect();
        record.computed = inspection.derived.iter().map(|derived| (derived.column, derived.of)).collect();
        record.text = if contents.text.len() <= LONGEST_SAVED { contents.text } else { String::new() };
        record.origin = record.origin.filter(|_| kept.origin);
        (record.made, record.table) = (Vec::new(), table);
        record.take_for(open.document);
        record.uses.iter_mut().zip(offsets).for_each(|(used, offset)| used.offset = offset);
        record.restore_made(made.into_iter().filter(|_| same), open.document);
        Ok(Changes::RECORDS)
    }

    /// Puts findings before those of a record.
    pub(crate) fn add_findings(&mut self, id: u32, findings: Vec<Finding>) {
        if let Some(record) = self.get_mut(id) {
            record.findings.splice(0..0, findings);
        }
    }

    /// Sets the beginning of the model in a record, and the zeros of the scales of its fitted columns, by name of their
    /// quantities, SI. `shown`: true if the record is drawn, `None` to leave that as it is.
    pub(crate) fn take_zeros(
        &mut self,
        id: u32,
        origin: Option<Origin>,
        offsets: &[(String, f64)],
        shown: Option<bool>,
    ) -> Changes {
        let Some(record) = self.get_mut(id) else { return Changes::NONE };
        record.origin = origin;
        for used in &mut record.uses {
            let offset = offsets.iter().find(|(name, _)| used.fitted && *name == used.meaning.quantity);
            used.offset = offset.map_or(0.0, |(_, offset)| *offset);
        }
        record.shown = shown.unwrap_or(record.shown);
        Changes::RECORDS
    }

    /// Text of the value of a parameter in a record, in the unit of the parameter. Shows the value of the slider if none
    /// was typed.
    pub(crate) fn known_text(&self, open: OpenDocument<'_>, id: u32, index: usize) -> String {
        let Some(parameter) = open.play.model().parameters.get(index) else { return String::new() };
        let slider = open.play.course().parameters().get(index).copied().unwrap_or(parameter.value);
        let value = self.get(id).and_then(|record| record.known.get(&parameter.name).copied()).unwrap_or(slider);
        number::plain(parameter.unit.from_si(value), play::DIGITS, open.play.basis().style())
    }

    /// Sets the value of a parameter in one record from typed text. Empty text restores the value of the slider.
    ///
    /// # Errors
    /// The text is not a number, has the wrong unit, or lies outside the range of the parameter.
    pub fn set_known(
        &mut self,
        open: OpenDocument<'_>,
        index: usize,
        id: u32,
        typed: &str,
    ) -> Result<Changes, Refusal> {
        let unknown = || Refusal::unknown(index);
        let parameter = open.play.model().parameters.get(index).filter(|own| own.is_shown()).ok_or_else(unknown)?;
        let Parameter { name, unit, .. } = parameter;
        let (basis, shown) = (open.play.basis(), self.known_text(open, id, index));
        let value = match typed.trim() {
            "" => None,
            typed => match basis.read_field(open.play.course(), typed, &shown, unit)? {
                Some(value) => Some(basis.admit(index, value)?),
                None => return Ok(Changes::NONE),
            },
        };
        if let Some(record) = self.get_mut(id) {
            match value {
                Some(value) => record.known.insert(name.clone(), value),
                None => record.known.remove(name),
            };
        }
        Ok(Changes::FITS)
    }
}
