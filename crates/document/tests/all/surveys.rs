//! Surveys: what is read, translations, layout, and bundles.

use document::{format, open, read};
use program::{Program, SurveyItem, SurveyKind, SurveyText, bundle};

const DOCUMENT: &str = include_str!("../../../../tests/page/surveyed.md");
const SPANISH: &str = include_str!("../../../../tests/page/surveyed.es.md");

fn opened(source: &str, translations: &[&str]) -> (Program, Vec<String>) {
    let opened = open(source, translations);
    let findings = opened.diagnostics.iter().map(|(file, one)| format!("{file}: {}", one.message.english())).collect();
    (opened.document.expect("a model without errors").program, findings)
}

fn text(asked: &str, words: &[&str]) -> SurveyText {
    SurveyText { asked: asked.to_owned(), words: words.iter().map(|&word| word.to_owned()).collect() }
}

#[test]
fn items_are_read_and_translated() {
    let (program, findings) = opened(DOCUMENT, &[SPANISH]);
    assert_eq!(findings, [""; 0]);
    let item = |kind, answers| SurveyItem { kind, answers };
    let expected = [(SurveyKind::Role, 2), (SurveyKind::Scale, 5), (SurveyKind::Choice, 2), (SurveyKind::Text, 0)];
    assert_eq!(program.survey, expected.map(|(kind, answers)| item(kind, answers)));
    assert_eq!(*program.survey_text("en", 1), text("It was clear", &["disagree", "agree"]));
    assert_eq!(*program.survey_text("es", 2), text("¿Qué ayudó más?", &["dibujo", "gráficas"]));
    assert_eq!(*program.survey_text("de", 3), text("What would you change?", &[]));
}

#[test]
fn a_faulty_item_is_left_out_and_its_translation_too() {
    let wrong = DOCUMENT.replace("5 steps", "99 steps");
    let (program, findings) = opened(&wrong, &[SPANISH]);
    assert_eq!(findings, ["0: a scale has 2 to 11 steps"]);
    assert_eq!(program.survey.len(), 3);
    assert_eq!(*program.survey_text("es", 1), text("¿Qué ayudó más?", &["dibujo", "gráficas"]));
    let other = SPANISH.replace("5 steps", "4 steps");
    let (program, findings) = opened(DOCUMENT, &[&other]);
    assert_eq!(findings, ["1: item 2 of the original is a `scale` of 5 steps"]);
    assert_eq!(program.survey_text("es", 1).asked, "It was clear", "the original stands in for it");
}

#[test]
fn numbers_and_lengths_are_bounded() {
    let document = |survey: &str| format!("```model\ny' = -y/(1 [s])\ny(0) = 1\n```\n```survey\n{survey}\n```\n");
    let items = |count: usize| (0..count).map(|index| format!("text \"{index}\"\n")).collect::<String>();
    let words = |count: usize| (0..count).map(|index| format!("\"{index}\"")).collect::<Vec<_>>().join(", ");
    for (survey, count, finding) in [
        (items(50), 50, None),
        (items(51), 50, Some("0: a survey cannot have more than 50 items")),
        (format!("choice \"A\": {}", words(20)), 1, None),
        (format!("choice \"A\": {}", words(21)), 0, Some("0: there must be 2 to 20 alternatives")),
        (format!("text \"{}\"", "é".repeat(300)), 1, None),
        (format!("text \"{}\"", "é".repeat(301)), 0, Some("0: a text of a survey has at most 300 characters")),
        ("scale \"A\": 11 steps from \"a\" to \"b\"".to_owned(), 1, None),
        (
            "scale \"A\": 18446744073709551616 steps from \"a\" to \"b\"".to_owned(),
            0,
            Some("0: a scale has 2 to 11 steps"),
        ),
    ] {
        let (program, findings) = opened(&document(&survey), &[]);
        assert_eq!((program.survey.len(), findings.first().map(String::as_str)), (count, finding), "{survey:.60}");
    }
}

#[test]
fn other_words_for_kinds_have_a_remedy() {
    for (written, meant) in
        [("escala", "scale"), ("Opción", "choice"), ("comentario", "text"), ("scal", "scale"), ("rol", "role")]
    {
        let source = DOCUMENT.replace("text \"What", &format!("{written} \"What"));
        let found = open(&source, &[]).diagnostics;
        let [(0, only)] = found.as_slice() else { panic!("{found:?}") };
        let mended = document::edit::apply(&source, &only.fixes[0].edits).unwrap();
        assert_eq!(mended, DOCUMENT.replace("text \"What", &format!("{meant} \"What")), "{written}");
    }
}

#[test]
fn the_layout_is_kept_and_careless_blanks_are_put_right() {
    let formatted = |text: &str| document::edit::apply(text, &format(&read(text)).edits).unwrap();
    for document in [DOCUMENT, SPANISH] {
        assert_eq!(formatted(document), document);
    }
    let careless =
        DOCUMENT.replace("5 steps from", "5   steps  from").replace("\"plots\"", "  \"plots\"   # the curves");
    let once = formatted(&careless);
    assert_eq!(formatted(&once), once);
    assert!(once.contains("# the curves"));
    let survey = |text: &str| (opened(text, &[]).0.survey, opened(text, &[]).0.editions[0].survey.clone());
    assert_eq!(survey(&once), survey(DOCUMENT));
}

#[test]
fn a_bundle_has_the_survey_and_wrong_numbers_are_refused() {
    let (program, _) = opened(DOCUMENT, &[SPANISH]);
    let again = bundle::read(&bundle::write(&program).unwrap()).unwrap();
    assert_eq!(again.survey, program.survey);
    for language in ["en", "es"] {
        assert_eq!(again.edition(language).survey, program.edition(language).survey);
    }
    let changes: [fn(&mut Program); 6] = [
        |program| program.survey.push(SurveyItem { kind: SurveyKind::Text, answers: 0 }),
        |program| program.survey[0].answers = 3,
        |program| program.survey[1].answers = 1 << 40,
        |program| program.survey[3].answers = 1,
        |program| program.editions[1].survey[1].words.clear(),
        |program| program.editions[0].survey.clear(),
    ];
    for (index, change) in changes.iter().enumerate() {
        let mut hostile = program.clone();
        change(&mut hostile);
        assert_eq!(bundle::write(&hostile), Err(bundle::BundleError::Damaged), "{index}");
    }
}
