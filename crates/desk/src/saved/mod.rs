//! What is kept for the next visit: items in one format, how a desk is turned into them and back, and which of them a page
//! writes and removes.

mod answers;
mod earlier;
mod films;
mod fits;
mod format;
mod item;
mod number;
mod place;
mod project;
mod records;
mod shelf;
mod tracks;

pub use item::Item;
pub use shelf::{Change, Left, Shelf};

/// Name in the storage of a document that was opened from a file and not changed here: by its file and title. Colons in them are
/// escaped, so that the keys of its items begin like those of no other document: `Pendulum` is no part of `Pendulum: large angles`.
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
