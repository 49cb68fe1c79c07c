//! Syntax errors: their exact texts (in `syntax_errors.txt`), and the tree of an invalid text.

use model::{Diagnostic, StatementKind, parse, parse_assignments, parse_expression};

/// Diagnostics of a text in the form of `syntax_errors.txt`.
fn told(source: &str, diagnostics: &[Diagnostic]) -> String {
    let mut text = String::new();
    for diagnostic in diagnostics {
        let place = &source[diagnostic.span().range()];
        text += &format!("{} `{place}`: {}\n", diagnostic.code, diagnostic.message.english());
        for label in diagnostic.labels.iter().skip(1) {
            text += &format!("    | `{}` {}\n", &source[label.span.range()], label.text.english());
        }
        for note in &diagnostic.notes {
            text += &format!("    : {}\n", note.english());
        }
        for hint in &diagnostic.hints {
            text += &format!("    -> {}\n", hint.english());
        }
        for fix in &diagnostic.fixes {
            text += &format!("    => {}\n", crate::common::applied(fix, source).replace('\n', "\\n"));
        }
    }
    text
}

#[test]
fn every_wrong_text_gets_these_words() {
    let mut cases = 0;
    let update = std::env::var_os("UPDATE_EXPECTED").is_some();
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/all/syntax_errors.txt");
    let text = std::fs::read_to_string(&path).unwrap();
    let mut updated = Vec::new();
    for block in text.trim_end().split("\n\n") {
        if !block.starts_with("> ") {
            updated.push(block.to_owned());
            continue;
        }
        let source: Vec<&str> = block.lines().filter_map(|line| line.strip_prefix("> ")).collect();
        let source = source.join("\n");
        let expected: Vec<&str> = block.lines().filter(|line| !line.starts_with("> ")).collect();
        let parsed = |source: &str| parse(source, std::slice::from_ref(&(0..source.len()))).1;
        let diagnostics = parsed(&source);
        crate::common::check_fixes(&source, &diagnostics, parsed);
        let found = told(&source, &diagnostics);
        let found = found.trim_end();
        assert!(update || found == expected.join("\n"), "{source}\n{found}");
        let source: Vec<&str> = block.lines().filter(|line| line.starts_with("> ")).collect();
        updated.push(format!("{}\n{found}", source.join("\n")));
        cases += 1;
    }
    if update {
        std::fs::write(&path, updated.join("\n\n") + "\n").unwrap();
    }
    assert!(cases > 90, "only {cases} cases were found");
}

#[test]
fn what_was_read_of_a_wrong_statement_is_kept() {
    let source = "m = rho*S*\nparameter b = 5 [foo]\ny'(0) = )\nz = 1";
    let (statements, diagnostics) = parse(source, std::slice::from_ref(&(0..source.len())));
    let codes: Vec<_> = diagnostics.iter().map(|diagnostic| diagnostic.code).collect();
    assert_eq!(codes, ["missing-expression", "unknown-unit", "missing-expression"]);
    assert_eq!(statements.len(), 4);
    assert!(matches!(&statements[0].kind, StatementKind::Definition { name, .. } if name.text == "m"));
    assert!(matches!(&statements[1].kind, StatementKind::Parameter(p) if p.name.text == "b" && p.value.is_nan()));
    assert!(matches!(&statements[2].kind, StatementKind::InitialValue { name, order: 1, .. } if name.text == "y"));
    assert!(matches!(&statements[3].kind, StatementKind::Definition { name, .. } if name.text == "z"));
}

#[test]
fn expressions_and_assignments_end_where_they_should() {
    let codes = |diagnostics: &[Diagnostic]| diagnostics.iter().map(|found| found.code).collect::<Vec<_>>();
    for (source, expected) in
        [("a + b c", "missing-operator"), ("a in [m] + b", "unexpected-token"), ("", "missing-expression")]
    {
        let (_, _, diagnostics) = parse_expression(source, 0..source.len());
        assert_eq!(codes(&diagnostics), [expected], "{source}");
    }
    for (source, expected, names) in [
        ("rho", vec!["missing-equals"], 0),
        ("rho = 1,5, b = 2", vec!["decimal-comma"], 1),
        ("rho = 1 b = 2", vec!["missing-operator", "second-equals"], 1),
        ("rho' = 1", vec!["unexpected-token"], 0),
        ("rho = \nb = 2", vec!["missing-expression"], 2),
    ] {
        let (assignments, diagnostics) = parse_assignments(source, 0..source.len());
        assert_eq!(codes(&diagnostics), expected, "{source}");
        assert_eq!(assignments.len(), names, "{source}");
    }
}

#[test]
fn no_nesting_and_no_length_exhausts_the_stack() {
    let many = 20_000;
    for source in [
        "a = ".to_owned() + &"(".repeat(many),
        "a = ".to_owned() + &"-".repeat(many) + "b",
        "a = ".to_owned() + &"not ".repeat(many) + "b",
        "a = ".to_owned() + &"√".repeat(many) + "b",
        "a = ".to_owned() + &"f(".repeat(many),
        "a = ".to_owned() + &"if b then c else ".repeat(many) + "d",
        "a = ".to_owned() + &"if ".repeat(many),
        "a = b".to_owned() + &"^b".repeat(many),
        "a = b".to_owned() + &" + b".repeat(many),
        "a = b".to_owned() + &"²".repeat(many),
        "a = b".to_owned() + &"*x²".repeat(many),
        "a = 5 [".to_owned() + &"(".repeat(many) + "m]",
        "when ".to_owned() + &"{".repeat(many),
    ] {
        let (statements, diagnostics) = parse(&source, std::slice::from_ref(&(0..source.len())));
        assert_eq!(statements.len(), 1, "{}", &source[..20]);
        assert!((1..=2).contains(&diagnostics.len()), "{} {diagnostics:?}", &source[..20]);
    }
    let long = "a = b".to_owned() + &" + b".repeat(300);
    let (_, diagnostics) = parse(&long, std::slice::from_ref(&(0..long.len())));
    assert!(diagnostics.is_empty(), "{diagnostics:?}");
}
