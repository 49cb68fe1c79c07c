//! Languages of the interface, and texts in all of them. English stands in the code and is the key; the other languages
//! are catalogues.
//!
//! `words!("{count} rows", ..)` makes a message that is read in a language later; `say!(language, ..)` and [`Language::say`]
//! make one that is read at once. The macros are in `crates/wording`, a procedural macro that finds the places of the
//! template when the program is compiled. [`Words`] keeps the template and its values, and fills in the translation when it
//! is read.
//!
//! Catalogues are files in gettext's format, because translators and their tools know it and English can stay the key; Fluent
//! wants an identifier for every message and a runtime of its own in the page. `crates/catalogues` holds them for the program
//! and for tests. A page carries those entries whose English text its module contains, by a 32-bit hash of it. They are
//! packed by [`Catalogue::pack`] and gzipped, one element for each language and module. Only the chosen language is inflated
//! (`view/src/page/texts.rs`), when the page opens or when the language is changed.
//!
//! Words of the interface are in `view`, `lab`, `play` and `desk`; diagnostics, findings and errors of runs are made as
//! [`Words`] where they occur, and the shell picks a language. Words of a document are in its translation.
//! `tests/all/spanish.txt` of `model` and `document` lists all pairs of texts for a reader to check.

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
