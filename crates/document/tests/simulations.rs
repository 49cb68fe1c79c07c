//! The documents that come with Meniscus are without fault, in all their languages, and their numbers are sensible.

use document::{Document, Opened};
use engine::Routine;
use std::path::{Path, PathBuf};

fn directory() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../simulations")
}

/// Opens `NAME.md` with every `NAME.LANGUAGE.md` beside it.
fn open(name: &str) -> (Vec<String>, Opened) {
    let read = |file: &str| std::fs::read_to_string(directory().join(file)).unwrap();
    let mut translations: Vec<String> = std::fs::read_dir(directory())
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .filter(|file| file.starts_with(&format!("{name}.")) && *file != format!("{name}.md"))
        .collect();
    translations.sort();
    let texts: Vec<String> = translations.iter().map(|file| read(file)).collect();
    let texts: Vec<&str> = texts.iter().map(String::as_str).collect();
    let opened = document::open(&read(&format!("{name}.md")), &texts);
    (translations, opened)
}

/// A document without any finding, warnings included.
fn faultless(name: &str) -> Document {
    let (_, opened) = open(name);
    let findings: Vec<String> = (opened.diagnostics.iter())
        .map(|(file, d)| format!("{file}: {} at {:?} {:?} {:?}", d.message, d.span(), d.notes, d.hints))
        .collect();
    assert_eq!(findings, [""; 0], "{name}");
    opened.document.unwrap()
}

fn evaluate(document: &Document, roots: &[model::NodeId], parameters: &[f64]) -> Vec<f64> {
    let mut routine = Routine::compile(&document.model, roots);
    let states = document.model.states.len();
    let initial_roots: Vec<_> = document.model.states.iter().map(|state| state.initial).collect();
    let mut initial = vec![0.0; states];
    let mut starts = Routine::compile(&document.model, &initial_roots);
    starts.prepare(parameters, &vec![0.0; states]);
    starts.evaluate(0.0, &vec![0.0; states], &mut initial);
    let mut values = vec![0.0; roots.len()];
    routine.prepare(parameters, &initial);
    routine.evaluate(0.0, &initial, &mut values);
    values
}

fn defaults(document: &Document) -> Vec<f64> {
    document.model.parameters.iter().map(|parameter| parameter.value).collect()
}

/// Makes assignments one after the other.
fn assigned(document: &Document, values: &[document::Assignment]) -> Vec<f64> {
    let mut parameters = defaults(document);
    for assignment in values {
        parameters[assignment.parameter] = evaluate(document, &[assignment.value.node], &parameters)[0];
    }
    parameters
}

fn in_range(document: &Document, parameters: &[f64]) -> bool {
    document.model.parameters.iter().zip(parameters).all(|(parameter, value)| {
        parameter.range.is_none_or(|(low, high)| (low..=high).contains(value)) && value.is_finite()
    })
}

#[test]
fn every_document_is_without_fault() {
    let names: Vec<String> = std::fs::read_dir(directory())
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .filter_map(|file| file.strip_suffix(".md").map(str::to_owned))
        .filter(|name| !name.contains('.'))
        .collect();
    assert!(names.len() >= 5, "{names:?}");
    for name in names {
        let document = faultless(&name);
        assert!(document.edition(&document.language).scene.is_some(), "{name}");
        assert!(!document.plots.is_empty(), "{name}");
        for preset in &document.presets {
            assert!(in_range(&document, &assigned(&document, &preset.values)), "{name}: {}", preset.name);
        }
        for question in &document.questions {
            let parameters = assigned(&document, &question.setup);
            assert!(in_range(&document, &parameters), "{name}: {question:?}");
            let answer = evaluate(&document, &[question.answer.node], &parameters)[0];
            assert!(answer.is_finite() && answer != 0.0, "{name}: {question:?}");
        }
    }
}

#[test]
fn the_answers_of_the_u_tube() {
    let document = faultless("utube");
    let answers: Vec<f64> = (document.questions.iter())
        .map(|question| {
            let parameters = assigned(&document, &question.setup);
            question.unit.from_si(evaluate(&document, &[question.answer.node], &parameters)[0])
        })
        .collect();
    // L = 7 m, m = 350 kg, omega_0 = sqrt(2.8) = 1.67332 /s, gamma = 1/14 /s, computed by hand.
    let expected = [3.75834, 0.26845, 11.71324, 41.5443, 1.4, 17.8732, 1.56525, 1.0, 13.57043, 2.45953, 15866.8, 0.25079];
    assert_eq!(answers.len(), expected.len());
    for (answer, expected) in answers.iter().zip(expected) {
        assert!((answer / expected - 1.0).abs() < 1e-4, "{answers:?}");
    }
}

#[test]
fn critical_damping_is_within_reach_for_every_liquid() {
    let document = faultless("utube");
    let index = |name: &str| document.model.parameters.iter().position(|p| p.name == name).unwrap();
    let critical = document.model.lookup("b_c", 0).unwrap().node;
    let greatest = |name: &str| document.model.parameters[index(name)].range.unwrap().1;
    let mut parameters = defaults(&document);
    for name in ["rho", "S", "h_l", "h_r", "g"] {
        parameters[index(name)] = greatest(name);
    }
    let needed = evaluate(&document, &[critical], &parameters)[0];
    assert!(needed <= greatest("b"), "{needed}");
}
