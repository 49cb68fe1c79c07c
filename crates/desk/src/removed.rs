//! The last removal, for undo.

use crate::fits::fit::Fitted;
use crate::records::record::Record;

/// A removed item with its index in its list.
#[derive(Debug)]
pub(crate) enum Removed {
    Record(usize, Box<Record>),
    Fit(usize, Box<Fitted>),
}
