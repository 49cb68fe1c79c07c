//! Data types of editing help.

use model::Span;
use units::Words;

/// Kind of a suggestion, for its icon.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SuggestionKind {
    /// A keyword, a key of the front matter, or the kind of a block.
    Word,
    /// A quantity, parameter or state of the model.
    Name,
    /// A built-in or user-defined function.
    Function,
    /// A unit.
    Unit,
    /// A part or an element of a drawing, or one of its attributes.
    Part,
}

/// A suggested text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Suggestion {
    /// Kind of suggestion.
    pub kind: SuggestionKind,
    /// Text to insert.
    pub text: String,
    /// Short description.
    pub meaning: Words,
}

/// Suggestions for a place.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Completion {
    /// Beginning of a word that a suggestion replaces; empty if none has been typed.
    pub span: Span,
    /// In the order of display: names of the model first.
    pub suggestions: Vec<Suggestion>,
}

/// Explanation of a word.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Explanation {
    /// Place of the word, with its primes.
    pub span: Span,
    /// Its meaning.
    pub meaning: Words,
    /// Quantity, such as a length, or dimension; `None` if it is not a name of the model or the dimension is not known.
    pub dimension: Option<Words>,
}
