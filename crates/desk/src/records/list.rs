//! The list of records: showing, hiding, removing, and transfer to another open document.

use crate::records::derived::differentiation;
use crate::records::record::{Record, Use};
use crate::records::variable::VariableView;
use crate::removed::Removed;
use crate::{Announcement, Desk, number};
use units::sentence;

/// A record in the list.
#[derive(Clone, Debug, PartialEq)]
pub struct RecordView {
    /// Id of the record, never reused.
    pub id: u32,
    /// Name of the record.
    pub name: String,
    /// Number of rows.
    pub rows: usize,
    /// True if the record is drawn.
    pub shown: bool,
    /// True if its data are simulated.
    pub synthetic: bool,
    /// True if it is stored for the next visit. The longest records are not.
    pub lasting: bool,
    /// Columns of the record.
    pub columns: Vec<ColumnView>,
    /// Findings about the text and the data, in the chosen language.
    pub findings: Vec<String>,
    /// Possible choices of the independent variable.
    pub variables: Vec<VariableView>,
}

/// A column of a record.
#[derive(Clone, Debug, PartialEq)]
pub struct ColumnView {
    /// Index of the column in the record.
    pub index: usize,
    /// Name in the file with its unit; the number of the column if it has no name.
    pub head: String,
    /// Quantity of the document that it measures; empty if it is not used.
    pub quantity: String,
    /// Unit in a form that can be typed; empty if the user must state it.
    pub unit: String,
    /// Origin of the unit, in the chosen language; empty if the column is not used or has no unit.
    pub unit_origin: String,
    /// True if the file states no unit and the unit of the quantity is assumed.
    pub unit_assumed: bool,
    /// True if the user must state the unit, because the file states an unknown one or a film has no scale. Until then
    /// the column is neither drawn nor fitted.
    pub unit_asked: bool,
    /// True if fits use the column.
    pub fitted: bool,
    /// True if a fit can use it: it measures a quantity other than the independent variable.
    pub fittable: bool,
    /// True if it can be differentiated: it is from the file and not the independent variable.
    pub differentiable: bool,
    /// Method by which a derivative was computed; empty for a column of the file.
    pub made: String,
}

impl Desk {
    /// The records, oldest first.
    pub fn records(&self) -> Vec<RecordView> {
        self.data.records.iter().map(|record| self.record_view(record)).collect()
    }

    /// Id of the latest record.
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

    /// A label in every language of the document, in lower case.
    pub(crate) fn labels(&self, label: &str) -> Vec<String> {
        self.document
            .program
            .languages()
            .map(|language| self.document.program.text(language, label).to_lowercase())
            .collect()
    }

    /// Shows or hides a record.
    pub fn show_record(&mut self, id: u32, shown: bool) {
        if let Some(record) = self.record_mut(id) {
            record.shown = shown;
            self.records_changed();
        }
    }

    /// Removes a record.
    pub fn remove_record(&mut self, id: u32) {
        if let Some(index) = self.data.records.iter().position(|record| record.id == id) {
            let record = self.data.records.remove(index);
            let name = record.name.clone();
            self.can_undo(Removed::Record(index, Box::new(record)));
            self.records_changed();
            self.announce(Announcement::RecordRemoved(name));
        }
    }

    /// Takes the records, fits and films of another desk, which had another document open.
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

    /// Determines the meaning of all columns again, except those set by the user.
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
