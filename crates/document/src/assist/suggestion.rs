//! What editors are told.

use model::Span;
use units::Words;

/// What a suggestion is, for the picture beside it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SuggestionKind {
    /// A word of the language, a key of the front matter, the kind of a block.
    Word,
    /// A quantity, parameter or state of the model.
    Name,
    /// A function of the language or of the author.
    Function,
    /// A unit.
    Unit,
    /// A part or an element of a drawing, or one of its attributes.
    Part,
}

/// Something that can stand at a place.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Suggestion {
    /// What it is.
    pub kind: SuggestionKind,
    /// What is written.
    pub text: String,
    /// What it means, in a few words.
    pub meaning: Words,
}

/// What can stand in a document.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Completion {
    /// The beginning of a word that a suggestion replaces; empty where none has been begun.
    pub span: Span,
    /// In the order in which they are shown: names of the model first.
    pub suggestions: Vec<Suggestion>,
}

/// What stands at a place of a document.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Explanation {
    /// The word, with its primes.
    pub span: Span,
    /// What it is.
    pub meaning: Words,
    /// What kind of quantity it is, such as a length, or its dimension; only of names of the model, where it is known.
    pub dimension: Option<Words>,
}
