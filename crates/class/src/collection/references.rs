//! The teacher's documents.

use document::page::Source;

/// The teacher's documents.
#[derive(Debug, Default)]
pub struct References {
    /// Each with its translations.
    pub(super) documents: Vec<Vec<Source>>,
    /// True if a hand-in with none of them differs. Otherwise a document counts if a hand-in has exactly its text.
    pub(super) are_given: bool,
}

impl References {
    /// Documents that the teacher names. A hand-in with another document differs.
    pub fn given(documents: Vec<Vec<Source>>) -> Self {
        Self { are_given: !documents.is_empty(), documents }
    }

    /// [`References::given`] from a list of lists of files in JSON: `[[{"name":"tube.md","text":"…"}]]`. `None` if it is none.
    pub fn of_json(text: &str) -> Option<Self> {
        serde_json::from_str(text).ok().map(Self::given)
    }
}
