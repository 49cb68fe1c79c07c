//! The list of records: showing, hiding, removing, and transfer to another open document.

use crate::records::derived::differentiation;
use crate::records::record::{Record, Use};
use crate::records::understood::understood;
use crate::records::variable::VariableView;
use crate::records::{Records, ShownRecords};
use crate::removed::Removed;
use crate::{Announcement, Changes, number};
use document::Document;
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
    /// Number of rows that are left out of fits.
    pub excluded: usize,
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

impl ShownRecords<'_> {
    /// The records, oldest first.
    pub fn list(self) -> Vec<RecordView> {
        self.records.list.iter().map(|record| self.record_view(record)).collect()
    }

    /// True if there are none.
    pub fn is_empty(self) -> bool {
        self.records.list.is_empty()
    }

    /// Id of the latest record.
    pub fn newest(self) -> Option<u32> {
        self.records.list.last().map(|record| record.id)
    }

    fn record_view(self, record: &Record) -> RecordView {
        let independent = &self.open.play.model().independent.name;
        let labels = record.table.labels();
        let column = |(index, (column, used)): (usize, (&analysis::table::Column, &Use))| {
            let unit = column.unit.as_ref().map(|unit| number::unit_text(&unit.text)).unwrap_or_default();
            let number = record.table.number(index).to_string();
            // Columns of one name and unit are told apart by their numbers.
            let apart = labels.get(index).filter(|label| label.ends_with(&format!(" #{number}")));
            let name = match apart {
                Some(_) => format!("{} #{number}", column.name),
                None if column.name.is_empty() => number,
                None => column.name.clone(),
            };
            let body = column.body.as_ref().map(|body| format!("{body}: ")).unwrap_or_default();
            let understood = understood(self.open.play, record, index);
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
                    .map(|made| differentiation(self.open.play.basis().language(), made.how))
                    .unwrap_or_default(),
            }
        };
        RecordView {
            id: record.id,
            name: record.name.clone(),
            rows: record.table.rows(),
            shown: record.shown,
            excluded: record.excluded.len(),
            synthetic: record.truth.is_some(),
            lasting: self.records.is_lasting(record.id),
            variables: record.variables(self.open.play.basis().language()),
            columns: record.table.columns.iter().zip(&record.uses).enumerate().map(column).collect(),
            findings: record
                .findings
                .iter()
                .map(|finding| sentence(&finding.text(self.open.play.basis().language())))
                .collect(),
        }
    }
}

impl Records {
    /// Shows or hides a record.
    pub fn show(&mut self, id: u32, shown: bool) -> Changes {
        let Some(record) = self.get_mut(id) else { return Changes::NONE };
        record.shown = shown;
        Changes::RECORDS
    }

    /// Removes a record.
    pub fn remove(&mut self, id: u32) -> Changes {
        let Some(index) = self.list.iter().position(|record| record.id == id) else { return Changes::NONE };
        let record = self.list.remove(index);
        let name = record.name.clone();
        let removed = Removed::Record(index, Box::new(record));
        Changes::RECORDS.removing(removed).announcing(Announcement::RecordRemoved(name))
    }

    /// Puts a removed record back, at most at the end of the list.
    pub(crate) fn put_back(&mut self, place: usize, record: Record) -> Changes {
        self.list.insert(place.min(self.list.len()), record);
        Changes::RECORDS
    }

    /// Takes the records, and the file that is being read, from a desk with another document.
    pub(crate) fn adopt(&mut self, other: &mut Self, document: &Document) -> Changes {
        *self = std::mem::take(other);
        // Ids of the other desk stay issued.
        other.issued = self.issued;
        for record in &mut self.list {
            record.origin = None;
            record.uses.iter_mut().for_each(|used| used.offset = 0.0);
        }
        self.recognise(document)
    }

    /// Determines the meaning of all columns again, except those set by the user.
    pub(crate) fn recognise(&mut self, document: &Document) -> Changes {
        self.list.iter_mut().for_each(|record| record.take_for(document));
        Changes::RECORDS
    }

    /// Names the derivatives of all records and sets their units. Needed when meanings of columns have changed.
    pub(crate) fn settle(&mut self, document: &Document) {
        self.list.iter_mut().for_each(|record| record.settle_made(document));
    }
}
