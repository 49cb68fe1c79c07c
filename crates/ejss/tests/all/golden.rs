//! The document of each simulation of the folder, byte for byte, from both formats. `GOLDEN=write` replaces the documents:
//! read them before they are committed.

use crate::support::{folder, import, simulations, utf16};

#[test]
fn both_formats_give_the_expected_document() {
    let writes = std::env::var_os("GOLDEN").is_some();
    let mut wrong = Vec::new();
    for (name, simulation) in simulations() {
        let of_xml = import(&utf16(&simulation.ejss(), true)).expect(&name);
        let of_json = import(&utf16(&simulation.json(), false)).expect(&name);
        assert_eq!(of_xml.document, of_json.document, "{name}");
        let path = folder("simulations").join(format!("{name}.md"));
        if writes {
            std::fs::write(&path, &of_xml.document).expect("a document");
        } else if std::fs::read_to_string(&path).expect("a document") != of_xml.document {
            wrong.push(name);
        }
    }
    assert!(wrong.is_empty(), "other documents than expected: {wrong:?}");
}

#[test]
fn documents_pass_check_and_have_short_lines() {
    for (name, simulation) in simulations() {
        let imported = import(simulation.ejss().as_bytes()).expect(&name);
        let opened = document::open(&imported.document, &[]);
        let errors: Vec<String> = opened.diagnostics.iter().map(|(_, found)| found.message.english()).collect();
        assert!(!opened.has_errors(), "{name}: {errors:?}");
        assert!(imported.document.lines().all(|line| line.chars().count() <= 200), "{name}");
        assert!(!imported.document.to_lowercase().contains("<script"), "{name}");
    }
}

#[test]
fn entries_lead_to_their_lines() {
    for (name, simulation) in simulations() {
        let imported = import(simulation.ejss().as_bytes()).expect(&name);
        for entry in imported.report.entries() {
            let line = entry.document_line.expect(&name);
            let text = imported.document.lines().nth(line - 1).expect(&name);
            assert!(text.starts_with("- "), "{name}: {text}");
        }
    }
}

#[test]
fn arrays_and_code_of_the_evolution_are_listed_with_the_reason() {
    let reason = |wanted: &str| {
        let (_, simulation) = simulations().into_iter().find(|(name, _)| name == wanted).expect(wanted);
        let imported = import(simulation.ejss().as_bytes()).expect(wanted);
        imported.listed_because.map(|why| why.english()).unwrap_or_default()
    };
    assert_eq!(reason("04-chain"), "the state x is an array");
    assert_eq!(reason("06-decay"), "it has no page of differential equations");
    assert_eq!(reason("10-wrap"), "code runs after each step (page \"wrap\" of the evolution)");
}
