//! Data stored for the next visit: the format of items, conversion between a desk and items, and synchronisation with
//! the storage of the page.

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
