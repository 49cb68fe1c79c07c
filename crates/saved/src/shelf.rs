//! Synchronisation with the storage, item by item, so that two pages of the same site do not overwrite each other's
//! data.
//!
//! The storage is shared; each page has its own shelf, which records the items that this page has read or written. A
//! page removes only items that it had and has no longer. It keeps items that another page has added, and does not
//! restore items that another page has removed.

use crate::{Item, Storage};
use std::collections::BTreeMap;
use units::order::sort_by;

/// Items of one kind in the storage as this page has read or written them.
#[derive(Clone, Debug, Default)]
pub struct Shelf {
    known: BTreeMap<String, Known>,
    /// Times of first storage of items that were read under another key than theirs, by their key.
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

/// Keys of texts that stay in the storage unused.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Left {
    /// Items that the page did not take.
    pub refused: Vec<String>,
    /// Texts that are not items, or items of a later version.
    pub unreadable: Vec<String>,
}

impl Shelf {
    /// Reads the items whose keys start with `prefix`, and passes their keys and contents to `take` in the order in which
    /// they were first stored. `take` returns the key under which the item is to be stored, or `None` if it does not use
    /// the item.
    pub fn read(
        &mut self,
        storage: &dyn Storage,
        prefix: &str,
        mut take: impl FnMut(&str, &Item) -> Option<String>,
    ) -> Left {
        let mut left = Left::default();
        let mut all = Vec::new();
        for (key, text) in storage.all(prefix) {
            match Item::read(&text) {
                Some((since, item)) => all.push((since, key, text, item)),
                None => left.unreadable.push(key),
            }
        }
        sort_by(&mut all, |(since, key, ..), (other, its_key, ..)| (since, key).cmp(&(other, its_key)));
        for (since, key, text, item) in all {
            let Some(taken) = take(&key, &item) else {
                left.refused.push(key);
                continue;
            };
            if taken != key {
                self.moved.insert(taken, since);
            }
            self.known.insert(key, Known { since, text });
        }
        left
    }

    /// Brings the storage to these items of this page, given with their keys. `now` in milliseconds. Returns false if an
    /// item could not be stored; the next call tries again.
    pub fn save(&mut self, storage: &mut dyn Storage, items: Vec<(String, Item)>, now: u64) -> bool {
        let mut is_stored = true;
        let mut known = BTreeMap::new();
        for (place, (key, item)) in items.into_iter().enumerate() {
            let before = self.known.remove(&key);
            let moved = self.moved.remove(&key);
            let since = before.as_ref().map(|before| before.since).or(moved).unwrap_or(now + place as u64);
            let text = item.write(since);
            let is_there = storage.get(&key).is_some();
            let write = match &before {
                Some(before) => before.text != text && is_there,
                // Another page may have stored the same item; it is not overwritten.
                None => !is_there,
            };
            if write && !storage.set(&key, &text) {
                is_stored = false;
            } else {
                known.insert(key, Known { since, text });
            }
        }
        for key in std::mem::replace(&mut self.known, known).into_keys() {
            storage.remove(&key);
        }
        is_stored
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::format::{Answer, Content};

    /// A storage with room for a number of items.
    #[derive(Clone, Debug, Default, PartialEq)]
    struct Small {
        texts: BTreeMap<String, String>,
        room: usize,
    }

    impl Storage for Small {
        fn get(&self, key: &str) -> Option<String> {
            Storage::get(&self.texts, key)
        }

        fn keys(&self, prefix: &str) -> Vec<String> {
            Storage::keys(&self.texts, prefix)
        }

        fn set(&mut self, key: &str, text: &str) -> bool {
            let has_room = self.texts.contains_key(key) || self.texts.len() < self.room;
            has_room && self.texts.set(key, text)
        }

        fn remove(&mut self, key: &str) {
            Storage::remove(&mut self.texts, key);
        }
    }

    fn item(typed: &str) -> Item {
        Item(Content::Answer(Answer { typed: typed.to_owned(), ..Answer::default() }))
    }

    fn items(names: &[&str]) -> Vec<(String, Item)> {
        names.iter().map(|name| ((*name).to_owned(), item(name))).collect()
    }

    fn load(storage: &dyn Storage) -> (Shelf, Vec<String>) {
        let (mut shelf, mut keys) = (Shelf::default(), Vec::new());
        let left = shelf.read(storage, "", |key, _| {
            keys.push(key.to_owned());
            Some(key.to_owned())
        });
        assert_eq!(left, Left::default());
        (shelf, keys)
    }

    #[test]
    fn two_pages_keep_each_others_items() {
        let mut storage = BTreeMap::new();
        let (mut one, mut other) = (Shelf::default(), Shelf::default());
        one.save(&mut storage, items(&["b"]), 1);
        other.save(&mut storage, items(&["a"]), 2);
        one.save(&mut storage, items(&["b"]), 3);
        assert_eq!(load(&storage).1, ["b", "a"], "both, in the order in which they came");

        // One removes its own; the other had read both and must not bring it back.
        let ((mut one, _), (mut other, _)) = (load(&storage), load(&storage));
        one.save(&mut storage, items(&["a"]), 4);
        other.save(&mut storage, items(&["b", "a", "c"]), 5);
        assert_eq!(load(&storage).1, ["a", "c"]);
        other.save(&mut storage, items(&["b", "a", "c"]), 6);
        assert_eq!(load(&storage).1, ["a", "c"]);
    }

    #[test]
    fn only_what_a_page_has_changed_is_written() {
        let mut storage = BTreeMap::new();
        let mut one = Shelf::default();
        one.save(&mut storage, items(&["a", "b"]), 1);
        let (mut other, _) = load(&storage);
        let mut changed = items(&["a", "b"]);
        changed[0].1 = item("edited");
        one.save(&mut storage, changed, 2);
        // The other page knows the text before, and has changed nothing.
        other.save(&mut storage, items(&["a", "b"]), 3);
        assert_eq!(Item::read(&storage["a"]), Some((1, item("edited"))));
    }

    #[test]
    fn what_failed_is_tried_again() {
        let mut storage = Small { room: 1, ..Small::default() };
        let mut shelf = Shelf::default();
        assert!(!shelf.save(&mut storage, items(&["a", "b"]), 1));
        storage.texts.clear();
        assert!(shelf.save(&mut storage, items(&["a", "b"]), 2), "another page has removed the first one");
        assert_eq!(load(&storage).1, ["b"]);
    }

    #[test]
    fn what_there_is_no_use_for_stays_where_it_is() {
        let later = item("x").write(1).replace(":3,", ":4,");
        let stored: BTreeMap<String, String> =
            [("k", "no number\ntext\n"), ("l", "7"), ("m", &later), ("n", &item("n").write(5))]
                .map(|(key, text)| (key.to_owned(), text.to_owned()))
                .into();
        let (mut shelf, mut after) = (Shelf::default(), stored.clone());
        let left = shelf.read(&stored, "", |_, _| None);
        assert_eq!((left.unreadable.join(" "), left.refused.join(" ")), ("k l m".into(), "n".into()));
        shelf.save(&mut after, Vec::new(), 8);
        assert_eq!(after, stored);
    }

    #[test]
    fn an_item_read_under_another_key_is_stored_once() {
        let mut storage = BTreeMap::from([("old".to_owned(), item("new").write(6))]);
        let mut shelf = Shelf::default();
        shelf.read(&storage, "", |_, _| Some("new".to_owned()));
        shelf.save(&mut storage, items(&["new"]), 9);
        assert_eq!(storage, BTreeMap::from([("new".to_owned(), item("new").write(6))]));
    }
}
