//! Proposed claims: documents with their proposals beside them, documents that ship, planted errors.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by them")]

use std::path::{Path, PathBuf};

fn simulations() -> Vec<(String, String)> {
    let root = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../simulations");
    let mut documents = Vec::new();
    for folder in [root.clone(), root.join("theories")] {
        for entry in std::fs::read_dir(folder).expect("a folder") {
            let path = entry.expect("an entry").path();
            let name = path.file_name().expect("a name").to_string_lossy().into_owned();
            if name.ends_with(".md") && name.matches('.').count() == 1 {
                documents.push((name, std::fs::read_to_string(path).expect("a document")));
            }
        }
    }
    documents.sort();
    documents
}

/// Proposals as text: what holds, what is suspected and why, and what nothing tests.
fn rendered(proposed: &runner::Proposed) -> String {
    let mut text = String::new();
    for judged in &proposed.proposals {
        let proposal = &judged.proposal;
        let verdict = if judged.held { "holds" } else { "suspicion" };
        text.push_str(&format!("{verdict} {}: {}\n", proposal.key(), proposal.why.english()));
        if let Some(suspicion) = proposal.suspicion.as_ref().filter(|_| !judged.held) {
            text.push_str(&format!("  {}\n", suspicion.english()));
        }
        text.extend(proposal.lines().lines().map(|line| format!("    {line}\n")));
    }
    text.extend(proposed.untested.iter().map(|remark| format!("{}\n", remark.english())));
    text.extend(proposed.declined.iter().map(|declined| format!("declined {}: {}\n", declined.key, declined.reason)));
    text
}

/// `UPDATE_EXPECTED=1 cargo test -p runner --test proposals` writes the present proposals, for review before a commit.
#[test]
fn documents_have_the_proposals_beside_them() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../runner/tests/proposals");
    let mut names: Vec<String> = std::fs::read_dir(&folder)
        .expect("a folder")
        .map(|entry| entry.expect("an entry").file_name().to_string_lossy().into_owned())
        .filter(|name| name.ends_with(".md"))
        .collect();
    names.sort();
    assert!(names.len() >= 5, "{names:?}");
    for name in names {
        let source = std::fs::read_to_string(folder.join(&name)).expect("a document");
        let found = rendered(&runner::proposed(&source).unwrap_or_else(|| panic!("{name} has errors")));
        let beside = folder.join(name.replace(".md", ".txt"));
        if std::env::var_os("UPDATE_EXPECTED").is_some() {
            std::fs::write(&beside, &found).expect("it can be written");
        }
        assert_eq!(found, std::fs::read_to_string(&beside).unwrap_or_default(), "{name}");
    }
}

/// A suspicion about a document that ships is a fault of the document or of the proposal.
#[test]
fn nothing_is_suspected_of_the_documents_that_ship() {
    for (name, source) in simulations() {
        let proposed = runner::proposed(&source).unwrap_or_else(|| panic!("{name} has errors"));
        assert_eq!(proposed.suspicions(), 0, "{name}: {}", rendered(&proposed));
    }
}

/// Pasted lines are formatted as they are proposed, and a declined proposal stays declined.
#[test]
fn lines_can_be_pasted_and_proposals_declined() {
    let source = include_str!("proposals/spring.md");
    let proposed = runner::proposed(source).expect("a sound document");
    let proposal = &proposed.proposals.first().expect("a proposal").proposal;
    let pasted = format!("{source}\n```check\n{}\n```\n", proposal.lines());
    assert!(!document::open(&pasted, &[]).has_errors(), "{pasted}");
    let again = runner::proposed(&pasted).expect("a sound document");
    assert!(again.proposals.iter().all(|judged| judged.proposal.key() != proposal.key()), "it is claimed already");
    let declined = format!("{source}\n```check\n# declined {}: not in this lesson\n```\n", proposal.key());
    let outline = document::read(&declined);
    let edits = document::format(&outline).edits;
    let formatted = document::edit::apply(&declined, &edits).expect("edits that fit");
    let again = runner::proposed(&formatted).expect("a sound document");
    assert!(again.proposals.iter().all(|judged| judged.proposal.key() != proposal.key()));
    assert_eq!(again.declined.len(), 1, "{formatted}");
    assert_eq!(again.declined[0].reason, "not in this lesson");
}

/// The reference has a row for each kind.
#[test]
fn the_reference_lists_all_kinds() {
    let reference = include_str!("../../../docs/language.md");
    for kind in document::proposals::KINDS {
        let row = format!("| `{}` | {} |", kind.name, kind.recognises);
        assert!(reference.contains(&row), "{row}");
    }
}

/// An error planted in a document.
struct Planted<'a> {
    class: &'a str,
    document: &'a str,
    text: &'a str,
    replacement: &'a str,
}

fn planted() -> Vec<Planted<'static>> {
    let lines = include_str!("proposals/planted.txt").lines().filter(|line| !line.starts_with('#') && !line.is_empty());
    lines
        .map(|line| {
            let mut parts = line.split(" | ");
            let mut part = || parts.next().expect("four parts").trim();
            Planted { class: part(), document: part(), text: part(), replacement: part() }
        })
        .collect()
}

/// Prints how many planted errors proposals find without the claims of the authors, class by class.
#[test]
#[ignore = "a measurement: cargo test --release -p runner --test proposals planted_errors -- --ignored --nocapture"]
fn planted_errors() {
    let documents = simulations();
    let mut counts = std::collections::BTreeMap::<&str, [usize; 3]>::new();
    for one in planted() {
        let source = documents.iter().find(|(name, _)| name == one.document).map(|(_, source)| source);
        let source = source.unwrap_or_else(|| panic!("no {}", one.document));
        let model = source.find("```model").expect("a model");
        let (before, after) = source.split_at(model);
        assert!(after.contains(one.text), "{}: {}", one.document, one.text);
        let wrong = [before, &after.replacen(one.text, one.replacement, 1)].concat();
        let [units, proposals, all] = counts.entry(one.class).or_default();
        *all += 1;
        let found = runner::proposed(&wrong);
        match found.map(|proposed| proposed.suspicions()) {
            None => *units += 1,
            Some(0) => println!("missed: {} {}: {}", one.class, one.document, one.replacement),
            Some(_) => *proposals += 1,
        }
    }
    for (class, [units, proposals, all]) in counts {
        println!("{class}: {proposals} by proposals, {units} by units, of {all}");
    }
}
