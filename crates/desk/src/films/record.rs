//! Record of a film. It is an ordinary record, and is replaced in place when the work on the film changes.

use crate::films::work::Work;
use crate::records::record::LONGEST_SAVED;
use crate::{Desk, Refusal};
use analysis::csv::{self, Dialect};
use analysis::inspection::inspect;
use analysis::reading;
use film::table::Table;

/// Results of a fit that remain valid for the new record.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Kept {
    /// Time origin of the model.
    pub origin: bool,
    /// Offsets of the columns.
    pub offsets: bool,
}

impl Desk {
    /// Makes a record of the open film if it has tracks and no record, for instance after its removal.
    ///
    /// # Errors
    ///
    /// [`Refusal::Film`] without tracks, and a refusal if there is no room for another record.
    pub fn film_to_record(&mut self) -> Result<u32, Refusal> {
        self.write_film_record(true, Kept { origin: true, offsets: true })?;
        let work = self.films.current().map(|(_, work)| work);
        let record = work.and_then(|work| work.record).filter(|id| self.record(*id).is_some());
        record.ok_or_else(|| self.film_refusal(&super::plan::nothing_followed()))
    }

    /// Updates the record of the open film.
    pub(crate) fn film_changed(&mut self, kept: Kept) -> Result<(), Refusal> {
        self.revision.films += 1;
        self.write_film_record(false, kept)
    }

    /// Writes the record. A record that the user has removed is written only if `made`.
    fn write_film_record(&mut self, made: bool, kept: Kept) -> Result<(), Refusal> {
        let Some((open, work)) = self.films.current() else { return Err(self.no_film()) };
        let (place, removed) = (open.work, work.record.is_some_and(|id| self.record(id).is_none()));
        if removed && !made {
            return Ok(());
        }
        let Some(text) = text(work) else { return Ok(()) };
        let name = work.identity.name.clone();
        match work.record.filter(|_| !removed) {
            Some(id) => self.replace_record(id, &text, kept),
            None => {
                let id = self.insert_record(&name, text.as_bytes(), None)?;
                if let Some(work) = self.films.works.get_mut(place) {
                    work.record = Some(id);
                }
                Ok(())
            }
        }
    }

    /// Replaces the text of a record. The user's meanings of the columns are kept, except units where the text states
    /// one.
    fn replace_record(&mut self, id: u32, text: &str, kept: Kept) -> Result<(), Refusal> {
        let why = |error: reading::ReadingError| error.message(self.play.language());
        let contents = reading::read(text.as_bytes().to_vec(), crate::LONGEST_RECORD)
            .map_err(|error| Refusal::Film { why: why(error) })?;
        let (inspection, table) = (inspect(&contents.import.table), contents.import.table);
        let Some(index) = self.data.records.iter().position(|record| record.id == id) else { return Ok(()) };
        let mut record = self.data.records.remove(index);
        let made: Vec<_> = record.differentiated().collect();
        let same = record.read_columns() == table.columns.len()
            && record.table.columns.iter().zip(&table.columns).all(|(one, other)| one.name == other.name);
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
        record.take_for(&self.document, &|label| self.labels(label));
        record.uses.iter_mut().zip(offsets).for_each(|(used, offset)| used.offset = offset);
        record.restore_made(made.into_iter().filter(|_| same), &self.document);
        self.data.records.insert(index, record);
        self.records_changed();
        Ok(())
    }

    /// Identity of the film of a record.
    pub fn film_of_record(&self, id: u32) -> Option<&crate::FilmIdentity> {
        self.films.of_record(id).map(|work| &work.identity)
    }
}

/// Table of a film as CSV. `None` for fewer than two rows, as after the first click by hand.
pub(crate) fn text(work: &Work) -> Option<String> {
    let table = table(work).filter(|table| table.frames.len() > 1)?;
    let columns = table.columns();
    let (heads, values): (Vec<&str>, Vec<&[f64]>) =
        columns.iter().map(|(head, values)| (head.as_str(), *values)).unzip();
    Some(csv::write_film(&heads, &values, work.calibration.relative_sigma(), Dialect::Commas))
}

/// Table of the record; `None` if it is empty.
pub(crate) fn table(work: &Work) -> Option<Table> {
    let table = Table::of(&work.tracks(), &work.calibration, &|frame| work.taken(frame).unwrap_or(f64::NAN));
    (!table.frames.is_empty()).then_some(table)
}
