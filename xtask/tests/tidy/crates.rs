//! Check of the dependencies between crates, and of the modules that the core crates must not use.

use crate::texts::{product, root, texts};
use std::fs;

/// Crates of the workspace that each crate may use. These limits are part of the design (ARCHITECTURE.md).
const ARROWS: [(&str, &[&str]); 32] = [
    ("wording", &[]),
    ("units", &["wording"]),
    ("packed", &["units"]),
    ("ejss", &["packed", "units"]),
    ("catalogues", &["units"]),
    ("elementary", &[]),
    ("program", &["elementary", "units"]),
    ("model", &["program", "units"]),
    ("figure", &["units"]),
    ("engine", &["program", "units"]),
    ("ensemble", &["elementary", "engine", "program"]),
    // It opens documents and projects, reads records, and says what a fit has found as report pages do.
    ("runner", &["analysis", "document", "engine", "ensemble", "model", "program", "report", "saved", "units"]),
    ("emit", &["engine", "program"]),
    ("host", &["emit", "engine", "program"]),
    ("film", &["units"]),
    ("document", &["model", "program", "units"]),
    ("analysis", &["engine", "packed", "program", "units"]),
    ("report", &["analysis", "document", "figure", "film", "model", "packed", "program", "units"]),
    ("handed", &["units"]),
    ("play", &["engine", "figure", "handed", "program", "units"]),
    ("saved", &["document", "handed", "program", "units"]),
    (
        "desk",
        &["analysis", "document", "engine", "figure", "film", "model", "play", "program", "report", "saved", "units"],
    ),
    ("class", &["analysis", "desk", "document", "figure", "play", "program", "report", "saved", "units"]),
    ("server", &["handed", "saved", "units"]),
    ("requests", &["analysis", "document", "engine", "model", "program", "runner", "units"]),
    ("python", &["program", "requests", "runner"]),
    ("pyodide", &["engine", "host", "program", "requests", "runner"]),
    ("probe", &["analysis", "document", "engine", "figure", "film", "host", "program", "units"]),
    ("view", &["figure", "handed", "play", "program", "units"]),
    ("player", &["handed", "play", "program", "units", "view"]),
    (
        "lab",
        &["class", "desk", "document", "ejss", "figure", "film", "host", "model", "play", "program", "units", "view"],
    ),
    (
        "cli",
        &[
            "analysis",
            "catalogues",
            "class",
            "document",
            "ejss",
            "engine",
            "figure",
            "film",
            "model",
            "play",
            "program",
            "report",
            "runner",
            "saved",
            "server",
            "units",
        ],
    ),
];

/// Crates that do no I/O, read no clock and do not access the DOM. `OUTSIDE`: paths that they must not contain.
const CORE: [&str; 21] = [
    "units",
    "packed",
    "ejss",
    "elementary",
    "program",
    "model",
    "document",
    "engine",
    "ensemble",
    "runner",
    "requests",
    "emit",
    "analysis",
    "film",
    "figure",
    "report",
    "handed",
    "play",
    "saved",
    "desk",
    "class",
];
const OUTSIDE: [&str; 8] =
    ["std::fs", "std::net", "std::env", "std::process", "std::time", "std::thread", "web_sys", "js_sys"];

#[test]
fn crates_use_only_what_lies_below_them() {
    let names: Vec<&str> = ARROWS.iter().map(|(name, _)| *name).collect();
    for (name, allowed) in ARROWS {
        let manifest = fs::read_to_string(root().join("crates").join(name).join("Cargo.toml")).expect("a manifest");
        // Dependencies of tests are not restricted.
        let product = manifest.split("[dev-dependencies]").next().unwrap_or_default();
        for used in
            product.lines().filter_map(|line| line.split(['.', ' ', '=']).next()).filter(|word| names.contains(word))
        {
            assert!(allowed.contains(&used), "crates/{name} must not know {used}");
        }
    }
    let crates = fs::read_dir(root().join("crates")).expect("a directory").count();
    assert_eq!(crates, ARROWS.len(), "a new crate needs its arrows here");
}

/// The rows of the diagram of ARCHITECTURE.md: name of a crate, its letter, and the letters of the crates that it uses.
fn diagram() -> Vec<(String, char, Vec<char>)> {
    let text = fs::read_to_string(root().join("ARCHITECTURE.md")).expect("the architecture");
    let drawn = text.split("```text\n").nth(1).and_then(|rest| rest.split("```").next()).expect("the diagram");
    let mut lines = drawn.lines();
    let letters: Vec<char> = lines.next().expect("the letters").chars().collect();
    let first = letters.iter().position(|letter| *letter != ' ').expect("a letter");
    let row = |line: &str| {
        let signs: Vec<char> = line.chars().collect();
        let before: String = signs.iter().take(first).collect();
        let mut words = before.split_whitespace().rev();
        let last = words.next().filter(|_| !before.starts_with("    ") || before.trim().len() > 1)?;
        let is_letter = last.len() == 1;
        let name = if is_letter { words.next()? } else { last };
        let letter = if is_letter { last.chars().next()? } else { ' ' };
        let used = signs.iter().zip(&letters).filter(|(sign, _)| **sign == '●').map(|(_, letter)| *letter);
        Some((name.to_owned(), letter, used.collect()))
    };
    lines.filter_map(row).collect()
}

#[test]
fn the_diagram_has_all_arrows_and_none_points_upward() {
    let rows = diagram();
    assert_eq!(rows.len(), ARROWS.len(), "each crate has a row");
    for (place, (name, _, used)) in rows.iter().enumerate() {
        let of_letter = |letter: &char| rows.iter().position(|(_, own, _)| own == letter).expect("a column");
        assert!(used.iter().all(|letter| of_letter(letter) < place), "an arrow of {name} points upward");
        let mut drawn: Vec<&str> = used.iter().map(|letter| rows[of_letter(letter)].0.as_str()).collect();
        drawn.sort_unstable();
        let (_, allowed) = ARROWS.iter().find(|(own, _)| own == name).expect(name);
        assert_eq!(drawn, *allowed, "{name}");
    }
}

#[test]
fn the_core_touches_nothing_outside() {
    for name in CORE {
        let mut sources = Vec::new();
        texts(&root().join("crates").join(name).join("src"), &mut sources);
        for (path, text) in sources {
            for (number, line) in product(&text).lines().enumerate() {
                let outside = OUTSIDE.iter().find(|word| line.contains(**word) && !line.trim_start().starts_with("//"));
                assert_eq!(outside, None, "{}:{}", path.display(), number + 1);
            }
        }
    }
}
