//! Records: measured data beside the model. A record belongs to no document; which of the document's quantities its
//! columns measure is recognised for each document.

use crate::records::derived::{Made, differentiation};
use crate::records::recognise::{Meaning, recognise};
use crate::undo::Removed;
use crate::words::sentence;
use crate::{Announcement, Desk, Refusal, number};
use analysis::finding::Finding;
use analysis::inspection::{Inspection, doubtful_times, inspect};
use analysis::reading::{self, Contents};
use analysis::table::Table;
use document::Document;
use program::Model;
use std::collections::BTreeMap;

/// How many records there can be.
pub const MOST_RECORDS: usize = 8;

/// The largest file, in bytes, that the laboratory reads as a record: more than a million rows. The program takes larger
/// ones.
pub const LONGEST_RECORD: usize = 64 << 20;
/// The longest text, in bytes, that a sheet of a workbook may become.
pub(crate) const LONGEST_TEXT: usize = LONGEST_RECORD;

/// Measured data.
#[derive(Clone, Debug)]
pub(crate) struct Record {
    /// Names it as long as it exists.
    pub id: u32,
    /// What it is called: its file's name.
    pub name: String,
    /// The text it was read from, for the next visit; empty where it is too long for that.
    pub text: String,
    /// What was read.
    pub table: Table,
    /// What the text hides.
    pub findings: Vec<Finding>,
    /// Columns that were computed from others: which, and from which.
    pub computed: Vec<(usize, usize)>,
    /// The last columns, which a person had made of others.
    pub made: Vec<Made>,
    /// What each column is taken for.
    pub uses: Vec<Use>,
    /// Whether it is drawn.
    pub shown: bool,
    /// Where the model begins in it, in the fit whose numbers are in the sliders.
    pub origin: Option<Origin>,
    /// Values that parameters have in this record, by name and SI, for fits of several.
    pub known: BTreeMap<String, f64>,
    /// The true values of parameters, by name and SI, if the data are simulated.
    pub truth: Option<Vec<(String, f64)>>,
}

/// Where the model begins in a record.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Origin {
    /// The reading of the record's clock, SI.
    pub reading: f64,
    /// Whether a fit has found it, so that later fits begin there too. Otherwise it is only where the fitted part began.
    pub found: bool,
}

/// What a column is taken for.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Use {
    pub meaning: Meaning,
    /// Whether a fit is to follow it.
    pub fitted: bool,
    /// The zero of its scale, SI, as a fit has found it.
    pub offset: f64,
    /// Whether a person has chosen it: then it is not recognised again.
    pub chosen: bool,
    /// Whether a person has stated the unit.
    pub stated: bool,
}

/// A record in the list.
#[derive(Clone, Debug, PartialEq)]
pub struct RecordView {
    /// Names it as long as it exists.
    pub id: u32,
    /// What it is called.
    pub name: String,
    /// How many rows it has.
    pub rows: usize,
    /// Whether it is drawn.
    pub shown: bool,
    /// Whether its data are simulated.
    pub synthetic: bool,
    /// Whether it will be there at the next visit; the longest are not.
    pub lasting: bool,
    /// Its columns.
    pub columns: Vec<ColumnView>,
    /// What the text hides, in the chosen language.
    pub findings: Vec<String>,
}

/// A column of a record.
#[derive(Clone, Debug, PartialEq)]
pub struct ColumnView {
    /// Which of the record's columns.
    pub index: usize,
    /// What the file calls it, with its unit; its number where the file calls it nothing.
    pub head: String,
    /// The quantity of the document that it measures; empty when it is not used.
    pub quantity: String,
    /// Its unit, as it can be typed; empty where it is asked for.
    pub unit: String,
    /// Where the unit comes from, in the chosen language; empty for what is not used or has no unit.
    pub unit_origin: String,
    /// Whether the file states no unit, and that of the quantity is assumed.
    pub unit_assumed: bool,
    /// Whether the file states a unit that is not known. Until a person states it the column is neither drawn nor fitted.
    pub unit_asked: bool,
    /// Whether a fit is to follow it.
    pub fitted: bool,
    /// Whether a fit can follow it: it is used and no time.
    pub fittable: bool,
    /// Whether it can be differentiated: it was read and is no time.
    pub differentiable: bool,
    /// How it was made of another column; empty for what the file holds.
    pub made: String,
}

impl Desk {
    /// The records, oldest first.
    pub fn records(&self) -> Vec<RecordView> {
        self.data.records.iter().map(|record| self.record_view(record)).collect()
    }

    /// The id of the record that came last.
    pub fn newest_record(&self) -> Option<u32> {
        self.data.records.last().map(|record| record.id)
    }

    fn record_view(&self, record: &Record) -> RecordView {
        let independent = &self.play.model().independent.name;
        let column = |(index, (column, used)): (usize, (&analysis::table::Column, &Use))| {
            let unit = column.unit.as_ref().map(|unit| number::unit_text(&unit.text)).unwrap_or_default();
            let name = if column.name.is_empty() { (index + 1).to_string() } else { column.name.clone() };
            let body = column.body.as_ref().map(|body| format!("{body}: ")).unwrap_or_default();
            let understood = self.understood(record, index);
            ColumnView {
                index,
                unit_origin: understood.origin,
                unit_assumed: understood.assumed,
                unit_asked: understood.asked,
                head: if unit.is_empty() { format!("{body}{name}") } else { format!("{body}{name} [{unit}]") },
                quantity: used.meaning.quantity.clone(),
                unit: if understood.asked { String::new() } else { number::unit_text(&used.meaning.unit.text) },
                fitted: used.fitted,
                fittable: !used.meaning.quantity.is_empty() && used.meaning.quantity != *independent,
                differentiable: index < record.read_columns()
                    && column.independent != index
                    && used.meaning.quantity != *independent,
                made: record
                    .how_made(index)
                    .map(|made| differentiation(self.play.language(), made.how))
                    .unwrap_or_default(),
            }
        };
        RecordView {
            id: record.id,
            name: record.name.clone(),
            rows: record.table.rows(),
            shown: record.shown,
            synthetic: record.truth.is_some(),
            lasting: self.is_lasting(record.id),
            columns: record.table.columns.iter().zip(&record.uses).enumerate().map(column).collect(),
            findings: record.findings.iter().map(|finding| sentence(&finding.text(self.play.language()))).collect(),
        }
    }

    /// Reads a file, text or workbook, as a record, all at once; the runs of a logger become records of their own, the first of
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
        reading::read(bytes.to_vec(), LONGEST_TEXT)
            .map_err(|error| crate::records::intake::unreadable(name, &error, self.play.language()))
    }

    /// Adds what was read as a record, or each run of a logger as one.
    pub(crate) fn take_contents(
        &mut self,
        name: &str,
        contents: Contents,
        inspection: Inspection,
    ) -> Result<u32, Refusal> {
        let runs = crate::records::runs::texts(&contents.import.table);
        if runs.is_empty() {
            return Ok(self.take_record(name, contents, inspection, None));
        }
        if self.data.records.len() + runs.len() > MOST_RECORDS {
            return Err(Refusal::TooManyRecords { most: MOST_RECORDS });
        }
        let mut first = None;
        for (run, text) in runs {
            let id = self.insert_record(&format!("{name}: {run}"), text.as_bytes(), None)?;
            first.get_or_insert(id);
        }
        first.ok_or(Refusal::unknown(name))
    }

    /// Adds what was read as a record.
    pub(crate) fn take_record(
        &mut self,
        name: &str,
        Contents { import, text }: Contents,
        inspection: Inspection,
        truth: Option<Vec<(String, f64)>>,
    ) -> u32 {
        let id = self.data.issued;
        self.data.issued += 1;
        let mut findings = import.findings;
        findings.extend(inspection.findings);
        // That a unit is assumed stands beside the column.
        let doubtful = doubtful_times(&import.table).into_iter();
        findings.extend(doubtful.filter(|finding| matches!(finding, Finding::NoTimes(_))));
        let mut record = Record {
            id,
            name: name.chars().take(80).collect(),
            // What is too long to be kept for the next visit is not needed any more.
            text: if text.len() <= crate::records::saved::LONGEST { text } else { String::new() },
            uses: Vec::new(),
            table: import.table,
            findings,
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

    /// A label in every language of the document.
    fn labels(&self, label: &str) -> Vec<String> {
        self.document
            .program
            .languages()
            .map(|language| self.document.program.text(language, label).to_lowercase())
            .collect()
    }

    /// Draws a record or not.
    pub fn show_record(&mut self, id: u32, shown: bool) {
        if let Some(record) = self.record_mut(id) {
            record.shown = shown;
            self.records_changed();
        }
    }

    /// Forgets a record.
    pub fn remove_record(&mut self, id: u32) {
        if let Some(index) = self.data.records.iter().position(|record| record.id == id) {
            let record = self.data.records.remove(index);
            let name = record.name.clone();
            self.can_undo(Removed::Record(index, Box::new(record)));
            self.records_changed();
            self.announce(Announcement::RecordRemoved(name));
        }
    }

    /// Takes the records of another desk, which had another document open.
    pub fn adopt_records(&mut self, other: &mut Desk) {
        self.data.records = std::mem::take(&mut other.data.records);
        self.data.issued = other.data.issued;
        for record in &mut self.data.records {
            record.origin = None;
            record.uses.iter_mut().for_each(|used| used.offset = 0.0);
        }
        self.fits.adopt(&mut other.fits);
        self.play.number_removals_from(other.play.removals());
        self.cycle_view = std::mem::take(&mut other.cycle_view);
        self.intake = other.intake.take();
        self.recognise_records();
    }

    /// Recognises again all columns whose quantity no person has chosen.
    pub(crate) fn recognise_records(&mut self) {
        let mut records = std::mem::take(&mut self.data.records);
        for record in &mut records {
            record.take_for(&self.document, &|label| self.labels(label));
        }
        self.data.records = records;
        self.records_changed();
    }

    pub(crate) fn record(&self, id: u32) -> Option<&Record> {
        self.data.records.iter().find(|record| record.id == id)
    }

    pub(crate) fn record_mut(&mut self, id: u32) -> Option<&mut Record> {
        self.data.records.iter_mut().find(|record| record.id == id)
    }
}

impl Use {
    /// Whether the document has the quantity.
    fn fits(&self, model: &Model) -> bool {
        self.meaning.quantity.is_empty() || crate::records::recognise::observed(model, &self.meaning.quantity).is_some()
    }
}

impl Record {
    /// Which column a column was computed from, if it was.
    pub fn computed_from(&self, column: usize) -> Option<usize> {
        self.computed.iter().find(|(computed, _)| *computed == column).map(|(_, source)| *source)
    }

    /// Takes the columns for what they seem to measure, except where a person has said what they do.
    pub fn take_for(&mut self, document: &Document, labels: &dyn Fn(&str) -> Vec<String>) {
        let model = &document.program.model;
        // What was made follows its source and takes no quantity from another column.
        let made = self.table.columns.split_off(self.read_columns());
        let mut meanings = recognise(&self.table, document, labels);
        self.table.columns.extend(made);
        // A fit follows the first column that was not computed from another one.
        let independent = |(column, meaning): (usize, &Meaning)| {
            !meaning.quantity.is_empty()
                && meaning.quantity != model.independent.name
                && self.computed_from(column).is_none()
        };
        let independent = meanings.iter().enumerate().position(independent);
        meanings.resize_with(self.table.columns.len(), Meaning::nothing);
        let fresh = meanings.into_iter().enumerate().map(|(column, meaning)| match self.uses.get(column) {
            Some(used) if used.chosen && used.fits(model) => used.clone(),
            _ => Use { meaning, fitted: Some(column) == independent, offset: 0.0, chosen: false, stated: false },
        });
        self.uses = fresh.collect();
        self.settle_made(document);
    }
}
