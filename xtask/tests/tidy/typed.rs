//! Numbers that a person types are read by `units::number::typed` alone: each refusal says what was not understood, and
//! nothing is replaced in silence.

use crate::texts::{all_texts, root};
use std::collections::BTreeSet;

/// Crates with the fields of the page.
const FIELDS: [&str; 3] = ["crates/lab/src", "crates/view/src", "crates/player/src"];

/// Files of these crates that make numbers of texts that no person types: positions in lists and of sliders, ids of elements,
/// keys of the storage, and view boxes of drawings.
const OF_THE_PAGE: [&str; 20] = [
    "crates/lab/src/class/curves.rs",
    "crates/lab/src/film/stage.rs",
    "crates/lab/src/fit/setup.rs",
    "crates/lab/src/library/list.rs",
    "crates/lab/src/measuring/cycles.rs",
    "crates/lab/src/measuring/derivatives.rs",
    "crates/lab/src/measuring/records.rs",
    "crates/lab/src/write/kept.rs",
    "crates/lab/src/write/tools.rs",
    "crates/lab/src/write/translation.rs",
    "crates/lab/src/write/versions.rs",
    "crates/lab/src/write/view/drawing/pointing.rs",
    "crates/lab/src/write/view/drawing/seen.rs",
    "crates/lab/src/write/view/drawing/tools.rs",
    "crates/view/src/browser.rs",
    "crates/view/src/controls/choices.rs",
    "crates/view/src/controls/mod.rs",
    "crates/view/src/controls/parameters.rs",
    "crates/view/src/stage/ruler.rs",
    "crates/view/src/stage/transport.rs",
];

/// Files that divide a typed text at the number with which it begins, before its parts are read.
const DIVIDING: [&str; 1] = ["crates/play/src/questions/answer.rs"];

fn files_with(folders: &[&str], marks: &[&str]) -> BTreeSet<String> {
    let root = root();
    let texts = all_texts().into_iter().filter_map(|(path, text)| {
        let file = path.strip_prefix(&root).ok()?.to_string_lossy().replace('\\', "/");
        let is_rust = file.ends_with(".rs") && folders.iter().any(|folder| file.starts_with(folder));
        (is_rust && marks.iter().any(|mark| text.contains(mark))).then_some(file)
    });
    texts.collect()
}

#[test]
fn fields_of_numbers_have_one_reader() {
    let found = files_with(&FIELDS, &[".parse()", "parse::<", "value_as_number", "number::decimal"]);
    let known: BTreeSet<String> = OF_THE_PAGE.map(str::to_owned).into();
    let new: Vec<_> = found.difference(&known).collect();
    assert!(
        new.is_empty(),
        "these read numbers of a text themselves; a typed one is read by units::number::typed: {new:?}"
    );
    let gone: Vec<_> = known.difference(&found).collect();
    assert!(gone.is_empty(), "these read no numbers any more: {gone:?}");
}

#[test]
fn typed_numbers_are_not_divided_elsewhere() {
    let folders = [&FIELDS[..], &["crates/play/src", "crates/desk/src", "crates/class/src"]].concat();
    let found = files_with(&folders, &["number::parse(", "number::parse;", "number::{parse"]);
    assert_eq!(found, DIVIDING.map(str::to_owned).into());
}
