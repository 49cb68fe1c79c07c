//! The open document, and documents opened from their texts, kept for the next work with the same ones.
//!
//! [`OpenedDocuments`] keeps documents by their texts. The desks of the hand-ins of a class share it one after the other, so
//! that a document is opened once.

use document::Document;
use play::{Play, name_of};
use std::collections::VecDeque;
use units::Language;

/// The open document and its simulation, which the parts of a desk read.
#[derive(Clone, Copy, Debug)]
pub struct OpenDocument<'a> {
    pub(crate) play: &'a Play,
    pub(crate) document: &'a Document,
}

impl OpenDocument<'_> {
    /// Language of all texts.
    pub(crate) fn language(self) -> Language {
        self.play.basis().language()
    }

    /// Hash of the text. Results of a fit for a record are valid only with this document.
    pub(crate) fn name(self) -> String {
        name_of(&[&self.document.source])
    }
}

/// Maximum number of kept documents.
const MOST: usize = 8;

/// Recently opened documents. The hand-ins of a class mostly have the same one, and opening takes longer than a fit.
#[derive(Debug, Default)]
pub struct OpenedDocuments {
    /// Texts of a document with its translations, and the document; `None` if it has errors. The latest is last.
    kept: VecDeque<(Vec<String>, Option<Document>)>,
}

impl OpenedDocuments {
    /// The document of these texts, the source first; `None` if it has errors.
    pub fn open(&mut self, texts: &[String]) -> Option<Document> {
        if let Some((_, known)) = self.kept.iter().find(|(known, _)| known == texts) {
            return known.clone();
        }
        let (source, translations) = texts.split_first()?;
        let translations: Vec<&str> = translations.iter().map(String::as_str).collect();
        let document = document::open(source, &translations).sound();
        if self.kept.len() == MOST {
            self.kept.pop_front();
        }
        self.kept.push_back((texts.to_vec(), document.clone()));
        document
    }
}
