//! Search in the library by typed words and by level.

use crate::library::Entry;
use crate::library::courses::{Level, place_of};
use document::Searchable;
use std::cell::OnceCell;
use std::rc::Rc;
use view::views::*;

/// For each card, true if it matches.
pub type Found = Vec<bool>;

/// Search terms and searchable documents.
pub struct Search {
    /// Typed text.
    pub typed: Signal<String>,
    /// Selected level.
    pub level: Signal<Option<Level>>,
    documents: Rc<Documents>,
}

/// Documents in the order of their cards.
struct Documents {
    entries: Vec<Entry>,
    /// Words, collected for the first search.
    words: OnceCell<Vec<Searchable>>,
}

impl Search {
    /// Creates a search over documents, initially without terms.
    pub fn over<'a>(documents: impl Iterator<Item = &'a Entry>) -> Self {
        Self {
            typed: create_signal(String::new()),
            level: create_signal(None),
            documents: Rc::new(Documents { entries: documents.cloned().collect(), words: OnceCell::new() }),
        }
    }

    /// Matching documents: each typed word begins a word of one of their files, and they have the selected level. A document
    /// that stands in no course has none.
    pub fn found(&self) -> ReadSignal<Found> {
        let (typed, level, documents) = (self.typed, self.level, self.documents.clone());
        memo(move || {
            let (typed, level) = (typed.get_clone(), level.get());
            let level_of = |entry: &Entry| place_of(entry.file()).map(|(_, _, level)| level);
            let mut found: Found =
                documents.entries.iter().map(|entry| level.is_none() || level_of(entry) == level).collect();
            if !typed.trim().is_empty() {
                for (found, words) in found.iter_mut().zip(documents.words()) {
                    *found &= words.has(&typed);
                }
            }
            found
        })
    }
}

impl Documents {
    fn words(&self) -> &[Searchable] {
        let searchable = |entry: &Entry| Searchable::of(entry.files.iter().map(|file| &*file.text));
        self.words.get_or_init(|| self.entries.iter().map(searchable).collect())
    }
}
