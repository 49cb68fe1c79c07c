//! Spanish texts of all diagnostics of the documents in `wrong.txt`, and of all refused edits: no English is left, names
//! and numbers are those of the English text, and the texts are those of `spanish.txt`. `UPDATE_EXPECTED=1 cargo test -p
//! document --test all spanish` writes that file, for review before a commit.

use crate::catalogue::Catalogue;
use document::edit::{EditError, Obstacle};
use model::{Diagnostic, Span};
use std::path::Path;

#[test]
fn every_finding_is_said_in_spanish() {
    let tests = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/all");
    let mut catalogue = Catalogue::default();
    for case in std::fs::read_to_string(tests.join("wrong.txt")).unwrap().split("\n## ").skip(1) {
        let (title, text) = case.split_once('\n').unwrap();
        let (source, translation) = text.split_once("\n----\n").unwrap_or((text, ""));
        let translations: &[&str] = if translation.is_empty() { &[] } else { &[translation] };
        let found = document::open(source, translations).diagnostics;
        assert!(!found.is_empty(), "{title}: nothing is said");
        catalogue.add(&found.into_iter().map(|(_, diagnostic)| diagnostic).collect::<Vec<_>>());
    }
    let refusals = [
        EditError::Place(Span::new(2, 3)),
        EditError::Overlap(Span::new(2, 3)),
        EditError::TooLong,
        EditError::UnknownParameter("b".to_owned()),
        EditError::UnreadableParameter("b".to_owned()),
        EditError::NotANumber("1,5".to_owned()),
        EditError::Key("a b".to_owned()),
        EditError::Value(String::new()),
        EditError::UnknownBlock(4),
        EditError::ChangesOthers,
        EditError::NotOneCell(Obstacle::Empty),
        EditError::NotOneCell(Obstacle::LineEnd),
        EditError::NotOneCell(Obstacle::Mark("]".to_owned())),
        EditError::NotOneElement(Obstacle::Other),
    ];
    catalogue.add(&refusals.map(|refusal| Diagnostic::error("edit", refusal.words(), Span::default())));
    catalogue.compare(&tests.join("spanish.txt"));
}
