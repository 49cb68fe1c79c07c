//! Synchronisation with the storage, item by item, so that two pages of the same site do not overwrite each other's
//! data.
//!
//! The storage is shared; each page has its own shelf, which records the items that this page has read or written. A
//! page removes only items that it had and has no longer. It keeps items that another page has added, and does not
//! restore items that another page has removed.

use super::Item;
use std::collections::BTreeMap;

/// Items of one kind in the storage as this page has read or written them.
#[derive(Clone, Debug, Default)]
pub struct Shelf {
    known: BTreeMap<String, Known>,
    /// Times of first storage of items whose key has changed since an earlier version, by the new key.
    moved: BTreeMap<String, u64>,
}

/// An item as this page has last read or written it.
#[derive(Clone, Debug)]
struct Known {
    /// Time when it was first stored, in milliseconds. Items are ordered by it.
    since: u64,
    /// Stored text.
    text: String,
}

/// A change to be made in the storage.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Change {
    /// Store the text (second) under the key (first).
    Write(String, String),
    /// Remove the text under this key.
    Remove(String),
}

/// Keys of texts that stay in the storage unused.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Left {
    /// Items that the page did not take.
    pub refused: Vec<String>,
    /// Texts that are not items, or items of a later version.
    pub unreadable: Vec<String>,
}

impl Shelf {
    /// Reads keys and stored texts, and passes the items to `take` in the order in which they were first stored. `take`
    /// returns the new key of the item, or `None` if it does not use the item.
    pub fn read(
        &mut self,
        stored: impl IntoIterator<Item = (String, String)>,
        mut take: impl FnMut(&str, &Item) -> Option<String>,
    ) -> Left {
        let mut left = Left::default();
        let mut all = Vec::new();
        for (key, text) in stored {
            match Item::read(&text) {
                Some((since, items)) => all.push((since, key, text, items)),
                None => left.unreadable.push(key),
            }
        }
        all.sort_by(|(since, key, ..), (other, its_key, ..)| (since, key).cmp(&(other, its_key)));
        for (since, key, text, items) in all {
            let taken: Vec<String> = items.iter().filter_map(|item| take(&key, item)).collect();
            if taken.is_empty() {
                left.refused.push(key);
                continue;
            }
            // Several items of one text keep their order.
            for (place, taken) in taken.into_iter().enumerate().filter(|(_, taken)| *taken != key) {
                self.moved.insert(taken, since.saturating_add(place as u64));
            }
            self.known.insert(key, Known { since, text });
        }
        left
    }

    /// Changes that bring the storage to these items of this page, given with their keys. `now` in milliseconds.
    /// `is_stored`: true if the storage has a text under a key.
    pub fn keep(&mut self, items: Vec<(String, Item)>, now: u64, is_stored: impl Fn(&str) -> bool) -> Vec<Change> {
        let mut changes = Vec::new();
        let mut known = BTreeMap::new();
        for (place, (key, item)) in items.into_iter().enumerate() {
            let before = self.known.remove(&key);
            let moved = self.moved.remove(&key);
            let since = before.as_ref().map(|before| before.since).or(moved).unwrap_or(now + place as u64);
            let text = item.write(since);
            let write = match &before {
                // The text also differs if an earlier version has stored it.
                Some(before) => before.text != text && is_stored(&key),
                // Another page may have stored the same item; it is not overwritten.
                None => !is_stored(&key),
            };
            if write {
                changes.push(Change::Write(key.clone(), text.clone()));
            }
            known.insert(key, Known { since, text });
        }
        changes.extend(std::mem::replace(&mut self.known, known).into_keys().map(Change::Remove));
        changes
    }

    /// Marks a key whose text could not be written, so that the next call of [`Shelf::keep`] tries again.
    pub fn has_failed(&mut self, key: &str) {
        self.known.remove(key);
    }
}

#[cfg(test)]
mod tests {
    use super::super::format::{Answer, Content};
    use super::*;

    type Storage = BTreeMap<String, String>;

    fn item(typed: &str) -> Item {
        Item(Content::Answer(Answer { typed: typed.to_owned(), ..Answer::default() }))
    }

    fn items(names: &[&str]) -> Vec<(String, Item)> {
        names.iter().map(|name| ((*name).to_owned(), item(name))).collect()
    }

    fn save(storage: &mut Storage, shelf: &mut Shelf, items: Vec<(String, Item)>, now: u64) {
        for change in shelf.keep(items, now, |key| storage.contains_key(key)) {
            match change {
                Change::Write(key, text) => drop(storage.insert(key, text)),
                Change::Remove(key) => drop(storage.remove(&key)),
            }
        }
    }

    fn load(storage: &Storage) -> (Shelf, Vec<String>) {
        let (mut shelf, mut keys) = (Shelf::default(), Vec::new());
        let left = shelf.read(storage.clone(), |key, _| {
            keys.push(key.to_owned());
            Some(key.to_owned())
        });
        assert_eq!(left, Left::default());
        (shelf, keys)
    }

    #[test]
    fn two_pages_keep_each_others_items() {
        let mut storage = Storage::new();
        let (mut one, mut other) = (Shelf::default(), Shelf::default());
        save(&mut storage, &mut one, items(&["b"]), 1);
        save(&mut storage, &mut other, items(&["a"]), 2);
        save(&mut storage, &mut one, items(&["b"]), 3);
        assert_eq!(load(&storage).1, ["b", "a"], "both, in the order in which they came");

        // One removes its own; the other had read both and must not bring it back.
        let ((mut one, _), (mut other, _)) = (load(&storage), load(&storage));
        save(&mut storage, &mut one, items(&["a"]), 4);
        save(&mut storage, &mut other, items(&["b", "a", "c"]), 5);
        assert_eq!(load(&storage).1, ["a", "c"]);
        save(&mut storage, &mut other, items(&["b", "a", "c"]), 6);
        assert_eq!(load(&storage).1, ["a", "c"]);
    }

    #[test]
    fn only_what_a_page_has_changed_is_written() {
        let mut storage = Storage::new();
        let mut one = Shelf::default();
        save(&mut storage, &mut one, items(&["a", "b"]), 1);
        let (mut other, _) = load(&storage);
        let mut changed = items(&["a", "b"]);
        changed[0].1 = item("edited");
        save(&mut storage, &mut one, changed, 2);
        // The other page knows the earlier text and has changed nothing.
        assert_eq!(other.keep(items(&["a", "b"]), 3, |_| true), []);
        assert_eq!(Item::read(&storage["a"]), Some((1, vec![item("edited")])));
    }

    #[test]
    fn what_failed_is_tried_again() {
        let mut shelf = Shelf::default();
        assert_eq!(shelf.keep(items(&["a"]), 1, |_| false).len(), 1);
        assert_eq!(shelf.keep(items(&["a"]), 2, |_| false).len(), 0, "another page has removed it");
        shelf.has_failed("a");
        assert_eq!(shelf.keep(items(&["a"]), 3, |_| false).len(), 1);
    }

    #[test]
    fn what_there_is_no_use_for_stays_where_it_is() {
        let later = item("x").write(1).replace(":3,", ":4,");
        let stored = [("k", "no number\ntext\n"), ("l", "7"), ("m", &later), ("n", &item("n").write(5))]
            .map(|(key, text)| (key.to_owned(), text.to_owned()));
        let mut shelf = Shelf::default();
        let left = shelf.read(stored, |_, _| None);
        assert_eq!((left.unreadable.join(" "), left.refused.join(" ")), ("k l m".into(), "n".into()));
        assert_eq!(shelf.keep(Vec::new(), 8, |_| true), []);
    }

    #[test]
    fn what_an_earlier_version_has_stored_is_written_in_this_format() {
        let mut storage = Storage::from([("a".to_owned(), "5\n3 s\ncorrect\n".to_owned())]);
        let (mut shelf, _) = load(&storage);
        // Nothing is stored twice, not even an item with a new key.
        storage.insert("old".into(), "6\n4 s\n\nrevealed".into());
        shelf.read([("old".to_owned(), storage["old"].clone())], |_, _| Some("new".to_owned()));
        save(&mut storage, &mut shelf, items(&["a", "new"]), 9);
        assert_eq!(storage, Storage::from([("a".into(), item("a").write(5)), ("new".into(), item("new").write(6))]));
    }
}
