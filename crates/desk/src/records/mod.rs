//! Measured data: reading of files, meaning of columns, derived columns.

mod columns;
mod derived;
pub(crate) mod incoming;
mod intake;
mod list;
pub(crate) mod measurement;
pub(crate) mod recognise;
pub(crate) mod record;
mod runs;
mod sample;
pub(crate) mod understood;
mod variable;

pub use intake::RecordProgress;
pub use list::{ColumnView, RecordView};
pub use measurement::{MEASUREMENT_FIELDS, MeasurementForm};
pub use record::{LONGEST_RECORD, MOST_RECORDS};
pub use sample::{SAMPLES, Sample};
pub use variable::VariableView;
