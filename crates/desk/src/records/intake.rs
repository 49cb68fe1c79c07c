//! A file on its way to become a record: read and inspected in slices, so that the page never stands still.

use crate::films::ProjectFilm;
use crate::records::incoming::{Intake, Stage};
use crate::records::record::{LONGEST_SAVED, LONGEST_TEXT, Record};
use crate::records::runs;
use crate::{Announcement, Desk, LONGEST_RECORD, MOST_RECORDS, Refusal};
use analysis::finding::Finding;
use analysis::inspection::{Inspection, Inspector, doubtful_times, inspect};
use analysis::reading::{self, Contents, Reading, ReadingError};
use analysis::tracker::Gathering;
use std::collections::BTreeMap;
use units::Language;
use units::sentence;

/// How far a file has been read.
#[derive(Clone, Debug, PartialEq)]
pub struct RecordProgress {
    /// What it is called.
    pub name: String,
    /// The part that has been read, from 0 to 1.
    pub part: f64,
}

impl Desk {
    /// Begins to read a file, text or workbook, as a record; [`Desk::advance_record`] goes on. A file that was being read
    /// is given up.
    ///
    /// # Errors
    /// A file that is too large, or a workbook that cannot be read, and a record too many.
    pub fn begin_record(&mut self, name: &str, bytes: Vec<u8>) -> Result<(), Refusal> {
        self.intake = None;
        if self.data.records.len() >= MOST_RECORDS {
            return Err(Refusal::TooManyRecords { most: MOST_RECORDS });
        }
        if bytes.len() > LONGEST_RECORD {
            return Err(Refusal::RecordTooLong { most: LONGEST_RECORD >> 20 });
        }
        let reading =
            Reading::new(bytes, LONGEST_TEXT).map_err(|error| unreadable(name, &error, self.play.language()))?;
        self.intake = Some(Intake { name: name.to_owned(), stage: Stage::Reading(Box::new(reading)) });
        Ok(())
    }

    /// Begins to read the project of Tracker in an archive of which only some bytes were read, as [`Desk::begin_record`]. False where
    /// it holds none: it may be something else.
    ///
    /// # Errors
    /// A record too many.
    pub fn begin_project(&mut self, name: &str, gathering: Gathering) -> Result<bool, Refusal> {
        self.intake = None;
        if self.data.records.len() >= MOST_RECORDS {
            return Err(Refusal::TooManyRecords { most: MOST_RECORDS });
        }
        let reading = Reading::of_gathered(gathering, LONGEST_TEXT);
        self.intake = reading.map(|reading| Intake { name: name.to_owned(), stage: Stage::Reading(Box::new(reading)) });
        Ok(self.intake.is_some())
    }

    /// Reads on for about `budget` bytes. The id of the record, once it is there; `None` also where nothing is being read.
    ///
    /// # Errors
    /// When the file is no table. Nothing is being read then.
    pub fn advance_record(&mut self, budget: usize) -> Result<Option<u32>, Refusal> {
        let Some(Intake { name, stage }) = self.intake.take() else { return Ok(None) };
        let stage = match stage {
            Stage::Reading(mut reading) => {
                let finished =
                    reading.advance(budget).map_err(|error| unreadable(&name, &error, self.play.language()))?;
                if !finished {
                    Stage::Reading(reading)
                } else if let Some(contents) = reading.finish() {
                    let inspector = Inspector::new(&contents.import.table);
                    Stage::Inspecting(Box::new(contents), Box::new(inspector))
                } else {
                    return Ok(None);
                }
            }
            Stage::Inspecting(contents, mut inspector) => {
                if inspector.advance(&contents.import.table) {
                    Stage::Known(contents, Box::new(inspector.finish()))
                } else {
                    Stage::Inspecting(contents, inspector)
                }
            }
            Stage::Known(contents, inspection) => {
                return self.take_contents(&name, *contents, *inspection).map(Some);
            }
        };
        self.intake = Some(Intake { name, stage });
        Ok(None)
    }

    /// Reads a file, text or workbook, as a record, all at once; the runs of a logger and data sets become records of their own, the first of
    /// which is the answer. Nothing is lost when it cannot be read.
    ///
    /// # Errors
    /// A file that is too large or no table, and a record too many.
    pub fn add_record(&mut self, name: &str, bytes: &[u8]) -> Result<u32, Refusal> {
        let contents = self.read_record(name, bytes)?;
        let inspection = inspect(&contents.import.table);
        self.take_contents(name, contents, inspection)
    }

    pub(crate) fn insert_record(
        &mut self,
        name: &str,
        bytes: &[u8],
        truth: Option<Vec<(String, f64)>>,
    ) -> Result<u32, Refusal> {
        let contents = self.read_record(name, bytes)?;
        let inspection = inspect(&contents.import.table);
        Ok(self.take_record(name, contents, inspection, truth))
    }

    fn read_record(&self, name: &str, bytes: &[u8]) -> Result<Contents, Refusal> {
        if self.data.records.len() >= MOST_RECORDS {
            return Err(Refusal::TooManyRecords { most: MOST_RECORDS });
        }
        if bytes.len() > LONGEST_RECORD {
            return Err(Refusal::RecordTooLong { most: LONGEST_RECORD >> 20 });
        }
        reading::read(bytes.to_vec(), LONGEST_TEXT).map_err(|error| unreadable(name, &error, self.play.language()))
    }

    /// Adds what was read as a record, or each run of a logger or data set as one.
    pub(crate) fn take_contents(
        &mut self,
        name: &str,
        mut contents: Contents,
        inspection: Inspection,
    ) -> Result<u32, Refusal> {
        let runs = runs::texts(&contents.import.table);
        if runs.is_empty() {
            let project = contents.project.take();
            let id = self.take_record(name, contents, inspection, None);
            self.films.project = project.and_then(|project| ProjectFilm::new(id, project));
            return Ok(id);
        }
        if self.data.records.len() + runs.len() > MOST_RECORDS {
            return Err(Refusal::TooManyRecords { most: MOST_RECORDS });
        }
        let mut first = None;
        let remarks: Vec<Finding> =
            contents.import.findings.into_iter().filter(|finding| matches!(finding, Finding::DataSets(_))).collect();
        for (run, text) in runs {
            let id = self.insert_record(&format!("{name}: {run}"), text.as_bytes(), None)?;
            if let Some(record) = self.data.records.last_mut() {
                let own = |finding: &&Finding| matches!(finding, Finding::DataSets(remark) if remark.is_about(&run));
                let own: Vec<Finding> = remarks.iter().filter(own).cloned().collect();
                record.said.splice(0..0, own.iter().cloned());
                record.findings.splice(0..0, own);
            }
            first.get_or_insert(id);
        }
        first.ok_or(Refusal::unknown(name))
    }

    /// Adds what was read as a record.
    pub(crate) fn take_record(
        &mut self,
        name: &str,
        Contents { import, text, .. }: Contents,
        inspection: Inspection,
        truth: Option<Vec<(String, f64)>>,
    ) -> u32 {
        let id = self.data.issued;
        self.data.issued += 1;
        let mut findings = import.findings;
        let said = findings.clone();
        findings.extend(inspection.findings);
        // That a unit is assumed stands beside the column.
        let doubtful = doubtful_times(&import.table).into_iter();
        findings.extend(doubtful.filter(|finding| matches!(finding, Finding::NoTimes(_))));
        let mut record = Record {
            id,
            name: name.chars().take(80).collect(),
            // What is too long to be kept for the next visit is not needed any more.
            text: if text.len() <= LONGEST_SAVED { text } else { String::new() },
            uses: Vec::new(),
            table: import.table,
            findings,
            said,
            against: Vec::new(),
            settled: false,
            readings: Vec::new(),
            computed: inspection.derived.iter().map(|derived| (derived.column, derived.of)).collect(),
            made: Vec::new(),
            shown: true,
            origin: None,
            known: BTreeMap::new(),
            truth,
        };
        record.take_for(&self.document, &|label| self.labels(label));
        let name = record.name.clone();
        self.data.records.push(record);
        self.records_changed();
        self.announce(Announcement::RecordAdded(name));
        id
    }

    /// How far the file has been read that is being read.
    pub fn record_progress(&self) -> Option<RecordProgress> {
        let Intake { name, stage } = self.intake.as_ref()?;
        let part = match stage {
            Stage::Reading(reading) => 0.9 * reading.progress(),
            Stage::Inspecting(..) => 0.95,
            Stage::Known(..) => 0.99,
        };
        Some(RecordProgress { name: name.clone(), part })
    }

    /// Gives up the file that is being read.
    pub fn cancel_record(&mut self) {
        if let Some(Intake { name, .. }) = self.intake.take() {
            self.announce(Announcement::RecordCancelled(name));
        }
    }
}

fn unreadable(name: &str, error: &ReadingError, language: Language) -> Refusal {
    Refusal::UnreadableRecord {
        name: name.to_owned(),
        why: format!("{} {}", sentence(&error.message(language)), sentence(error.hint(language))),
    }
}
