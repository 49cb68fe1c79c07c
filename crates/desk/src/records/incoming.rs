//! A file on its way to become a record, as far as it has been read.

use analysis::inspection::{Inspection, Inspector};
use analysis::reading::{Contents, Reading};

/// A file that is being read.
#[derive(Debug)]
pub(crate) struct Intake {
    pub name: String,
    pub stage: Stage,
}

/// How far it is.
#[derive(Debug)]
pub(crate) enum Stage {
    Reading(Box<Reading>),
    Inspecting(Box<Contents>, Box<Inspector>),
    /// All is known. That the record comes among the others takes as long as a slice.
    Known(Box<Contents>, Box<Inspection>),
}
