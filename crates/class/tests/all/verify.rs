//! Verification: honest hand-ins hold, and every manipulation is found at its place.

use crate::support::{handed, measured};
use class::verify::verify;
use saved::hand_in::{Fact, FactValue, HandIn, Part};
use saved::{Item, Number};

#[test]
fn honest_hand_ins_hold_also_from_a_file() {
    for seed in 0..6 {
        let made = handed(&measured(seed), "blue heron");
        let read = HandIn::read(&made.write()).unwrap();
        let verdict = verify(&read).unwrap();
        assert!(verdict.holds(), "{verdict:?}");
        assert_eq!(verdict.equal, made.facts.len());
        assert!(made.facts.iter().any(|fact| fact.quantity == "stderr:value:gamma"), "{:?}", made.facts);
    }
}

/// Every stated number of a hand-in, changed by one bit in the last place or replaced.
#[test]
fn every_changed_value_is_found_at_its_place() {
    let honest = handed(&measured(1), "blue heron");
    for place in 0..honest.facts.len() {
        let mut changed = honest.clone();
        let fact = &mut changed.facts[place];
        fact.value = match &fact.value {
            FactValue::Number(Number(number)) => FactValue::Number(Number(f64::from_bits(number.to_bits() ^ 1))),
            FactValue::Text(text) => FactValue::Text(format!("{text}x")),
        };
        let wanted: Fact = fact.clone();
        let verdict = verify(&HandIn::read(&changed.write()).unwrap()).unwrap();
        assert_eq!(verdict.differences.len(), 1, "{wanted:?}: {verdict:?}");
        let found = &verdict.differences[0];
        assert_eq!((found.part, &found.item, &found.quantity), (wanted.part, &wanted.item, &wanted.quantity));
    }
    let mut left_out = honest.clone();
    left_out.facts.retain(|fact| fact.part != Part::Answer);
    let verdict = verify(&left_out).unwrap();
    assert!(
        !verdict.differences.is_empty() && verdict.differences.iter().all(|one| one.stated.is_none()),
        "{verdict:?}"
    );
}

/// Changes of the work: (replaced text, replacement, part in which the change must show).
#[test]
fn every_changed_datum_model_unit_and_setting_is_found() {
    let honest = handed(&measured(2), "blue heron");
    let third_row = |text: &str| text.lines().nth(3).unwrap().to_owned();
    let record = honest.work.items.iter().find(|(_, text)| text.contains("\"record\":{\"name\":\"tube.csv\"")).unwrap();
    let json: serde_json::Value = serde_json::from_str(&record.1).unwrap();
    let row = third_row(json["item"]["record"]["text"].as_str().unwrap());
    let other_row = row.replace(",0.0", ",0.1");
    assert_ne!(row, other_row);
    let cases: Vec<(String, String, Part)> = vec![
        // A datum, its unit, the use of a column.
        (row, other_row, Part::Record),
        ("y [m]".into(), "y [cm]".into(), Part::Record),
        // The window, the loss, a fixed value and the start of the fit.
        ("\"window\":[null,null]".into(), "\"window\":[null,1.0]".into(), Part::Fit),
        ("\"target\":{\"parameter\":5}".into(), "\"target\":{\"parameter\":4}".into(), Part::Fit),
        // The theory of the fit.
        ("x'' + 2*gamma*x'".into(), "x'' + 3*gamma*x'".into(), Part::Fit),
        // An answer and its grade.
        ("\"typed\":\"0.3\"".into(), "\"typed\":\"0.31\"".into(), Part::Answer),
    ];
    for (from, to, part) in cases {
        let mut changed = honest.clone();
        let mut count = 0;
        for (_, text) in &mut changed.work.items {
            let replaced = text.replace(&from, &to);
            count += usize::from(replaced != *text);
            *text = replaced;
        }
        assert!(count > 0, "{from}");
        let verdict = verify(&HandIn::read(&changed.write()).unwrap()).unwrap();
        assert!(verdict.differences.iter().any(|one| one.part == part), "{from} -> {to}: {verdict:?}");
    }
    // The document of the work.
    let mut changed = honest.clone();
    changed.work.documents[0].text = changed.work.documents[0].text.replace("Damping rate", "Damping");
    let verdict = verify(&changed).unwrap();
    assert!(verdict.differences.iter().any(|one| one.part == Part::Run && one.quantity == "document"), "{verdict:?}");
}

#[test]
fn results_with_other_bits_are_compared_within_a_tolerance() {
    let mut made = handed(&measured(3), "blue heron");
    (made.program, made.bits) = ("0.0.9".to_owned(), None);
    let gamma = made.facts.iter_mut().find(|fact| fact.quantity == "value:gamma").unwrap();
    let FactValue::Number(Number(value)) = &mut gamma.value else { panic!("a number") };
    *value *= 1.0 + 1e-9;
    let verdict = verify(&made).unwrap();
    assert!(verdict.holds() && verdict.other_bits.is_some(), "{verdict:?}");
    let gamma = made.facts.iter_mut().find(|fact| fact.quantity == "value:gamma").unwrap();
    let FactValue::Number(Number(value)) = &mut gamma.value else { panic!("a number") };
    *value *= 1.01;
    assert!(!verify(&made).unwrap().holds());
}

/// Results with the same bits are compared exactly, whatever the version.
#[test]
fn results_with_the_same_bits_are_compared_exactly() {
    let mut made = handed(&measured(3), "blue heron");
    made.program = "0.0.9".to_owned();
    assert_eq!(verify(&made).unwrap().lines(units::Language::English).len(), 1);
    let gamma = made.facts.iter_mut().find(|fact| fact.quantity == "value:gamma").unwrap();
    let FactValue::Number(Number(value)) = &mut gamma.value else { panic!("a number") };
    *value *= 1.0 + 1e-9;
    let verdict = verify(&made).unwrap();
    assert!(!verdict.holds() && verdict.other_bits.is_none(), "{verdict:?}");
}

/// Work made by version 0.2.0, which stated no bits: a run, a record, a fit, answers and a film, and a report of a fit.
#[test]
fn work_of_version_0_2_0_is_opened_and_compared_within_a_tolerance() {
    for file in ["group.hand-in", "report.html"] {
        let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/0.2.0").join(file);
        let opened = HandIn::open(&std::fs::read(path).unwrap()).unwrap();
        let verdict = verify(&opened).unwrap();
        let lines = verdict.lines(units::Language::English);
        assert!(verdict.holds() && verdict.equal > 100, "{file}: {lines:#?}");
        let reason = "made by version 0.2.0, which does not state the bits of its results";
        assert!(lines.iter().any(|line| line.starts_with(reason) && line.contains("1e-6")), "{file}: {lines:#?}");
    }
}

/// Changes to a report of version 0.2.0 beside its hashed sections, and the place that is named. Line ends are no change.
#[test]
fn changes_around_a_report_of_version_0_2_0_are_named() {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/0.2.0/report.html");
    let page = std::fs::read_to_string(path).unwrap();
    let verified = |page: &str| verify(&HandIn::open(page.as_bytes()).unwrap()).unwrap();
    assert!(verified(&page.replace('\n', "\r\n")).holds());
    for (from, to, place) in [
        ("</style>", "td { display: none }</style>", "style:1"),
        ("</head>", "<script>document.title = 1</script></head>", "foreign:1"),
        ("<body>", "<h1>g = 10.50</h1><body>", "head"),
        ("<section id=\"hand-in\">", "<section id=\"hand-in\"><h1>g = 10.50</h1>", "own-section"),
    ] {
        let verdict = verified(&page.replacen(from, to, 1));
        assert!(!verdict.holds(), "{place}");
        assert!(verdict.differences.iter().any(|one| one.quantity == place), "{place}: {:?}", verdict.differences);
    }
}

#[test]
fn hostile_work_is_refused_or_bounded() {
    let honest = handed(&measured(4), "blue heron");
    let mut broken = honest.clone();
    broken.work.documents[0].text = "```model\nx' = \n```".to_owned();
    assert!(verify(&broken).is_err());
    let mut damaged = honest.clone();
    damaged.work.items[0].1 = "{}".to_owned();
    let verdict = verify(&damaged).unwrap();
    assert!(!verdict.holds() && verdict.refused > 0, "{verdict:?}");
    // The texts of a difference are one line of bounded length.
    let mut long = honest;
    long.facts[0].item = "<script>\n".repeat(100_000);
    let verdict = verify(&long).unwrap();
    for difference in &verdict.differences {
        let text = difference.text(units::Language::English);
        assert!(text.chars().count() < 1000 && !text.contains('\n'));
    }
    assert!(Item::read("{}").is_none());
}
