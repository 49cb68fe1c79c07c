//! Limit for the expansion of functions: a short text can expand to a very long one.

use crate::limits;

/// Number of nodes that may still be written.
#[derive(Debug)]
pub(crate) struct Budget(usize);

impl Default for Budget {
    fn default() -> Self {
        Self(limits::WRITTEN_OUT)
    }
}

impl Budget {
    /// Budget for all expressions of a document outside its model together, including repeated parts.
    pub fn of_document() -> Self {
        Self(limits::WRITTEN_OUT_IN_DOCUMENT)
    }

    /// Takes one node from the budget. Returns false if none is left.
    pub fn take(&mut self) -> bool {
        let left = self.0 > 0;
        self.0 = self.0.saturating_sub(1);
        left
    }
}
