//! Check that the laboratory has a title for each code of a diagnostic.

use crate::texts::{product, root, texts};

/// File with the titles, as patterns of a `match`.
const TITLES: &str = "crates/lab/src/documents/titles.rs";
/// Least number of codes that this check must find in order to be one.
const LEAST: usize = 100;

#[test]
fn every_code_has_a_title_of_its_own() {
    let titles = std::fs::read_to_string(root().join(TITLES)).expect("the file of the titles");
    let mut sources = Vec::new();
    ["crates/model/src", "crates/document/src"].iter().for_each(|folder| texts(&root().join(folder), &mut sources));
    let mut codes = Vec::new();
    for (_, text) in &sources {
        for start in ["Diagnostic::error(", "Diagnostic::warning("] {
            let calls = product(text).split(start).skip(1).filter_map(|call| call.trim_start().strip_prefix('"'));
            codes.extend(calls.filter_map(|call| call.split('"').next()));
        }
    }
    assert!(codes.len() > LEAST, "only {} codes were found", codes.len());
    codes.retain(|code| !titles.contains(&format!("\"{code}\"")));
    assert!(codes.is_empty(), "codes without a title in {TITLES}: {codes:?}");
}
