//! The shipped documents are found by the words that teachers type, whatever the language.

use document::Searchable;
use std::path::Path;

/// Names of the documents, and the words of each with its Spanish translation.
fn documents() -> Vec<(String, Searchable)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../simulations");
    let mut documents = Vec::new();
    for folder in ["", "theories/"] {
        for entry in std::fs::read_dir(root.join(folder)).unwrap() {
            let file = entry.unwrap().file_name().into_string().unwrap();
            let Some(name) = file.strip_suffix(".md").filter(|name| !name.contains('.')) else { continue };
            let read = |end: &str| std::fs::read_to_string(root.join(format!("{folder}{name}{end}"))).unwrap();
            let texts = [read(".md"), read(".es.md")];
            documents.push((format!("{folder}{name}"), Searchable::of(texts.iter().map(String::as_str))));
        }
    }
    documents
}

#[test]
fn teachers_words_find_the_documents() {
    let documents = documents();
    for (typed, expected) in [
        ("Hooke", "chain coupled-oscillators driven-oscillator mass-on-spring stick-slip theories/saturating-spring"),
        ("SHM", "coupled-oscillators driven-oscillator mass-on-spring pendulum ruchardt theories/linear tube utube"),
        ("movimiento armonico simple", "coupled-oscillators driven-oscillator pendulum ruchardt tube utube"),
        ("simple  Harmonic", "coupled-oscillators driven-oscillator pendulum ruchardt tube utube"),
        ("RLC", "rlc"),
        ("newton cooling", "cooling"),
        ("resorte", "chain coupled-oscillators driven-oscillator mass-on-spring rlc stick-slip"),
        ("ARMONICO", "driven-oscillator rlc tube utube"),
        ("oscilador armónico", "driven-oscillator rlc tube utube"),
        ("pendulo", "double-pendulum driven-pendulum pendulum"),
        ("péndulo doble", "double-pendulum"),
        ("pendulum", "double-pendulum driven-pendulum pendulum"),
        // Labels of a parameter and of a quantity, and a word of the text.
        ("\"Cross-section of the tube\"", "tube utube"),
        ("vida media", "decay-chain"),
        // An abbreviation, which is not looked for in texts; *masa* begins with it.
        (
            "MAS",
            "chain coupled-oscillators driven-oscillator mass-on-spring pendulum ruchardt theories/linear tube utube",
        ),
        ("Verhulst", "logistic-map"),
    ] {
        let found: Vec<&str> =
            documents.iter().filter(|(_, words)| words.has(typed)).map(|(name, _)| name.as_str()).collect();
        for name in expected.split(' ') {
            assert!(found.contains(&name), "{typed}: {name} is not among {found:?}");
        }
        assert!(found.len() <= expected.split(' ').count() + 7, "{typed}: {found:?}");
    }
    assert!(documents.iter().all(|(_, words)| words.has(" ")));
    assert!(!documents.iter().any(|(_, words)| words.has("xyzzy")));
}

#[test]
fn words_are_found_by_their_beginning_in_texts_and_labels_but_not_in_code() {
    let source = "---\ntitle: The Swing\nsummary: To and fro.\ntopics: play\nkeywords: Schaukel, Ångström\n---\n\nIt *rocks*: $x$.\n\n\
                  ```model\nparameter kappa = 2 \"Stiffness of the rope\"\nx' = -kappa*x\nx(0) = 1 \"Angle\"\n```\n\n\
                  ```scene\n<svg class=\"water\"><text>Hidden</text></svg>\n```\n\n```question\nHow long is a period?\n```\n";
    let words = Searchable::of(std::iter::once(source));
    for typed in
        ["", "SWING", "fro", "play", "schau", "angstrom", "Ångström", "rocks", "stiff rope", "angle", "long period"]
    {
        assert!(words.has(typed), "{typed}");
    }
    for typed in ["ness", "kappa", "water", "parameter", "swing xyz"] {
        assert!(!words.has(typed), "{typed}");
    }
    assert!(!Searchable::of(std::iter::once(&*"swing ".repeat(1 << 18))).has("swing"));
}
