//! Languages of the interface, and texts in all of them. English stands in the code and is the key; the other languages
//! are catalogues.

mod catalogue;
mod conjunction;
mod list;
mod words;

pub use catalogue::{Catalogue, provide};
pub use conjunction::Conjunction;
pub use list::Language;
pub use words::{ToWords, Words, words};

/// The text as a sentence: with a capital at the beginning and a full stop at the end.
pub fn sentence(text: &str) -> String {
    let mut letters = text.chars();
    let first = letters.next().map(crate::alphabet::capital);
    // A text that begins with a name of one letter keeps it unchanged.
    match first.filter(|_| letters.as_str().starts_with(char::is_alphabetic)) {
        Some(first) => format!("{first}{}.", letters.as_str()),
        None => format!("{text}."),
    }
}
