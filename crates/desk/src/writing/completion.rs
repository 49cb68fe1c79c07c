//! What can stand where somebody writes.

use super::mark::{from_utf16, in_utf16};
use crate::Desk;
use document::assist::{Suggestion, complete};

/// What can stand at a place of a text.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Proposals {
    /// Where the word begins that they replace, in units of UTF-16.
    pub from: usize,
    /// In the order in which they are shown.
    pub suggestions: Vec<Suggestion>,
}

impl Desk {
    /// What can stand at `place`, in units of UTF-16, of a text as it stands in the editor. Units are those of the model that
    /// runs.
    pub fn propose(&self, text: &str, place: usize) -> Proposals {
        let found = complete(&document::read(text), Some(self.play.program()), from_utf16(text, place));
        let from = in_utf16(text, std::iter::once(found.span.start)).into_values().next().unwrap_or_default();
        Proposals { from, suggestions: found.suggestions }
    }
}
