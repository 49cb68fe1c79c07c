//! The documents that ship, with their own method and with all others.

use crate::compare::{Compared, Emit, compare, compare_side_by_side};
use engine::{Method, Setup};
use std::path::PathBuf;

/// Rows of each run.
const ROWS: usize = 300;

/// Texts of all documents by name.
fn documents() -> Vec<(String, String)> {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../simulations");
    let mut found = Vec::new();
    for folder in [folder.clone(), folder.join("theories")] {
        for entry in std::fs::read_dir(folder).expect("a folder") {
            let path = entry.expect("an entry").path();
            let name = path.file_name().expect("a name").to_string_lossy().into_owned();
            if name.ends_with(".md") && !name.ends_with(".es.md") {
                found.push((name, std::fs::read_to_string(path).expect("a text")));
            }
        }
    }
    found.sort();
    found
}

fn compare_document(text: &str, method: Option<Method>, emit: Emit) -> Compared {
    let document = document::open(text, &[]).document.expect("a document without errors");
    let mut setup = Setup::of(&document.program);
    setup.method = method.unwrap_or(setup.method);
    compare(&document.program.model, setup, emit, ROWS)
}

#[test]
fn the_documents_run_with_the_same_bits_in_emitted_code() {
    let mut interpreted = Vec::new();
    for (name, text) in documents() {
        println!("{name}");
        match compare_document(&text, None, emit::module) {
            Compared::Rows(rows) => assert!(rows > 100, "{name}: {rows} rows"),
            Compared::Interpreted(reason) => interpreted.push(format!("{name}: {reason}")),
        }
    }
    let expected =
        ["double-pendulum.md: LinearSystem", "logistic-map.md: Counting", "van-der-pol.md: Method(Rosenbrock)"];
    assert_eq!(interpreted, expected);
}

#[test]
fn each_method_has_the_same_bits_in_emitted_code() {
    let documents = documents();
    let text = |name: &str| &documents.iter().find(|(known, _)| known == name).expect("a document").1;
    for name in ["utube.md", "pendulum.md", "bouncing-ball.md"] {
        for method in Method::ALL.into_iter().filter(|&method| method != Method::Rosenbrock) {
            println!("{name}, {method:?}");
            assert!(
                matches!(compare_document(text(name), Some(method), emit::module), Compared::Rows(rows) if rows > ROWS / 2)
            );
        }
    }
    let stiff = compare_document(text("utube.md"), Some(Method::Rosenbrock), emit::module);
    assert_eq!(stiff, Compared::Interpreted("Method(Rosenbrock)".to_owned()));
}

#[test]
fn loops_over_lists_have_the_same_bits() {
    let documents = documents();
    let text = |name: &str| &documents.iter().find(|(known, _)| known == name).expect("a document").1;
    // Many equal parts, also some that are none, and events; states that stay constant; tables; changes of discrete values.
    for name in ["chain.md", "string.md", "three-bodies.md", "stick-slip.md", "driven-pendulum.md", "decay-chain.md"] {
        for method in Method::ALL.into_iter().filter(|&method| method != Method::Rosenbrock) {
            println!("{name}, {method:?}");
            let compared = compare_document(text(name), Some(method), emit::module_of_lists);
            assert!(matches!(compared, Compared::Rows(rows) if rows > ROWS / 2 || method == Method::VelocityVerlet));
        }
    }
}

#[test]
fn runs_side_by_side_have_the_same_bits() {
    let mut smooth = Vec::new();
    for (name, text) in documents() {
        let program = document::open(&text, &[]).document.expect("a document without errors").program;
        let compared = |method: Method| {
            println!("{name}, {method:?}");
            compare_side_by_side(&program.model, &Setup { method, ..Setup::of(&program) }, ROWS)
        };
        let Some(rows) = compared(Method::RungeKutta4) else { continue };
        for method in [Method::Euler, Method::EulerRichardson, Method::VelocityVerlet] {
            assert!(compared(method).is_none_or(|of_method| of_method == rows));
        }
        assert_eq!(rows, 3 * (ROWS + 1));
        smooth.push(name);
    }
    // All others have events or changes at fixed times, or no states.
    let expected = [
        "coupled-oscillators.md",
        "linear-quadratic.md",
        "linear.md",
        "power-law.md",
        "quadratic.md",
        "rlc.md",
        "saturating-spring.md",
        "tube.md",
        "utube.md",
        "van-der-pol.md",
    ];
    assert_eq!(smooth, expected);
}

#[test]
fn adaptive_runs_side_by_side_have_the_same_bits() {
    let mut one_by_one = Vec::new();
    for (name, text) in documents() {
        let program = document::open(&text, &[]).document.expect("a document without errors").program;
        println!("{name}");
        let setup = Setup { method: Method::DormandPrince, ..Setup::of(&program) };
        match compare_side_by_side(&program.model, &setup, ROWS) {
            Some(rows) => assert!(rows > 100, "{name}: {rows} rows"),
            None => one_by_one.push(name.clone()),
        }
    }
    // Discrete time, linear systems, changes that are not linear in time, too many operations, or no states.
    let expected =
        ["cosine.md", "double-pendulum.md", "fourier.md", "gas.md", "logistic-map.md", "random-walk.md", "string.md"];
    assert_eq!(one_by_one, expected);
}
