//! One visit of a page: what it has read from the storage and written to it.

use super::answers::{restore_answer, saved_answers};
use crate::Desk;
use saved::format::Content;
use saved::{Item, Shelf, Storage};

/// Key prefixes of the items of all documents.
const RECORDS: &str = "record:";
const FITS: &str = "fit:";
const FILMS: &str = "film:";
/// Key prefix of the state in which a document was left, in the form of a link.
const STATE: &str = "state:";

/// The items of a page as it has last read or written them. Other pages of the site share the storage.
#[derive(Clone, Debug, Default)]
pub struct Visit {
    records: Shelf,
    films: Shelf,
    fits: Shelf,
    /// Answers to the questions of the open document.
    answers: Shelf,
}

impl Visit {
    /// Restores records, films and fits. Returns the number of records for which there was no room; they stay in the
    /// storage.
    pub fn restore_measured(&mut self, desk: &mut Desk, storage: &mut dyn Storage) -> usize {
        let records = self.records.read(storage, RECORDS, |_, item| restored(desk, RECORDS, item));
        // After the records, to which some of them belong.
        self.films.read(storage, FILMS, |_, item| restored(desk, FILMS, item));
        let fits = self.fits.read(storage, FITS, |_, item| restored(desk, FITS, item));
        if records.refused.is_empty() && records.unreadable.is_empty() {
            // The record of a fit that cannot be restored was removed in another page.
            fits.refused.iter().for_each(|key| storage.remove(key));
        }
        records.refused.len()
    }

    /// Restores the answers to the questions of an opened document. `document`: its key in the storage.
    pub fn restore_answers(&mut self, desk: &mut Desk, storage: &dyn Storage, document: &str) {
        let prefix = answers_of(document);
        self.leave_document();
        self.answers.read(storage, &prefix, |key, item| {
            let question = key.strip_prefix(&prefix).unwrap_or_default();
            restore_answer(desk.play_mut(), question, item).then(|| key.to_owned())
        });
    }

    /// Called when the open document gets another key. Data under the former key stay.
    pub fn leave_document(&mut self) {
        self.answers = Shelf::default();
    }

    /// The state in which a document was left, in the form of a link; empty if there is none.
    pub fn state(storage: &dyn Storage, document: &str) -> String {
        storage.get(&format!("{STATE}{document}")).unwrap_or_default()
    }

    /// Saves everything. `document`: key of the open document. `now` in milliseconds. Returns false if something could
    /// not be stored; the next call tries again.
    pub fn save(&mut self, desk: &Desk, storage: &mut dyn Storage, document: &str, now: u64) -> bool {
        let mut is_stored = storage.set(&format!("{STATE}{document}"), &desk.play().share());
        for (shelf, prefix, items) in [
            (&mut self.records, RECORDS.to_owned(), desk.records().saved()),
            (&mut self.films, FILMS.to_owned(), desk.films().saved()),
            (&mut self.fits, FITS.to_owned(), desk.fits().saved()),
            (&mut self.answers, answers_of(document), saved_answers(desk.play())),
        ] {
            let items: Vec<(String, Item)> =
                items.into_iter().map(|(name, item)| (format!("{prefix}{name}"), item)).collect();
            is_stored &= shelf.save(storage, items, now);
        }
        is_stored
    }
}

/// State and answers stored for a document, as (key, text). `document`: its key.
pub fn document_data(storage: &dyn Storage, document: &str) -> Vec<(String, String)> {
    let state = format!("{STATE}{document}");
    let kept = storage.get(&state).map(|text| (state, text));
    kept.into_iter().chain(storage.all(&answers_of(document))).collect()
}

fn answers_of(document: &str) -> String {
    format!("answer:{document}:")
}

/// Restores an item of the kind of a prefix, and returns its key in the storage.
fn restored(desk: &mut Desk, prefix: &str, item: &Item) -> Option<String> {
    let own = match item.0 {
        Content::Record(_) => RECORDS,
        Content::Film(_) => FILMS,
        Content::Fit(_) => FITS,
        Content::Answer(_) => return None,
    };
    let name = if own == prefix { desk.restore_item(item) } else { None };
    name.map(|name| format!("{prefix}{name}"))
}
