//! What lasts from visit to visit, item by item, so that two pages of the same site do not overwrite each other's.
//!
//! The storage is shared, the shelf is each page's own: it remembers what this page has read or written. A page removes only
//! what it had and has no more; what another page has added it leaves alone, and what another page has removed it does not
//! bring back.

use std::collections::BTreeMap;

/// What one page knows of the items of one kind in the storage.
#[derive(Clone, Debug, Default)]
pub struct Shelf {
    known: BTreeMap<String, Item>,
}

/// An item as this page has read or written it last.
#[derive(Clone, Debug)]
struct Item {
    /// When it was first stored, in milliseconds: the order of the items.
    since: u64,
    text: String,
}

/// What is to be done in the storage.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Change {
    /// Store this text under this key.
    Write(String, String),
    /// Remove what is stored under this key.
    Remove(String),
}

impl Shelf {
    /// Puts stored items into the order in which they were first stored: keys, and texts as they were saved.
    pub fn ordered(stored: impl IntoIterator<Item = (String, String)>) -> Vec<(String, String)> {
        let mut items: Vec<(u64, String, String)> = stored
            .into_iter()
            .filter_map(|(key, stored)| {
                let (since, text) = stored.split_once('\n')?;
                Some((since.parse().ok()?, key, text.to_owned()))
            })
            .collect();
        items.sort();
        items.into_iter().map(|(_, key, text)| (key, text)).collect()
    }

    /// Takes note of what has been read, as it is stored.
    pub fn has_read(&mut self, key: &str, stored: &str) {
        if let Some((since, text)) = stored.split_once('\n')
            && let Ok(since) = since.parse()
        {
            self.known.insert(key.to_owned(), Item { since, text: text.to_owned() });
        }
    }

    /// What has to be done so that the storage holds these items of this page, keys and texts; `now` in milliseconds.
    /// `is_stored` says whether there is something under a key.
    pub fn keep(&mut self, items: Vec<(String, String)>, now: u64, is_stored: impl Fn(&str) -> bool) -> Vec<Change> {
        let mut changes = Vec::new();
        let mut known = BTreeMap::new();
        for (place, (key, text)) in items.into_iter().enumerate() {
            let before = self.known.remove(&key);
            let since = before.as_ref().map_or(now + place as u64, |before| before.since);
            let write = match &before {
                Some(before) => before.text != text && is_stored(&key),
                // Another page may have stored the same item; it stays where it is.
                None => !is_stored(&key),
            };
            if write {
                changes.push(Change::Write(key.clone(), format!("{since}\n{text}")));
            }
            known.insert(key, Item { since, text });
        }
        changes.extend(std::mem::replace(&mut self.known, known).into_keys().map(Change::Remove));
        changes
    }

    /// What could not be written is new the next time.
    pub fn has_failed(&mut self, key: &str) {
        self.known.remove(key);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    type Storage = BTreeMap<String, String>;

    fn items(names: &[&str]) -> Vec<(String, String)> {
        names.iter().map(|name| ((*name).to_owned(), format!("text of {name}"))).collect()
    }

    fn save(storage: &mut Storage, shelf: &mut Shelf, items: Vec<(String, String)>, now: u64) {
        for change in shelf.keep(items, now, |key| storage.contains_key(key)) {
            match change {
                Change::Write(key, text) => drop(storage.insert(key, text)),
                Change::Remove(key) => drop(storage.remove(&key)),
            }
        }
    }

    fn load(storage: &Storage) -> (Shelf, Vec<String>) {
        let mut shelf = Shelf::default();
        storage.iter().for_each(|(key, text)| shelf.has_read(key, text));
        (shelf, Shelf::ordered(storage.clone()).into_iter().map(|(key, _)| key).collect())
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
        changed[0].1 = "edited".into();
        save(&mut storage, &mut one, changed, 2);
        // The other page knows the earlier text and has changed nothing.
        assert_eq!(other.keep(items(&["a", "b"]), 3, |_| true), []);
        assert_eq!(Shelf::ordered(storage)[0], ("a".into(), "edited".into()));
    }

    #[test]
    fn what_failed_is_tried_again_and_nonsense_is_no_item() {
        let mut shelf = Shelf::default();
        assert_eq!(shelf.keep(items(&["a"]), 1, |_| false).len(), 1);
        assert_eq!(shelf.keep(items(&["a"]), 2, |_| false).len(), 0, "another page has removed it");
        shelf.has_failed("a");
        assert_eq!(shelf.keep(items(&["a"]), 3, |_| false).len(), 1);
        assert_eq!(Shelf::ordered([("k".into(), "no number\ntext".into()), ("l".into(), "7".into())]), []);
    }
}
