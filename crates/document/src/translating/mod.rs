//! Texts of a document with their translations. [`crate::edit::set_translation`] changes one.
//!
//! Texts of both files are matched by keys that both have.

pub(crate) mod edition;
pub(crate) mod translation;

mod key;
mod short_texts;
mod values;

pub use key::{Pair, TextKey};
pub use short_texts::short_texts;
pub(crate) use values::{entry_in, prose_at, question_at, values};

use crate::{FrontMatter, Outline};
use units::Language;

/// Texts of a document in text order, with their translations. `short`: the [`short_texts()`] of the document.
pub fn pairs(document: &Outline, short: &[String], translation: &Outline) -> Vec<Pair> {
    let translated = values(translation);
    let pair = |(key, original): (TextKey, String)| {
        let known = translated.iter().find(|(other, _)| *other == key);
        // Pieces of prose may be joined or split in a translation.
        let stands = match key {
            TextKey::Prose(segment, _) => {
                translated.iter().any(|(other, _)| matches!(other, TextKey::Prose(of, _) if *of == segment))
            }
            _ => false,
        };
        let is_needed = !stands && crate::scene::has_word(&original);
        Pair { key, original, translation: known.map(|(_, text)| text.clone()).unwrap_or_default(), is_needed }
    };
    let mut texts = values(document);
    texts.retain(|(key, _)| !matches!(key, TextKey::Short(_)));
    let place = texts.iter().take_while(|(key, _)| matches!(key, TextKey::Front(_))).count();
    texts.splice(place..place, short.iter().map(|text| (TextKey::Short(text.clone()), text.clone())));
    texts.into_iter().map(pair).collect()
}

/// Text of a new translation without translated texts. `document`: file name of the translated document.
pub fn beginning(document: &str, matter: &FrontMatter, language: &str) -> String {
    let title = matter.get("title").map_or("", |title| title.text.as_str());
    format!("---\ntitle: {title}\nlanguage: {language}\ntranslates: {document}\n---\n")
}

/// Language tags offered for new translations, each with its own name. Others can be entered in the text.
pub const LANGUAGES: [(&str, &str); 8] = [
    ("en", "English"),
    ("es", "Español"),
    ("ca", "Català"),
    ("de", "Deutsch"),
    ("fr", "Français"),
    ("it", "Italiano"),
    ("pt", "Português"),
    ("gl", "Galego"),
];

/// The most probable language of a new translation.
pub fn likely_language(matter: &FrontMatter) -> &'static str {
    let own = matter.get("language").map_or("en", |language| language.text.as_str());
    Language::ALL.iter().map(|language| language.tag()).find(|tag| *tag != own).unwrap_or("en")
}
