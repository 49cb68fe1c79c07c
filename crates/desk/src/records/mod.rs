//! Measured data: reading of files, meaning of columns, derived columns.

mod assumed;
mod columns;
mod derived;
mod incoming;
mod intake;
mod list;
pub(crate) mod measurement;
pub(crate) mod recognise;
pub(crate) mod record;
mod replacing;
mod runs;
mod sample;
pub(crate) mod series;
mod stored;
pub(crate) mod understood;
mod variable;

pub use intake::RecordProgress;
pub use list::{ColumnView, RecordView};
pub use measurement::{MEASUREMENT_FIELDS, MeasurementForm, measurement_units};
pub use record::{LONGEST_RECORD, LONGEST_SAVED, MOST_RECORDS};
pub use sample::{SAMPLES, Sample};
pub use variable::VariableView;

pub(crate) use intake::AddedRecord;
pub(crate) use stored::{line, take_uses, write_uses};

use crate::OpenDocument;
use incoming::Intake;
use record::Record;

/// The records of a desk, and the file that is being read.
#[derive(Debug, Default)]
pub struct Records {
    /// Oldest first.
    list: Vec<Record>,
    /// Number of ids issued so far. Ids are never reused, because fits refer to records by id.
    issued: u32,
    /// The file that is being read.
    intake: Option<Intake>,
}

/// The records as the open document understands them.
#[derive(Clone, Copy, Debug)]
pub struct ShownRecords<'a> {
    records: &'a Records,
    open: OpenDocument<'a>,
}

impl Records {
    /// The records as the open document understands them.
    pub(crate) fn shown<'a>(&'a self, open: OpenDocument<'a>) -> ShownRecords<'a> {
        ShownRecords { records: self, open }
    }

    /// All records, oldest first.
    pub(crate) fn all(&self) -> &[Record] {
        &self.list
    }

    /// The record of this id.
    pub(crate) fn get(&self, id: u32) -> Option<&Record> {
        self.list.iter().find(|record| record.id == id)
    }

    fn get_mut(&mut self, id: u32) -> Option<&mut Record> {
        self.list.iter_mut().find(|record| record.id == id)
    }
}

impl<'a> ShownRecords<'a> {
    /// The records themselves.
    pub(crate) fn records(self) -> &'a Records {
        self.records
    }

    /// Clock reading at which the model begins in a record, SI; 0 without the record.
    pub(crate) fn origin(self, id: u32) -> f64 {
        let model = self.open.play.model();
        self.records.get(id).map_or(0.0, |record| record.origin(&model.independent, model.is_autonomous()))
    }
}
