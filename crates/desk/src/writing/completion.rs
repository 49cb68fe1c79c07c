//! Completion and explanation at the cursor of the editor.

use super::mark::{from_utf16, in_utf16};
use document::assist::{Explanation, Suggestion, complete, explain, typeset_at};
use program::Program;

/// Completions at a position of a text.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Proposals {
    /// Start of the word that they replace, in UTF-16 code units.
    pub from: usize,
    /// Suggestions in the order in which they are shown.
    pub suggestions: Vec<Suggestion>,
}

/// Explanation of the text at the cursor.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Insight {
    /// The word under the cursor and its explanation.
    pub word: Option<(String, Explanation)>,
    /// The statement of the model, as `<math>` elements; empty outside of one.
    pub typeset: String,
}

/// Explanation of the text at `place`, in UTF-16 code units. `program`: the running program.
pub fn insight(text: &str, program: Option<&Program>, place: usize) -> Insight {
    let (outline, offset) = (document::read(text), from_utf16(text, place));
    let found = explain(&outline, program, offset);
    let word = found.map(|found| (text.get(found.span.range()).unwrap_or_default().to_owned(), found));
    Insight { word, typeset: typeset_at(&outline, offset) }
}

/// Completions at `place`, in UTF-16 code units, of a text. Units are those of the running program.
pub fn propose(text: &str, program: &Program, place: usize) -> Proposals {
    let found = complete(&document::read(text), Some(program), from_utf16(text, place));
    let from = in_utf16(text, std::iter::once(found.span.start)).into_values().next().unwrap_or_default();
    Proposals { from, suggestions: found.suggestions }
}
