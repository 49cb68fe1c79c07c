//! Import of a file as a record: reading and inspection in slices, so that the page stays responsive.

use crate::records::incoming::{Intake, Stage};
use crate::records::record::{LONGEST_SAVED, LONGEST_TEXT, Record};
use crate::records::{Records, ShownRecords, runs};
use crate::{Announcement, Changes, LONGEST_RECORD, MOST_RECORDS, OpenDocument, Refusal};
use analysis::finding::Finding;
use analysis::import::DateOrder;
use analysis::inspection::{Inspection, Inspector, doubtful_times, inspect};
use analysis::reading::{self, Contents, Reading, ReadingError};
use analysis::tracker::{Gathering, Project};
use std::collections::{BTreeMap, BTreeSet};
use units::{Language, sentence};

/// Progress of the import of a file.
#[derive(Clone, Debug, PartialEq)]
pub struct RecordProgress {
    /// Name of the file.
    pub name: String,
    /// Fraction that has been read, from 0 to 1.
    pub part: f64,
}

/// A record that was read from a file.
#[derive(Debug)]
pub(crate) struct AddedRecord {
    pub id: u32,
    /// The Tracker project of the file.
    pub project: Option<Box<Project>>,
}

impl ShownRecords<'_> {
    /// Progress of the file that is being read, `None` if there is none.
    pub fn progress(self) -> Option<RecordProgress> {
        let Intake { name, stage } = self.records.intake.as_ref()?;
        let part = match stage {
            Stage::Reading(reading) => 0.9 * reading.progress(),
            Stage::Inspecting(..) => 0.95,
            Stage::Known(..) => 0.99,
        };
        Some(RecordProgress { name: name.clone(), part })
    }

    /// True if the file has been read and inspected, and the next call of [`crate::Desk::advance_record`] adds its record.
    pub fn is_read(self) -> bool {
        self.records.intake.as_ref().is_some_and(|intake| matches!(intake.stage, Stage::Known(..)))
    }
}

impl Records {
    /// Starts to read a file, text or workbook, as a record. [`crate::Desk::advance_record`] continues. Cancels the file that
    /// is being read. `dates`: order of day and month in dates, where a person stated it.
    ///
    /// # Errors
    /// The file is too large, the workbook cannot be read, or the maximum number of records is reached.
    pub fn begin(
        &mut self,
        open: OpenDocument<'_>,
        name: &str,
        bytes: Vec<u8>,
        dates: Option<DateOrder>,
    ) -> Result<Changes, Refusal> {
        self.intake = None;
        if self.list.len() >= MOST_RECORDS {
            return Err(Refusal::TooManyRecords { most: MOST_RECORDS });
        }
        if bytes.len() > LONGEST_RECORD {
            return Err(Refusal::RecordTooLong { most: LONGEST_RECORD >> 20 });
        }
        let reading = Reading::new(bytes, LONGEST_TEXT).map_err(|error| unreadable(name, &error, open.language()))?;
        let stage = Stage::Reading(Box::new(reading.with_dates(dates)));
        self.intake = Some(Intake { name: name.to_owned(), stage });
        Ok(Changes::NONE)
    }

    /// Starts to read a Tracker project in an archive that was read only in part, as [`Records::begin`]. Returns
    /// false if it contains no project.
    ///
    /// # Errors
    /// The maximum number of records is reached.
    pub fn begin_project(&mut self, name: &str, gathering: Gathering) -> Result<(bool, Changes), Refusal> {
        self.intake = None;
        if self.list.len() >= MOST_RECORDS {
            return Err(Refusal::TooManyRecords { most: MOST_RECORDS });
        }
        let reading = Reading::of_gathered(gathering, LONGEST_TEXT);
        self.intake = reading.map(|reading| Intake { name: name.to_owned(), stage: Stage::Reading(Box::new(reading)) });
        Ok((self.intake.is_some(), Changes::NONE))
    }

    /// Continues to read for about `budget` bytes. Returns the record once it is complete; `None` before, and if no file
    /// is being read.
    ///
    /// # Errors
    /// The file is not a table. Reading has then ended.
    pub(crate) fn advance(
        &mut self,
        open: OpenDocument<'_>,
        budget: usize,
    ) -> Result<(Option<AddedRecord>, Changes), Refusal> {
        let Some(Intake { name, stage }) = self.intake.take() else { return Ok((None, Changes::NONE)) };
        let stage = match stage {
            Stage::Reading(mut reading) => {
                let finished = reading.advance(budget).map_err(|error| unreadable(&name, &error, open.language()))?;
                if !finished {
                    Stage::Reading(reading)
                } else if let Some(contents) = reading.finish() {
                    let inspector = Inspector::new(&contents.import.table);
                    Stage::Inspecting(Box::new(contents), Box::new(inspector))
                } else {
                    return Ok((None, Changes::NONE));
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
                let (added, changes) = self.take_contents(open, &name, *contents, *inspection)?;
                return Ok((Some(added), changes));
            }
        };
        self.intake = Some(Intake { name, stage });
        Ok((None, Changes::NONE))
    }

    /// Reads a file, text or workbook, as a record in one call. Each run of a logger and each data set becomes a record
    /// of its own; the first is returned. No record changes if the file cannot be read.
    ///
    /// # Errors
    /// The file is too large or not a table, or the maximum number of records is reached.
    pub(crate) fn add(
        &mut self,
        open: OpenDocument<'_>,
        name: &str,
        bytes: &[u8],
    ) -> Result<(AddedRecord, Changes), Refusal> {
        let contents = self.read(open, name, bytes)?;
        let inspection = inspect(&contents.import.table);
        self.take_contents(open, name, contents, inspection)
    }

    /// Reads a file as one record. `truth`: true values of the parameters, SI, if the data are simulated.
    pub(crate) fn insert(
        &mut self,
        open: OpenDocument<'_>,
        name: &str,
        bytes: &[u8],
        truth: Option<Vec<(String, f64)>>,
    ) -> Result<(u32, Changes), Refusal> {
        let contents = self.read(open, name, bytes)?;
        let inspection = inspect(&contents.import.table);
        Ok(self.take(open, name, contents, inspection, truth))
    }

    fn read(&self, open: OpenDocument<'_>, name: &str, bytes: &[u8]) -> Result<Contents, Refusal> {
        if self.list.len() >= MOST_RECORDS {
            return Err(Refusal::TooManyRecords { most: MOST_RECORDS });
        }
        if bytes.len() > LONGEST_RECORD {
            return Err(Refusal::RecordTooLong { most: LONGEST_RECORD >> 20 });
        }
        reading::read(bytes.to_vec(), LONGEST_TEXT).map_err(|error| unreadable(name, &error, open.language()))
    }

    /// Adds the contents of a file as one record, or as one record per run of a logger or data set.
    fn take_contents(
        &mut self,
        open: OpenDocument<'_>,
        name: &str,
        mut contents: Contents,
        inspection: Inspection,
    ) -> Result<(AddedRecord, Changes), Refusal> {
        let runs = runs::texts(&contents.import.table);
        if runs.is_empty() {
            let project = contents.project.take();
            let (id, changes) = self.take(open, name, contents, inspection, None);
            return Ok((AddedRecord { id, project }, changes));
        }
        if self.list.len() + runs.len() > MOST_RECORDS {
            return Err(Refusal::TooManyRecords { most: MOST_RECORDS });
        }
        let (mut first, mut all, before) = (None, Changes::NONE, self.list.len());
        let remarks: Vec<Finding> =
            contents.import.findings.into_iter().filter(|finding| matches!(finding, Finding::DataSets(_))).collect();
        for (run, text) in runs {
            let inserted = self.insert(open, &format!("{name}: {run}"), text.as_bytes(), None);
            let (id, changes) = inserted.inspect_err(|_| self.list.truncate(before))?;
            all = all | changes;
            if let Some(record) = self.list.last_mut() {
                let own = |finding: &&Finding| matches!(finding, Finding::DataSets(remark) if remark.is_about(&run));
                let own: Vec<Finding> = remarks.iter().filter(own).cloned().collect();
                record.said.splice(0..0, own.iter().cloned());
                record.findings.splice(0..0, own);
            }
            first.get_or_insert(id);
        }
        let id = first.ok_or(Refusal::unknown(name))?;
        Ok((AddedRecord { id, project: None }, all))
    }

    /// Adds the contents of a file as one record.
    fn take(
        &mut self,
        open: OpenDocument<'_>,
        name: &str,
        Contents { import, text, .. }: Contents,
        inspection: Inspection,
        truth: Option<Vec<(String, f64)>>,
    ) -> (u32, Changes) {
        let id = self.issued;
        self.issued += 1;
        let mut findings = import.findings;
        let said = findings.clone();
        findings.extend(inspection.findings);
        // The assumption of a unit is not a finding here: it is shown beside the column.
        let doubtful = doubtful_times(&import.table).into_iter();
        findings.extend(doubtful.filter(|finding| matches!(finding, Finding::NoTimes(_))));
        let mut record = Record {
            id,
            name: name.chars().take(80).collect(),
            // Longer texts are not stored for the next visit, so they are not kept.
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
            excluded: BTreeSet::new(),
            known: BTreeMap::new(),
            truth,
        };
        record.take_for(open.document);
        let name = record.name.clone();
        self.list.push(record);
        (id, Changes::RECORDS.announcing(Announcement::RecordAdded(name)))
    }

    /// Cancels the file `name` that is being read, also while the browser still fetches its bytes.
    pub fn cancel(&mut self, name: &str) -> Changes {
        self.intake = None;
        Changes::NONE.announcing(Announcement::RecordCancelled(name.to_owned()))
    }
}

fn unreadable(name: &str, error: &ReadingError, language: Language) -> Refusal {
    let asks_dates = error.is_of_dates();
    let hint = match asks_dates {
        true => language.say("choose the order of day and month, or write the dates as 2026-01-02"),
        false => error.hint(language),
    };
    Refusal::UnreadableRecord {
        name: name.to_owned(),
        why: format!("{} {}", sentence(&error.message(language)), sentence(hint)),
        asks_dates,
    }
}
