//! Texts shared by the cells of a workbook.

use super::refusal::WorkbookError;

/// Upper bound of all texts together, in bytes. A measurement has only a header and some remarks.
const MOST_TEXT: usize = 32 << 20;

/// Concatenated texts, with the end of each.
#[derive(Debug, Default)]
pub(super) struct Texts {
    text: String,
    ends: Vec<u32>,
}

impl Texts {
    /// Text by its index, from 0.
    pub fn get(&self, index: usize) -> Option<&str> {
        let start = match index.checked_sub(1) {
            Some(before) => *self.ends.get(before)?,
            None => 0,
        };
        self.text.get(start as usize..*self.ends.get(index)? as usize)
    }

    /// Number of complete texts.
    pub fn len(&self) -> usize {
        self.ends.len()
    }

    /// Buffer for the text being read, after the complete ones.
    pub fn open(&mut self) -> &mut String {
        &mut self.text
    }

    /// Completes the text being read.
    pub fn close(&mut self) {
        self.ends.push(self.text.len() as u32);
    }

    /// Returns an error if the texts exceed the limit.
    pub fn check(&self) -> Result<(), WorkbookError> {
        let size = self.text.len() + 4 * self.ends.len();
        if size > MOST_TEXT { Err(WorkbookError::TooLarge { most: MOST_TEXT >> 20 }) } else { Ok(()) }
    }
}
