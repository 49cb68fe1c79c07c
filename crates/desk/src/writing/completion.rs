//! What can stand where somebody writes.

use super::mark::{from_utf16, in_utf16};
use crate::Desk;
use document::assist::{Explanation, Suggestion, complete, explain, typeset_at};
use program::Program;

/// What can stand at a place of a text.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Proposals {
    /// Where the word begins that they replace, in units of UTF-16.
    pub from: usize,
    /// In the order in which they are shown.
    pub suggestions: Vec<Suggestion>,
}

/// What stands where the cursor is.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Insight {
    /// The word, and what it is.
    pub word: Option<(String, Explanation)>,
    /// The statement of the model, as `<math>` elements; empty elsewhere.
    pub typeset: String,
}

/// What stands at `place`, in units of UTF-16, of a text. `program` is the one that runs.
pub fn insight(text: &str, program: Option<&Program>, place: usize) -> Insight {
    let (outline, offset) = (document::read(text), from_utf16(text, place));
    let found = explain(&outline, program, offset);
    let word = found.map(|found| (text.get(found.span.range()).unwrap_or_default().to_owned(), found));
    Insight { word, typeset: typeset_at(&outline, offset) }
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
