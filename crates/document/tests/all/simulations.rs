//! The documents of Meniscus have no errors in any of their languages, and their values are plausible.
use document::{Document, Opened};
use engine::{Routine, Run, Setup};
use std::path::{Path, PathBuf};

fn directory() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../simulations")
}

/// Opens `NAME.md` with all translations `NAME.LANGUAGE.md`.
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

/// Names of all documents of Meniscus.
pub fn names() -> Vec<String> {
    std::fs::read_dir(directory())
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .filter_map(|file| file.strip_suffix(".md").map(str::to_owned))
        .filter(|name| !name.contains('.'))
        .collect()
}

/// A document without diagnostics, including warnings.
pub fn faultless(name: &str) -> Document {
    let (_, opened) = open(name);
    let findings: Vec<String> = (opened.diagnostics.iter())
        .map(|(file, d)| format!("{file}: {} at {:?} {:?} {:?}", d.message.english(), d.span(), d.notes, d.hints))
        .collect();
    assert_eq!(findings, [""; 0], "{name}");
    opened.document.unwrap()
}

fn evaluate(document: &Document, roots: &[program::NodeId], parameters: &[f64]) -> Vec<f64> {
    let mut routine = Routine::compile(&document.program.model, roots);
    let states = document.program.model.states.len();
    let initial_roots: Vec<_> = document.program.model.states.iter().map(|state| state.initial).collect();
    let mut initial = vec![0.0; states];
    let mut starts = Routine::compile(&document.program.model, &initial_roots);
    starts.prepare(parameters, &vec![0.0; states]);
    starts.evaluate(0.0, &vec![0.0; states], &mut initial);
    let mut values = vec![0.0; roots.len()];
    routine.prepare(parameters, &initial);
    routine.evaluate(0.0, &initial, &mut values);
    values
}

fn defaults(document: &Document) -> Vec<f64> {
    document.program.model.parameters.iter().map(|parameter| parameter.value).collect()
}

/// Applies assignments in order.
fn assigned(document: &Document, values: &[program::Assignment]) -> Vec<f64> {
    let mut parameters = defaults(document);
    for assignment in values {
        parameters[assignment.parameter] = evaluate(document, &[assignment.value.node], &parameters)[0];
    }
    parameters
}

fn in_range(document: &Document, parameters: &[f64]) -> bool {
    document.program.model.parameters.iter().zip(parameters).all(|(parameter, value)| {
        parameter.range.is_none_or(|(low, high)| (low..=high).contains(value)) && value.is_finite()
    })
}

#[test]
fn every_document_is_without_fault() {
    let names = names();
    assert!(names.len() >= 5, "{names:?}");
    for name in names {
        let document = faultless(&name);
        assert!(document.program.edition(&document.program.language).scene.is_some(), "{name}");
        assert!(!document.program.plots.is_empty(), "{name}");
        for preset in &document.program.presets {
            assert!(in_range(&document, &assigned(&document, &preset.values)), "{name}: {}", preset.name);
        }
        for question in &document.program.questions {
            let parameters = assigned(&document, &question.setup);
            assert!(in_range(&document, &parameters), "{name}: {question:?}");
            for value in question.values() {
                let value = evaluate(&document, &[value.node], &parameters)[0];
                assert!(value.is_finite() && value != 0.0, "{name}: {question:?}");
            }
        }
    }
}

#[test]
fn the_answers_of_the_u_tube() {
    let document = faultless("utube");
    let answers: Vec<f64> = (document.program.questions.iter())
        .map(|question| {
            let parameters = assigned(&document, &question.setup);
            let asked = question.number().expect("a number");
            asked.unit.from_si(evaluate(&document, &[asked.right.node], &parameters)[0])
        })
        .collect();
    // L = 7 m, m = 350 kg, omega_0 = sqrt(2.8) = 1.67332 /s, gamma = 1/14 /s, computed by hand.
    let expected =
        [3.75834, 0.26845, 11.71324, 41.5443, 1.4, 17.8732, 1.56525, 1.0, 13.57043, 2.45953, 15866.8, 0.25079];
    assert_eq!(answers.len(), expected.len());
    for (answer, expected) in answers.iter().zip(expected) {
        assert!((answer / expected - 1.0).abs() < 1e-4, "{answers:?}");
    }
}

#[test]
fn critical_damping_is_within_reach_for_every_liquid() {
    let document = faultless("utube");
    let index = |name: &str| document.program.model.parameters.iter().position(|p| p.name == name).unwrap();
    let critical = document.program.model.lookup("b_c", 0).unwrap().node;
    let greatest = |name: &str| document.program.model.parameters[index(name)].range.unwrap().1;
    let mut parameters = defaults(&document);
    for name in ["rho", "S", "h_l", "h_r", "g"] {
        parameters[index(name)] = greatest(name);
    }
    let needed = evaluate(&document, &[critical], &parameters)[0];
    assert!(needed <= greatest("b"), "{needed}");
}

/// Runs a document for ten units of the independent variable.
fn run(document: &Document, parameters: Vec<f64>) -> Run {
    let mut setup = Setup::defaults(&document.program.model);
    setup.parameters = parameters;
    setup.step = document.program.step.unwrap_or(setup.step);
    setup.tolerance = document.program.tolerance.unwrap_or(setup.tolerance);
    setup.method = document.program.method.unwrap_or(setup.method);
    let mut run = Run::start(&document.program.model, setup).unwrap_or_else(|error| panic!("{error:?}"));
    while run.time() < 10.0 {
        run.advance().unwrap_or_else(|error| panic!("{error:?}"));
    }
    run
}

#[test]
fn every_document_runs_with_every_preset() {
    for name in ["utube", "pendulum", "double-pendulum", "bouncing-ball", "stick-slip", "van-der-pol"] {
        let document = faultless(name);
        run(&document, defaults(&document));
        for preset in &document.program.presets {
            eprintln!("{name}: {}", preset.name);
            run(&document, assigned(&document, &preset.values));
        }
    }
}

/// The block sticks and slips for the durations in its readouts, from the first slip on.
#[test]
fn the_block_on_the_belt_keeps_its_times() {
    let document = faultless("stick-slip");
    let model = &document.program.model;
    let of = |name: &str| model.lookup(name, 0).unwrap().node;
    let said = evaluate(&document, &[of("t_stick"), of("t_slip"), of("F_s")], &defaults(&document));
    let mut setup = Setup { tolerance: 1e-10, ..Setup::of(&document.program) };
    setup.parameters = defaults(&document);
    let mut run = Run::start(model, setup).unwrap();
    while run.time() < 30.0 {
        run.advance().unwrap();
    }
    let history = run.history();
    let motion = history.column(model.states.iter().position(|state| state.role == program::Role::Friction).unwrap());
    let changes: Vec<f64> =
        (1..history.len()).filter(|&row| motion[row] != motion[row - 1]).map(|row| history.time(row)).collect();
    assert!((changes[0] - said[2] / 10.0 / 0.1).abs() < 1e-8, "the first slip at {}", changes[0]);
    for pair in changes.windows(2).enumerate() {
        let (number, [from, to]) = pair else { unreachable!() };
        let expected = said[(number + 1) % 2];
        assert!((to - from - expected).abs() < 1e-7, "{} s instead of {expected} s", to - from);
    }
    assert!(changes.len() > 10);
}

/// The period measured in the run agrees with the readout of the pendulum, for an amplitude of 90 degrees.
#[test]
fn the_period_of_a_large_swing() {
    let document = faultless("pendulum");
    let mut parameters = defaults(&document);
    let start = document.program.model.parameters.iter().position(|p| p.name == "theta_0").unwrap();
    parameters[start] = std::f64::consts::FRAC_PI_2;
    let period = document.program.model.lookup("T", 0).unwrap().node;
    let said = evaluate(&document, &[period], &parameters)[0];
    let mut run = run(&document, parameters);
    // The angle passes through zero after a quarter of a period, downwards first, and then after each half period.
    let mut crossings = Vec::new();
    let mut state = vec![0.0; document.program.model.states.len()];
    let mut angle = |run: &mut Run, time: f64| {
        run.interpolate(time, &mut state);
        state[0]
    };
    for k in 0..99_000 {
        let (before, after) = (f64::from(k) * 1e-4, f64::from(k + 1) * 1e-4);
        let (a, b) = (angle(&mut run, before), angle(&mut run, after));
        if a > 0.0 && b <= 0.0 {
            crossings.push(before + 1e-4 * a / (a - b));
        }
    }
    let measured = (crossings.last().unwrap() - crossings[0]) / (crossings.len() - 1) as f64;
    assert!((measured / said - 1.0).abs() < 1e-5, "{measured} {said}");
}
