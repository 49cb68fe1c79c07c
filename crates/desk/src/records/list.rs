//! The records in a list: shown, hidden, removed, and taken over where another document is opened.

use crate::records::derived::differentiation;
use crate::records::record::{Record, Use};
use crate::records::variable::VariableView;
use crate::removed::Removed;
use crate::{Announcement, Desk, number};
use units::sentence;

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
    /// The choices of the independent variable.
    pub variables: Vec<VariableView>,
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
            let name =
                if column.name.is_empty() { record.table.number(index).to_string() } else { column.name.clone() };
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
            variables: record.variables(self.play.language()),
            columns: record.table.columns.iter().zip(&record.uses).enumerate().map(column).collect(),
            findings: record.findings.iter().map(|finding| sentence(&finding.text(self.play.language()))).collect(),
        }
    }

    /// A label in every language of the document.
    pub(crate) fn labels(&self, label: &str) -> Vec<String> {
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
        self.films = std::mem::take(&mut other.films);
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
