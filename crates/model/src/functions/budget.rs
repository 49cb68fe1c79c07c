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
    /// Whether one more part may be written out.
    pub fn take(&mut self) -> bool {
        let left = self.0 > 0;
        self.0 = self.0.saturating_sub(1);
        left
    }
}
