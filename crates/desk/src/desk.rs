//! The laboratory without a screen: a simulation, measured records and fits. What stands here is the wiring: which parts
//! an operation changes, and what follows for the others.
//!
//! `Desk` owns a `Play`, the `Document` and parts, one per folder: `Records` (`records`), `MeasuredData` (`measured`),
//! `Cycles`, `Films`, `Fits`, `Writing` and `Sketching` (`writing`). A part has private fields and holds no handle on the
//! desk. Its operations get what they read as parameters, mostly an `OpenDocument` (document and simulation) or a `FitData`
//! (that, records and films), and return `Changes`: the parts changed, events to announce, and a removal that can be undone.
//!
//! - `Desk::note` is the only place that folds `Changes`: changed records are drawn again and their cycles found again, then
//!   come the counters of `Revision`, the announcements and the removal.
//! - A change on which nothing else depends goes straight to its part:
//!   `desk.change_records(|records, open| records.set_unit(open, ..))`, likewise `change_cycles`, `change_films` and
//!   `change_fits`. The closure gets one part for changes, and the compiler keeps it from the others.
//! - What involves several parts is a method of `Desk`: `work_on_film` lets the record of the film follow, `apply_fit` sets
//!   zeros in records and values on the sliders, `replace_document` moves everything to another program, `adopt` takes the
//!   work over from another desk.
//! - Readers get a part with what it is shown with: `desk.records()`, `cycles()`, `films()` and `fits()` return
//!   `ShownRecords`, `ShownCycles`, `ShownFilms` and `ShownFits`, which are read only.
//! - Functions over several parts that change nothing by themselves stand outside of `Desk` and use its readers:
//!   `workbook.rs`, `storing`.
//! - `Desk::follow` brings residuals, the plot of the cycles and the outline up to the run. Call it before drawing. Removals
//!   are numbered over desk and play together (`Play::number_removal`), so that `Desk::undo` takes back the last one of both.
//!
//! Measured data and cycles are drawn into plots and the scene of the simulation, so their operations that draw get
//! `&mut Play`; its changes go into the revision of the simulation.

use crate::announcement::{Announcement, Announcements};
use crate::changes::{Changes, Revision};
use crate::cycles::{Cycles, ShownCycles};
use crate::films::{self, FilmOpening, Films, Kept, ProjectFilm, ShownFilms, Tracked};
use crate::fits::{FitData, Fits, InProcess, ShownFits, Workers};
use crate::measured::MeasuredData;
use crate::opened::{OpenDocument, OpenedDocuments};
use crate::records::{AddedRecord, Records, ShownRecords};
use crate::removed::Removed;
use crate::sizes::{resized, with_present_sizes};
use crate::writing::{DrawingPlaces, Sketching, Writing};
use crate::{FilmIdentity, Refusal};
use document::Document;
use play::{Outcome, Play, PlotId};
use saved::Item;
use saved::format::Content;

/// A laboratory with one document open.
#[derive(Debug)]
pub struct Desk {
    play: Play,
    /// The document of the simulation. Reports and stored fits need its text.
    document: Document,
    revision: Revision,
    announcements: Announcements,
    records: Records,
    measured: MeasuredData,
    cycles: Cycles,
    films: Films,
    fits: Fits,
    /// Computes fits where no other workers are given.
    here: InProcess,
    writing: Writing,
    sketching: Sketching,
    /// The last removal and its number.
    removed: Option<(u32, Removed)>,
}

impl Desk {
    /// Opens a document. The first row is drawn and the run is paused at time 0.
    pub fn open(document: Document) -> Self {
        let mut play = Play::open(document.program.clone());
        let (measured, cycles) = (
            MeasuredData::new(play.change_plots(|plots, _| plots.add())),
            Cycles::new(play.change_plots(|plots, _| plots.add())),
        );
        let mut desk = Self {
            play,
            revision: Revision::default(),
            announcements: Announcements::default(),
            records: Records::default(),
            measured,
            cycles,
            films: Films::default(),
            fits: Fits::default(),
            here: InProcess::default(),
            writing: Writing::default(),
            sketching: Sketching::default(),
            removed: None,
            document,
        };
        desk.fits.vary_as_stated(&desk.document.program);
        desk.note(Changes::RECORDS);
        desk
    }

    /// Folds changes into the revision, and updates the parts that follow from what has changed.
    fn note(&mut self, mut changes: Changes) {
        if changes.touch(&Changes::RECORDS) {
            self.records.settle(&self.document);
            self.measured.renew(&mut self.play, &self.document, &self.records);
        }
        if changes.touch(&(Changes::RECORDS | Changes::CYCLES)) {
            self.cycles.find(&self.play, &self.records);
        }
        if changes.touch(&(Changes::RECORDS | Changes::CYCLES | Changes::CYCLE_PLOT)) {
            self.cycles.draw(&mut self.play);
        }
        self.revision = self.revision.after(&changes);
        let (announcements, removed) = changes.take_events();
        announcements.into_iter().for_each(|announcement| self.announcements.push(announcement));
        if let Some(removed) = removed {
            self.removed = Some((self.play.number_removal(), removed));
        }
    }

    /// Notes the changes of an operation. Returns its value for the caller.
    fn noted<O: Outcome<Changes>>(&mut self, outcome: O) -> O::Value {
        let (changes, value) = outcome.split();
        self.note(changes);
        value
    }

    /// Updates residuals, cycles and the outline to the present state of the run. Must be called before plots are drawn.
    pub fn follow(&mut self) {
        if let Some(time) = self.play.change_run(|line, _| line.take_rewritten()) {
            self.measured.truncate_residuals(&mut self.play, time);
        }
        self.measured.follow_residuals(&mut self.play);
        self.cycles.follow(&mut self.play);
        self.measured.follow_outline(&mut self.play);
    }

    /// Counters of changes.
    pub fn revision(&self) -> Revision {
        Revision { play: self.play.revision(), ..self.revision }
    }

    /// Takes the next announcement. Announcements of the simulation come first.
    pub fn take_announcement(&mut self) -> Option<Announcement> {
        let of_play = self.play.take_announcement().map(Announcement::Play);
        of_play.or_else(|| self.announcements.take())
    }

    /// Number of the removal that [`Desk::undo`] would undo; `None` if there is nothing to undo.
    pub fn undo_number(&self) -> Option<u32> {
        let own = self.removed.as_ref().map(|(number, _)| *number);
        self.play.removals().number().or(own.filter(|number| *number == self.play.removals().count()))
    }

    /// Undoes the removal of this number, here or in the simulation. Only the last removal can be undone; returns true if
    /// it was this one.
    pub fn undo(&mut self, number: u32) -> bool {
        if self.undo_number() != Some(number) {
            return false;
        }
        if self.play.removals().number() == Some(number) {
            return self.play.undo(number);
        }
        let Some((_, removed)) = self.removed.take() else { return false };
        let changes = match removed {
            Removed::Record(place, record) => self.records.put_back(place, *record),
            Removed::Fit(place, fit) => self.fits.put_back(place, *fit),
        };
        self.note(changes.announcing(Announcement::Play(play::Announcement::Undone)));
        true
    }

    // The simulation and its document.

    /// The simulation.
    #[must_use]
    pub fn play(&self) -> &Play {
        &self.play
    }

    /// The simulation, for changes. Call [`Desk::follow`] afterwards to update measured data.
    pub fn play_mut(&mut self) -> &mut Play {
        &mut self.play
    }

    /// The document.
    pub fn document(&self) -> &Document {
        &self.document
    }

    fn open_document(&self) -> OpenDocument<'_> {
        OpenDocument { play: &self.play, document: &self.document }
    }

    /// Sets the language of all texts from a language tag. Any tag is accepted.
    pub fn set_language(&mut self, language: &str) {
        self.play.set_language(language);
        self.measured.begin_outline(&mut self.play, &self.document);
        self.label_plots();
    }

    fn label_plots(&mut self) {
        self.measured.label_residuals(&mut self.play);
        self.cycles.label(&mut self.play);
    }

    /// Rebuilds the model with other sizes of families, given by name. Parameters, plots, the time and measured data
    /// stay as described in [`play::Play::replace_program`]. The text of the document does not change.
    ///
    /// # Errors
    /// A size is outside its range, or the model has errors with it, for example because it is too large.
    pub fn resize(&mut self, sizes: &[(&str, u32)]) -> Result<(), Refusal> {
        self.document = resized(self.open_document(), sizes)?;
        self.play.resize(self.document.program.clone());
        // Members of families now have other indices among states and quantities.
        let changes = self.records.recognise(&self.document);
        self.note(changes);
        Ok(())
    }

    // The texts in the editor.

    /// The texts in the editor.
    pub fn writing(&self) -> &Writing {
        &self.writing
    }

    /// Sets the texts in the editor: the running ones, or an earlier edit of them.
    pub fn set_writing(&mut self, writing: Writing) {
        self.writing = writing;
    }

    /// Replaces the text of one file. If the texts give a program, it replaces the running one as described in
    /// [`play::Play::replace_program`]: time, parameters, plots and measured data stay. If they have more errors than
    /// the running texts, only the findings change. Returns true if the program was replaced.
    pub fn write(&mut self, file: usize, text: String) -> bool {
        let document = self.writing.change(file, text);
        document.map(|document| self.replace_document(document)).is_some()
    }

    /// Replaces all texts at once, as [`Desk::write`] does for one, for example with those of an earlier visit.
    pub fn write_all(&mut self, texts: Vec<String>) -> bool {
        let document = self.writing.change_all(texts);
        document.map(|document| self.replace_document(document)).is_some()
    }

    /// Replaces the open document while the simulation runs.
    fn replace_document(&mut self, document: Document) {
        let document = with_present_sizes(&self.document.program, document);
        let changes = self.fits.replace_program(&self.document.program, &document.program);
        self.play.replace_program(document.program.clone());
        // The added plots follow those of the document, whose number may have changed.
        let own = document.program.plots.len();
        self.measured.move_plot(PlotId::at(own));
        self.cycles.move_plot(PlotId::at(own + 1));
        self.document = document;
        let changes = changes | self.records.recognise(&self.document);
        self.note(changes);
        self.label_plots();
    }

    /// Positions of the drawing and its elements at the shown time. `None` if the text in the editor is not the running
    /// one, or has no drawing.
    pub fn drawing_places(&mut self) -> Option<DrawingPlaces> {
        let runs = !self.writing.has_begun() || self.writing.runs();
        if runs { self.sketching.places(&self.document.source, &self.play) } else { None }
    }

    // Records, and the cycles of their columns.

    /// The records.
    pub fn records(&self) -> ShownRecords<'_> {
        self.records.shown(self.open_document())
    }

    /// Changes the records. Everything that shows measured values follows.
    pub fn change_records<O: Outcome<Changes>>(
        &mut self,
        change: impl FnOnce(&mut Records, OpenDocument<'_>) -> O,
    ) -> O::Value {
        let outcome = change(&mut self.records, OpenDocument { play: &self.play, document: &self.document });
        self.noted(outcome)
    }

    /// Leaves the row of a measured value out of fits, or takes it back. `column`: number of its column among all that are
    /// drawn; `place`: index of the value, as in [`play::Points`].
    pub fn leave_out(&mut self, column: usize, place: usize) {
        if let Some((id, row)) = self.measured.row_of(&self.records, self.play.model(), column, place) {
            self.change_records(|records, _| records.exclude_or_include(id, row));
        }
    }

    /// Reads a file, text or workbook, as a record in one call. Each run of a logger and each data set becomes a record
    /// of its own; the id of the first is returned. No record changes if the file cannot be read.
    ///
    /// # Errors
    /// The file is too large or not a table, or the maximum number of records is reached.
    pub fn add_record(&mut self, name: &str, bytes: &[u8]) -> Result<u32, Refusal> {
        let added = self.change_records(|records, open| records.add(open, name, bytes))?;
        Ok(self.keep_project(added))
    }

    /// Continues to read for about `budget` bytes. Returns the id of the record once it is complete; `None` before, and
    /// if no file is being read.
    ///
    /// # Errors
    /// The file is not a table. Reading has then ended.
    pub fn advance_record(&mut self, budget: usize) -> Result<Option<u32>, Refusal> {
        let added = self.change_records(|records, open| records.advance(open, budget))?;
        Ok(added.map(|added| self.keep_project(added)))
    }

    /// Keeps the film of a record that was read from a project, until it is taken. Returns the id of the record.
    fn keep_project(&mut self, AddedRecord { id, project }: AddedRecord) -> u32 {
        self.films.keep_project(project.and_then(|project| ProjectFilm::new(id, project)));
        id
    }

    /// Takes the records, fits and films of another desk, which had another document open.
    pub fn adopt(&mut self, other: &mut Self) {
        self.fits.adopt(&mut other.fits);
        self.play.number_removals_from(other.play.removals().count());
        self.films = std::mem::take(&mut other.films);
        let changes = self.cycles.adopt(&mut other.cycles) | self.records.adopt(&mut other.records, &self.document);
        self.note(changes);
    }

    /// Restores a stored record, the work on a film, or a fit, and returns its name in the storage. Films need their
    /// records, and fits need both. `None` if it cannot be read, lacks its records, or is there already.
    pub fn restore_item(&mut self, item: &Item) -> Option<String> {
        match &item.0 {
            Content::Record(saved) => {
                let name = self.change_records(|records, open| records.restore(open, saved));
                self.announcements.clear();
                while self.play.take_announcement().is_some() {}
                name
            }
            Content::Film(saved) => {
                let (name, work) = crate::storing::film(saved, &self.records)?;
                self.change_films(|films, _| films.restore(work)).then_some(name)
            }
            Content::Fit(saved) => self.change_fits(|fits, data| fits.restore(data, saved)),
            Content::Answer(_) => None,
        }
    }

    /// Measured columns beside the model.
    pub fn measured(&self) -> &MeasuredData {
        &self.measured
    }

    /// The cycles of a column.
    pub fn cycles(&self) -> ShownCycles<'_> {
        self.cycles.shown(self.open_document(), &self.records)
    }

    /// Changes the view of the cycles.
    pub fn change_cycles(&mut self, change: impl FnOnce(&mut Cycles) -> Changes) {
        let changes = change(&mut self.cycles);
        self.note(changes);
    }

    // Films.

    /// The open film, and the work on all films.
    pub fn films(&self) -> ShownFilms<'_> {
        self.films.shown(self.open_document(), &self.records)
    }

    /// Changes films in a way that leaves the record of the open film as it is.
    pub fn change_films<O: Outcome<Changes>>(&mut self, change: impl FnOnce(&mut Films, &Play) -> O) -> O::Value {
        let outcome = change(&mut self.films, &self.play);
        self.noted(outcome)
    }

    /// Changes the work on the open film. The record of the film follows if `change` returns what of it remains valid.
    ///
    /// # Errors
    /// [`Refusal::Film`] with nothing changed, or no room for the record; the work is changed then.
    pub fn work_on_film(
        &mut self,
        change: impl FnOnce(&mut Films, &Play) -> Result<Option<Kept>, Refusal>,
    ) -> Result<(), Refusal> {
        let kept = change(&mut self.films, &self.play)?;
        self.note(Changes::FILMS);
        let written = kept.map_or(Ok(Changes::NONE), |kept| self.write_film_record(false, kept));
        self.noted(written)
    }

    /// Writes the record of the open film. A record that the user has removed is written only if `made`.
    fn write_film_record(&mut self, made: bool, kept: Kept) -> Result<Changes, Refusal> {
        let written = self.films.record_to_write(&self.play, &self.records, made)?;
        let open = OpenDocument { play: &self.play, document: &self.document };
        let Some(films::FilmRecord { record, name, text }) = written else { return Ok(Changes::NONE) };
        if let Some(id) = record {
            return self.records.replace(open, id, &text, kept);
        }
        let (id, changes) = self.records.insert(open, &name, text.as_bytes(), None)?;
        self.films.set_record(id);
        Ok(changes)
    }

    /// Makes a record of the open film if it has tracks and no record, for instance after its removal.
    ///
    /// # Errors
    /// [`Refusal::Film`] without tracks, and a refusal if there is no room for another record.
    pub fn film_to_record(&mut self) -> Result<u32, Refusal> {
        let written = self.write_film_record(true, Kept { origin: true, offsets: true });
        self.noted(written)?;
        self.films.record_made(&self.play, &self.records)
    }

    /// Continues the tracking by `steps` steps of less than 1 ms each; ten are a good number. Returns true once the
    /// tracking is finished and the record made. Does nothing while a frame is requested.
    ///
    /// # Errors
    /// [`Refusal::Film`] if the film cannot be tracked, and a refusal if there is no room for another record; the tracks
    /// are kept then.
    pub fn advance_tracking(&mut self, steps: usize) -> Result<bool, Refusal> {
        match self.change_films(|films, play| films.advance_tracking(play, steps))? {
            Tracked::NotYet => Ok(false),
            Tracked::Known => Ok(true),
            Tracked::Found(kept) => {
                let written = self.write_film_record(false, kept)?;
                self.note(written.announcing(Announcement::FilmTracked(self.films().losses())));
                Ok(true)
            }
        }
    }

    /// Opens the film of a project in place of the open one, with positions, scale and used part of the project. The
    /// record of the project gets the times of the film. If the film is known, its stored work is continued instead.
    ///
    /// # Errors
    /// As [`Films::open`], and [`Refusal::Film`] if the project has features that are not supported. No film is open
    /// then, and the record of the project is unchanged.
    pub fn open_project_film(
        &mut self,
        own: &ProjectFilm,
        identity: FilmIdentity,
        container: film::containers::Film,
    ) -> Result<FilmOpening, Refusal> {
        let opening = self.change_films(|films, play| films.open(play, identity, container))?;
        if opening != FilmOpening::TakenUp
            && let Err(refusal) = self.take_project(own)
        {
            self.change_films(|films, _| films.close());
            return Err(refusal);
        }
        Ok(opening)
    }

    fn take_project(&mut self, own: &ProjectFilm) -> Result<(), Refusal> {
        let times = self.films.take_project(&self.play, own)?;
        let remarks = films::remarks(self.records.get(own.record()), times);
        let written = self.write_film_record(false, Kept { origin: false, offsets: false })?;
        self.records.add_findings(own.record(), remarks);
        self.note(Changes::FILMS | written);
        Ok(())
    }

    /// Positions of the model in frames of the open film, px of the upright picture, by the quantities that the columns of
    /// this track measure. `None` if the run has not reached the time, without a record, or if no column measures a
    /// quantity of the model.
    pub fn film_model(&mut self, track: usize, frames: &[usize]) -> Vec<Option<[f64; 2]>> {
        self.films.model(&mut self.play, &self.document, &self.records, track, frames)
    }

    // Fits.

    /// The fits.
    pub fn fits(&self) -> ShownFits<'_> {
        self.fits.shown(FitData { open: self.open_document(), records: &self.records, films: &self.films })
    }

    /// Changes settings, queue or results of fits.
    pub fn change_fits<O: Outcome<Changes>>(&mut self, change: impl FnOnce(&mut Fits, FitData<'_>) -> O) -> O::Value {
        let open = OpenDocument { play: &self.play, document: &self.document };
        let outcome = change(&mut self.fits, FitData { open, records: &self.records, films: &self.films });
        self.noted(outcome)
    }

    /// Chooses a record. If it belongs to the applied fit of several records, its own fitted values are set on the
    /// sliders.
    pub fn choose_record(&mut self, id: u32) {
        if let Some(fit) = self.change_fits(|fits, _| fits.choose(id)) {
            self.apply_fit(fit);
        }
    }

    /// Sets the fitted values on the sliders and runs the simulation to the end of the record. With several records, it
    /// uses the chosen one, else the first, and shows only that one, because the curve belongs to it.
    pub fn apply_fit(&mut self, id: u32) {
        let Some(mut applied) = self.fits().application(id) else { return };
        let mut changes = Changes::RECORDS;
        for one in &applied.records {
            changes = changes | self.records.take_zeros(one.id, one.origin, &one.offsets, one.shown);
        }
        self.note(changes);
        let begins = self.records().origin(applied.shown.0);
        self.play.change_run(|line, basis| {
            line.run_through(basis, std::mem::take(&mut applied.parameters), applied.last - begins)
        });
        self.change_fits(|fits, _| fits.set_applied(applied));
    }

    /// Gives the workers what they can do, and takes what they have found. Returns true if there is more work.
    pub fn advance_fits(&mut self, workers: &mut dyn Workers) -> bool {
        self.change_fits(|fits, data| fits.take_news(data, workers));
        let mut last = None;
        while let Some(settled) = self.change_fits(Fits::settle_next) {
            if let Some(id) = settled.applied {
                self.apply_fit(id);
            }
            last = settled.doubt.or(last);
        }
        self.change_fits(|fits, data| fits.hand_out_again(data, workers, last))
    }

    /// Computes one trial here. Returns true if there is more work.
    pub fn advance_fit(&mut self) -> bool {
        let mut here = std::mem::take(&mut self.here);
        let has_more = self.advance_fits(&mut here);
        self.here = here;
        has_more
    }

    /// Exchanges the documents from which fits are reconstructed for others, so that several desks can share them one
    /// after the other.
    pub fn exchange_documents(&mut self, documents: &mut OpenedDocuments) {
        self.fits.exchange_documents(documents);
    }
}
