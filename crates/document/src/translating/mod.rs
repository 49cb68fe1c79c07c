//! The texts of a document beside those of a translation. [`crate::edit::set_translation`] writes one.

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

/// The texts of a document in their order, beside those of a translation. `short` are its [`short_texts`].
pub fn pairs(document: &Outline, short: &[String], translation: &Outline) -> Vec<Pair> {
    let translated = values(translation);
    let pair = |(key, original): (TextKey, String)| {
        let known = translated.iter().find(|(other, _)| *other == key);
        // Several pieces of prose may stand for one, or one for several.
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

/// The file of a translation in which nothing is translated yet. `document` is the name of the file that it translates.
pub fn beginning(document: &str, matter: &FrontMatter, language: &str) -> String {
    let title = matter.get("title").map_or("", |title| title.text.as_str());
    format!("---\ntitle: {title}\nlanguage: {language}\ntranslates: {document}\n---\n")
}

/// Languages in which a translation can be begun, each with its own name. Others are begun in the text.
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

/// The language that a new translation most probably has.
pub fn likely_language(matter: &FrontMatter) -> &'static str {
    let own = matter.get("language").map_or("en", |language| language.text.as_str());
    Language::ALL.iter().map(|language| language.tag()).find(|tag| *tag != own).unwrap_or("en")
}
