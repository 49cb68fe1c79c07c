//! Spanish texts of all diagnostics of the invalid models in `errors/` and `syntax_errors.txt`: no English is left, names
//! and numbers are those of the English text, and the texts are those of `spanish.txt`. `UPDATE_EXPECTED=1 cargo test -p
//! model --test all spanish` writes that file, for review before a commit.

use crate::common::catalogue::Catalogue;
use std::path::Path;

#[test]
fn every_diagnostic_is_said_in_spanish() {
    let tests = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/all");
    let mut catalogue = Catalogue::default();
    let syntax = std::fs::read_to_string(tests.join("syntax_errors.txt")).unwrap();
    for block in syntax.split("\n\n").filter(|block| block.starts_with("> ")) {
        let source: Vec<&str> = block.lines().filter_map(|line| line.strip_prefix("> ")).collect();
        let source = source.join("\n");
        catalogue.add(&model::parse(&source, std::slice::from_ref(&(0..source.len()))).1);
    }
    let mut files: Vec<_> = std::fs::read_dir(tests.join("errors")).unwrap().map(|file| file.unwrap().path()).collect();
    files.sort();
    for file in files {
        let text = std::fs::read_to_string(&file).unwrap();
        for case in text.split("## ").skip(1) {
            let source = case.split_once('\n').and_then(|(_, rest)| rest.split_once("----\n")).unwrap().0;
            catalogue.add(&model::compile(source, std::slice::from_ref(&(0..source.len()))).1);
        }
    }
    catalogue.compare(&tests.join("spanish.txt"));
}
