//! Texts that the cells of a workbook share.

use super::refusal::WorkbookError;

/// Bytes of all texts together. A measurement has a header and some remarks.
const MOST_TEXT: usize = 32 << 20;

/// The texts one behind the other, and where each ends.
#[derive(Debug, Default)]
pub(super) struct Texts {
    text: String,
    ends: Vec<u32>,
}

impl Texts {
    /// A text by its number, from 0.
    pub fn get(&self, index: usize) -> Option<&str> {
        let start = match index.checked_sub(1) {
            Some(before) => *self.ends.get(before)?,
            None => 0,
        };
        self.text.get(start as usize..*self.ends.get(index)? as usize)
    }

    /// Number of texts that are complete.
    pub fn len(&self) -> usize {
        self.ends.len()
    }

    /// The text that is being read, behind those that are complete.
    pub fn open(&mut self) -> &mut String {
        &mut self.text
    }

    /// Completes the text that is being read.
    pub fn close(&mut self) {
        self.ends.push(self.text.len() as u32);
    }

    /// Refuses more than a measurement needs.
    pub fn check(&self) -> Result<(), WorkbookError> {
        let size = self.text.len() + 4 * self.ends.len();
        if size > MOST_TEXT { Err(WorkbookError::TooLarge { most: MOST_TEXT >> 20 }) } else { Ok(()) }
    }
}
