//! Keys of the texts of a document.

/// Key of a text of a document; its translation has the same key.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum TextKey {
    /// Value of a key of the front matter: title, summary or topics.
    Front(&'static str),
    /// A label, title or text of the drawing, with single blanks.
    Short(String),
    /// A piece of prose: number of questions before it, and its index among the pieces after that question.
    Prose(usize, usize),
    /// Prompt of the question with this index.
    Prompt(usize),
    /// Hint of the question with this index.
    Hint(usize),
    /// Explanation of the question with this index.
    Explanation(usize),
}

/// A text of a document and its translation.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Pair {
    /// Key of the text.
    pub key: TextKey,
    /// Text of the document.
    pub original: String,
    /// Translation; empty if it is missing.
    pub translation: String,
    /// True if a translation is needed; false for numbers and symbols.
    pub is_needed: bool,
}
