//! What was removed last.

use crate::fits::fit::Fitted;
use crate::records::record::Record;

/// What the last removal took away, with its place in its list.
#[derive(Debug)]
pub(crate) enum Removed {
    Record(usize, Box<Record>),
    Fit(usize, Box<Fitted>),
}
