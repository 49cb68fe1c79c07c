//! State of reading a file as a record.

use analysis::inspection::{Inspection, Inspector};
use analysis::reading::{Contents, Reading};

/// A file that is being read.
#[derive(Debug)]
pub(crate) struct Intake {
    pub name: String,
    pub stage: Stage,
}

/// Stage of the import of a file.
#[derive(Debug)]
pub(crate) enum Stage {
    Reading(Box<Reading>),
    Inspecting(Box<Contents>, Box<Inspector>),
    /// Fully read and inspected. Adding the record is a separate stage because it takes as long as a slice.
    Known(Box<Contents>, Box<Inspection>),
}
