//! The catalogues of the texts in languages other than English, in the format of gettext (`languages/*.po`). The program and
//! the tests take their texts from here; pages carry the parts that they need, packed.
//!
//! - **Invariant:** no page depends on this crate. `cargo xtask texts` brings the catalogues up to date with the texts of the
//!   code.

use polib::po_file::{POParseOptions, parse_from_reader_with_option};
use std::collections::BTreeMap;
use units::{Catalogue, Language, with_languages};

/// Declares the function that gives the file of a language; English has none.
macro_rules! files {
    ($english:ident $_tag:literal $_name:literal; $($language:ident $tag:literal $name:literal;)*) => {
        fn file(language: Language) -> Option<&'static str> {
            match language {
                Language::$english => None,
                $(Language::$language => Some(include_str!(concat!("../languages/", $tag, ".po"))),)*
            }
        }
    };
}

with_languages!(files);

/// Makes the catalogues known to all messages. They are read when a text of their language is asked for first.
pub fn install() {
    units::provide(|language| {
        let texts = texts(language);
        // That no two English texts are packed alike is tested.
        let packed = Catalogue::pack(texts.iter().map(|(key, text)| (key.as_str(), text.as_str())));
        packed.map_or_else(|_| Catalogue::default(), |packed| Catalogue::unpack(&packed))
    });
}

/// The language, with all catalogues installed: for tests.
pub fn with(language: Language) -> Language {
    install();
    language
}

/// Translations by their English texts; empty ones are missing. English has none.
pub fn texts(language: Language) -> BTreeMap<String, String> {
    let Some(file) = file(language) else { return BTreeMap::new() };
    let options = POParseOptions { translated_only: false, ..POParseOptions::default() };
    let catalogue = parse_from_reader_with_option(file.as_bytes(), &options);
    // The files are part of the program; a test reads each.
    let Ok(catalogue) = catalogue else { return BTreeMap::new() };
    catalogue.messages().filter_map(|one| Some((one.msgid().to_owned(), one.msgstr().ok()?.to_owned()))).collect()
}
