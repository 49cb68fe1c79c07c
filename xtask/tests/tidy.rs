//! What no compiler checks: the arrows between the crates, what the core must not touch, long files, and paths of
//! somebody's machine.

#![allow(clippy::expect_used, clippy::panic, reason = "a test that cannot go on has failed")]

use std::fs;
use std::path::{Path, PathBuf};

/// Which crates of the workspace each may use. The walls between them are the design (ARCHITECTURE.md).
const ARROWS: [(&str, &[&str]); 15] = [
    ("units", &[]),
    ("program", &["units"]),
    ("model", &["program", "units"]),
    ("figure", &["units"]),
    ("engine", &["program", "units"]),
    ("document", &["model", "program", "units"]),
    ("analysis", &["engine", "program", "units"]),
    ("report", &["analysis", "document", "figure", "model", "program", "units"]),
    ("play", &["engine", "figure", "program", "units"]),
    ("desk", &["analysis", "document", "engine", "figure", "play", "program", "report", "units"]),
    ("probe", &["analysis", "document", "engine", "figure", "program", "units"]),
    ("view", &["figure", "play", "program", "units"]),
    ("player", &["play", "program", "units", "view"]),
    ("lab", &["desk", "document", "figure", "model", "play", "program", "units", "view"]),
    ("cli", &["analysis", "document", "engine", "figure", "model", "program", "report", "units"]),
];

/// The crates that do no I/O, read no clock and touch no DOM.
const CORE: [&str; 10] =
    ["units", "program", "model", "document", "engine", "analysis", "figure", "report", "play", "desk"];
const OUTSIDE: [&str; 8] =
    ["std::fs", "std::net", "std::env", "std::process", "std::time", "std::thread", "web_sys", "js_sys"];

/// Lines of a file, without its unit tests.
const LONGEST: usize = 500;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..").canonicalize().expect("the workspace is there")
}

/// All texts below a directory, without what is built or installed.
fn texts(directory: &Path, found: &mut Vec<(PathBuf, String)>) {
    for entry in fs::read_dir(directory).expect("a directory") {
        let path = entry.expect("an entry").path();
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        if path.is_dir() {
            if !["target", "node_modules", ".git", "corpus", "artifacts"].contains(&name.as_str()) {
                texts(&path, found);
            }
        } else if let Ok(text) = fs::read_to_string(&path) {
            found.push((path, text));
        }
    }
}

fn all_texts() -> Vec<(PathBuf, String)> {
    let mut found = Vec::new();
    texts(&root(), &mut found);
    found
}

/// A source without the unit tests at its end.
fn product(text: &str) -> &str {
    text.split("#[cfg(test)]\nmod tests").next().unwrap_or_default()
}

fn holds(path: &Path, ending: &str) -> bool {
    path.extension().is_some_and(|own| own == ending)
}

#[test]
fn crates_use_only_what_lies_below_them() {
    let names: Vec<&str> = ARROWS.iter().map(|(name, _)| *name).collect();
    for (name, allowed) in ARROWS {
        let manifest = fs::read_to_string(root().join("crates").join(name).join("Cargo.toml")).expect("a manifest");
        // Tests may look anywhere: only the part before them counts.
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

#[test]
fn files_hold_one_subject() {
    let long: Vec<String> = (all_texts().iter())
        .filter(|(path, _)| ["rs", "mjs", "css"].iter().any(|ending| holds(path, ending)))
        .map(|(path, text)| (path, product(text).lines().count()))
        .filter(|&(_, lines)| lines > LONGEST)
        .map(|(path, lines)| format!("{} has {lines} lines", path.display()))
        .collect();
    assert!(long.is_empty(), "split what is not one subject: {long:#?}");
}

#[test]
fn no_path_of_a_machine_is_left() {
    let root = root();
    let mut places = vec![root.display().to_string()];
    // Homes as short as `/root` stand in paths that mean something else.
    places.extend(std::env::var("HOME").ok().filter(|home| home.len() > 1).map(|home| format!("{home}/")));
    for (path, text) in all_texts() {
        let found = places.iter().find(|place| text.contains(place.as_str()));
        assert_eq!(found, None, "in {}", path.display());
    }
}
