//! Texts of a document with their translations.

use document::edit::{EditError, Obstacle, apply, set_translation};
use document::translating::{TextKey, beginning, likely_language, pairs, short_texts};
use document::{open, read};
use proptest::prelude::*;
use std::path::Path;

const DOCUMENT: &str = "---\ntitle: A spring\nlanguage: en\n---\n\nIt swings.\n\n```model\nparameter k = 4 [N/m] \"Stiffness\"\nx'' = -k*x/(1 [kg])\nx(0) = 1 [m] \"Place\"\nx'(0) = 0 [m/s]\n```\n\nMore words.\n\n```question\nHow stiff?\n\nanswer: k within 1 %\nhint: Look.\n```\n\nThe end.\n";

/// Each document of the gallery with its Spanish translation.
fn gallery() -> Vec<(String, String)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../simulations");
    let mut found = Vec::new();
    for entry in std::fs::read_dir(&folder).unwrap().map(Result::unwrap) {
        let name = entry.file_name().into_string().unwrap();
        if let Some(stem) = name.strip_suffix(".es.md") {
            let text = |name: String| std::fs::read_to_string(folder.join(name)).unwrap();
            found.push((text(format!("{stem}.md")), text(name.clone())));
        }
    }
    assert!(found.len() > 10);
    found
}

/// The gallery has no missing translations.
#[test]
fn every_text_of_the_gallery_has_its_translation() {
    for (document, translation) in gallery() {
        let (outline, other) = (read(&document), read(&translation));
        let all = pairs(&outline, &short_texts(&document), &other);
        let missing: Vec<_> = all.iter().filter(|pair| pair.is_needed && pair.translation.is_empty()).collect();
        assert_eq!(missing, Vec::<&document::translating::Pair>::new(), "{}", &document[..60]);
        assert!(all.iter().any(|pair| matches!(pair.key, TextKey::Short(_))));
    }
}

#[test]
fn a_translation_is_written_text_by_text_until_nothing_is_missing() {
    let mut text =
        beginning("spring.md", read(DOCUMENT).front_matter(), likely_language(read(DOCUMENT).front_matter()));
    assert_eq!(text, "---\ntitle: A spring\nlanguage: es\ntranslates: spring.md\n---\n");
    for (key, written) in [
        (TextKey::Front("title"), "Un muelle"),
        (TextKey::Prose(0, 0), "Oscila."),
        (TextKey::Short("Stiffness".to_owned()), "Rigidez"),
        (TextKey::Short("Place".to_owned()), "Lugar"),
        (TextKey::Prompt(0), "¿Qué rigidez?"),
        (TextKey::Hint(0), "Mira."),
        (TextKey::Prose(1, 0), "Fin."),
    ] {
        let edits = set_translation(&read(&text), &key, written).unwrap();
        text = apply(&text, &edits).unwrap();
        let all = pairs(&read(DOCUMENT), &short_texts(DOCUMENT), &read(&text));
        assert_eq!(all.iter().find(|pair| pair.key == key).unwrap().translation, written);
    }
    assert_eq!(
        text,
        "---\ntitle: Un muelle\nlanguage: es\ntranslates: spring.md\n---\n\nOscila.\n\n```translations\n\"Stiffness\" = \"Rigidez\"\n\"Place\" = \"Lugar\"\n```\n```question\n¿Qué rigidez?\nhint: Mira.\n```\n\nFin.\n\n"
    );
    let opened = open(DOCUMENT, &[&text]);
    assert!(opened.diagnostics.is_empty(), "{:?}", opened.diagnostics);
    let set = |key: TextKey, written: &str| {
        set_translation(&read(&text), &key, written).map(|edits| apply(&text, &edits).unwrap())
    };
    for (key, written, before, after) in [
        (TextKey::Short("Place".to_owned()), "Sitio", "\"Place\" = \"Lugar\"", "\"Place\" = \"Sitio\""),
        (TextKey::Short("Place".to_owned()), "", "\"Place\" = \"Lugar\"\n", ""),
        (TextKey::Hint(0), "Mira bien.\nDos veces.", "Mira.", "Mira bien.\nDos veces."),
        (TextKey::Hint(0), "", "hint: Mira.\n", ""),
        (TextKey::Prose(1, 0), "El fin.", "Fin.", "El fin."),
        (TextKey::Explanation(0), "Así es.", "hint: Mira.\n", "hint: Mira.\nexplanation: Así es.\n"),
    ] {
        assert_eq!(set(key.clone(), written).unwrap(), text.replace(before, after), "{key:?} {written}");
    }
    let refused = |mark: &str| Err(EditError::NotOneCell(Obstacle::Mark(mark.to_owned())));
    assert_eq!(set(TextKey::Short("Place".to_owned()), "a\" = \"b"), refused("\""));
    // Text after a keyword is another part of the question.
    assert_eq!(set(TextKey::Hint(0), "a\nexplanation: b"), refused("explanation:"));
    assert_eq!(set(TextKey::Prompt(4), "a"), Err(EditError::EarlierQuestion(4)));
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 16, ..ProptestConfig::default() })]

    /// Arbitrary edits of translations: the text is set and the others are unchanged, or the edit is refused.
    #[test]
    fn what_is_written_is_read(which in any::<prop::sample::Index>(), at in any::<prop::sample::Index>(), text in "[a-zé$`\"#:\\n ]{0,20}") {
        let all = gallery();
        let (document, translation) = &all[which.index(all.len())];
        let (outline, other) = (read(document), read(translation));
        let short = short_texts(document);
        let before = pairs(&outline, &short, &other);
        let key = &before[at.index(before.len())].key;
        let Ok(edits) = set_translation(&other, key, &text) else { return Ok(()) };
        let edited = apply(translation, &edits).unwrap();
        let after = pairs(&outline, &short, &read(&edited));
        for (old, new) in before.iter().zip(&after) {
            let shifts = text.trim().is_empty() && matches!(old.key, TextKey::Prose(..));
            if old.key == *key && !shifts {
                prop_assert_eq!(new.translation.as_str(), text.trim());
            } else if !shifts {
                prop_assert_eq!(&old.translation, &new.translation);
            }
        }
    }
}
