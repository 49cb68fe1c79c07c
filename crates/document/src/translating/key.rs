//! What texts a translation has.

/// Which text of a document is meant; its translation has the same key.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum TextKey {
    /// The value of this key of the front matter: title, summary or topics.
    Front(&'static str),
    /// A label, title or text of the drawing, with single blanks.
    Short(String),
    /// A piece of prose: behind how many questions it stands, and which one it is there.
    Prose(usize, usize),
    /// The prompt of the question with this number.
    Prompt(usize),
    /// The hint of the question with this number.
    Hint(usize),
    /// The explanation of the question with this number.
    Explanation(usize),
}

/// A text of a document and what it is in a translation.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Pair {
    /// Which text it is.
    pub key: TextKey,
    /// The text of the document.
    pub original: String,
    /// Its translation; empty where it is missing.
    pub translation: String,
    /// Whether a reader of the translation misses it while it is empty: not so of numbers and symbols.
    pub is_needed: bool,
}
