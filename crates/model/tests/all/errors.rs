//! Invalid models and their diagnostics. Each file in `errors/` has cases of one subject: a title after `## `, the model, a
//! line of dashes, the diagnostics. `UPDATE_EXPECTED=1 cargo test -p model --test all errors` writes the present
//! diagnostics into the files, for review before a commit.

use std::fmt::Write;
use std::path::Path;

const DASHES: &str = "----\n";

/// Compares the cases of a file with the present diagnostics.
#[track_caller]
fn check(file: &str) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/all/errors").join(file);
    let text = std::fs::read_to_string(&path).unwrap();
    let mut found = String::new();
    for case in text.split("## ").skip(1) {
        let (title, rest) = case.split_once('\n').unwrap();
        let (source, _) = rest.split_once(DASHES).unwrap_or_else(|| panic!("{title}: no dashes"));
        let diagnostics = crate::common::diagnostics(source);
        assert!(!diagnostics.is_empty(), "{title}: nothing is said");
        writeln!(found, "## {title}\n{source}{DASHES}{diagnostics}").unwrap();
    }
    let found = found.trim_end().to_owned() + "\n";
    if std::env::var_os("UPDATE_EXPECTED").is_some() {
        std::fs::write(&path, found).unwrap();
    } else if found != text {
        let differing = found.lines().zip(text.lines()).position(|(found, expected)| found != expected);
        panic!("{file}, line {}:\n{found}", differing.map_or(0, |line| line + 1));
    }
}

#[test]
fn assigned() {
    check("assigned.txt");
}

#[test]
fn chance() {
    check("chance.txt");
}

#[test]
fn maps() {
    check("maps.txt");
}

#[test]
fn names() {
    check("names.txt");
}

#[test]
fn choices() {
    check("choices.txt");
}

#[test]
fn functions() {
    check("functions.txt");
}

#[test]
fn parameters() {
    check("parameters.txt");
}

#[test]
fn unknowns() {
    check("unknowns.txt");
}

#[test]
fn initial_values() {
    check("initial_values.txt");
}

#[test]
fn dimensions() {
    check("dimensions.txt");
}

#[test]
fn kinds() {
    check("kinds.txt");
}

#[test]
fn highest_derivatives() {
    check("highest_derivatives.txt");
}

#[test]
fn events() {
    check("events.txt");
}

#[test]
fn friction() {
    check("friction.txt");
}

#[test]
fn vectors() {
    check("vectors.txt");
}

#[test]
fn families() {
    check("families.txt");
}

#[test]
fn tables() {
    check("tables.txt");
}
