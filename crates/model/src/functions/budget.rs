//! How much may be written out: a short text can ask for very much.

use crate::limits;

/// How many parts may still be written out.
#[derive(Debug)]
pub(crate) struct Budget(usize);

impl Default for Budget {
    fn default() -> Self {
        Self(limits::WRITTEN_OUT)
    }
}

impl Budget {
    /// That of all expressions of a document outside its model together, such as those of the copies of a part.
    pub fn of_document() -> Self {
        Self(limits::WRITTEN_OUT_IN_DOCUMENT)
    }

    /// Whether one more part may be written out.
    pub fn take(&mut self) -> bool {
        let left = self.0 > 0;
        self.0 = self.0.saturating_sub(1);
        left
    }
}
