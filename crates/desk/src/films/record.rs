//! Record of a film. It is an ordinary record, and is replaced in place when the work on the film changes.

use crate::Refusal;
use crate::films::work::Work;
use crate::films::{FilmIdentity, Films, ShownFilms, no_film, refused};
use crate::records::Records;
use analysis::csv::{self, Dialect};
use film::table::Table;
use play::Play;

/// Results of a fit that remain valid for the new record.
#[must_use]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Kept {
    /// Time origin of the model.
    pub(crate) origin: bool,
    /// Offsets of the columns.
    pub(crate) offsets: bool,
}

/// Text that the record of the open film is to have.
#[derive(Debug)]
pub(crate) struct FilmRecord {
    /// Id of the record that is replaced; `None` for a new one.
    pub record: Option<u32>,
    /// Name of a new record.
    pub name: String,
    /// Table as CSV.
    pub text: String,
}

impl Films {
    /// Text that the record of the open film is to have; `None` if there is nothing to write. A record that the user has
    /// removed is written only if `made`.
    pub(crate) fn record_to_write(
        &self,
        play: &Play,
        records: &Records,
        made: bool,
    ) -> Result<Option<FilmRecord>, Refusal> {
        let (_, work) = self.current().ok_or_else(|| no_film(play))?;
        let record = work.record.filter(|id| records.get(*id).is_some());
        if record.is_none() && work.record.is_some() && !made {
            return Ok(None);
        }
        Ok(text(work).map(|text| FilmRecord { record, name: work.identity.name.clone(), text }))
    }

    /// Sets the record of the open film.
    pub(crate) fn set_record(&mut self, record: u32) {
        if let Some((_, work)) = self.current_mut() {
            work.record = Some(record);
        }
    }

    /// Id of the record of the open film.
    ///
    /// # Errors
    ///
    /// [`Refusal::Film`] without a record.
    pub(crate) fn record_made(&self, play: &Play, records: &Records) -> Result<u32, Refusal> {
        let work = self.current().map(|(_, work)| work);
        let record = work.and_then(|work| work.record).filter(|id| records.get(*id).is_some());
        record.ok_or_else(|| refused(play, &super::plan::nothing_followed()))
    }
}

impl<'a> ShownFilms<'a> {
    /// Identity of the film of a record.
    pub fn of_record(self, id: u32) -> Option<&'a FilmIdentity> {
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
