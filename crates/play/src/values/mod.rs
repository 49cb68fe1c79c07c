//! Formatted numbers: readouts, values of the scene, table of rows.

pub(crate) mod lines;
mod members;
mod outline;
pub(crate) mod readout;
mod scene;
pub(crate) mod symbol;
mod table;
pub(crate) mod trails;

pub(crate) use members::Lines;
pub use members::{Index, Members, ReadoutKind};
pub use outline::{Follows, Outline};
pub use readout::Readout;
pub use symbol::symbol;
