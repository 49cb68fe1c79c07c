//! The storage of a page, and the keys in it.

use std::collections::BTreeMap;

/// Texts by key that last from one visit to the next. Pages of the same site share it.
pub trait Storage {
    /// The text under a key; `None` if there is none.
    fn get(&self, key: &str) -> Option<String>;

    /// Keys that start with this prefix, in any order.
    fn keys(&self, prefix: &str) -> Vec<String>;

    /// Stores a text under a key. Returns false if the storage is full or forbidden.
    fn set(&mut self, key: &str, text: &str) -> bool;

    /// Removes the text under a key, if there is one.
    fn remove(&mut self, key: &str);

    /// Keys with this prefix, and their texts.
    fn all(&self, prefix: &str) -> Vec<(String, String)> {
        let keys = self.keys(prefix).into_iter();
        keys.filter_map(|key| self.get(&key).map(|text| (key, text))).collect()
    }
}

impl Storage for BTreeMap<String, String> {
    fn get(&self, key: &str) -> Option<String> {
        BTreeMap::get(self, key).cloned()
    }

    fn keys(&self, prefix: &str) -> Vec<String> {
        BTreeMap::keys(self).filter(|key| key.starts_with(prefix)).cloned().collect()
    }

    fn set(&mut self, key: &str, text: &str) -> bool {
        self.insert(key.to_owned(), text.to_owned());
        true
    }

    fn remove(&mut self, key: &str) {
        BTreeMap::remove(self, key);
    }
}

/// Key in the storage of an unchanged document opened from a file, made of its file name and title. Colons in both are
/// escaped, so that the keys of its items, which continue with a colon, never start like those of another document:
/// `Pendulum` and `Pendulum: large angles`.
pub fn own_document_key(file: &str, title: &str) -> String {
    let [file, title] = [file, title].map(|text| text.replace('%', "%25").replace(':', "%3A"));
    format!("own:{file}:{title}")
}

#[cfg(test)]
mod tests {
    use super::own_document_key;

    #[test]
    fn no_document_has_the_items_of_another() {
        let names = [
            "Pendulum",
            "Pendulum: large angles",
            "Pendulum:",
            ":",
            "",
            "a:b",
            "a%3Ab",
            "a%b",
            "Pendulum: large angles: 2",
        ];
        let keys: Vec<String> =
            names.iter().flat_map(|file| names.map(|title| own_document_key(file, title) + ":")).collect();
        for (place, key) in keys.iter().enumerate() {
            let begins =
                keys.iter().enumerate().filter(|(other, text)| *other != place && text.starts_with(key.as_str()));
            assert_eq!(begins.count(), 0, "{key}");
        }
    }
}
