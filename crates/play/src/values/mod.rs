//! Numbers for people: readouts, the scene's values, the table of rows.

mod outline;
pub(crate) mod readout;
mod scene;
pub(crate) mod symbol;
mod table;
pub(crate) mod trails;

pub use outline::{Follows, Outline};
pub use readout::{Readout, ReadoutKind};
pub use symbol::symbol;
