//! The documents that ship.

use crate::compare::{lanes, rows, single};
use engine::{Method, Setup};
use ensemble::Features;
use program::{NodeId, Program};
use std::path::Path;

/// Greatest number of rows of a run.
const ROWS: f64 = 300.0;

/// Documents with events in these rows, after which a lane comes back.
const EVENTFUL: [&str; 3] = ["bouncing-ball", "stick-slip", "decay-chain"];

fn programs(folder: &str) -> Vec<(String, Program)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
    let mut paths: Vec<_> = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    paths.retain(|path| path.extension().is_some_and(|ending| ending == "md"));
    paths.sort();
    let base = |text: &str| document::translates(text).is_none();
    let texts = paths.into_iter().map(|path| (path.clone(), std::fs::read_to_string(path).unwrap()));
    texts
        .filter(|(_, text)| base(text))
        .map(|(path, text)| {
            let name = path.file_stem().unwrap().to_string_lossy().into_owned();
            (name, document::open(&text, &[]).document.unwrap().program)
        })
        .collect()
}

/// Parameters of runs: each is varied once around its value, so that the runs differ in all that they can.
fn varied(setup: &Setup, runs: usize) -> Vec<Vec<f64>> {
    let count = setup.parameters.len().max(1);
    let parameters = |run: usize| {
        let mut parameters = setup.parameters.clone();
        if let Some(value) = parameters.get_mut(run % count) {
            *value *= 1.0 + 0.07 * (run / count) as f64 + 0.013 * (run % 5) as f64;
        }
        parameters
    };
    (0..runs).map(parameters).collect()
}

fn nodes(program: &Program) -> Vec<NodeId> {
    let states = program.model.states.iter().map(|state| state.derivative);
    let quantities = program.model.quantities.iter().map(|quantity| quantity.value.node);
    states.chain(quantities).take(12).collect()
}

/// Compares runs in lanes with single runs; returns why there are no lanes.
pub fn compare(
    name: &str,
    program: &Program,
    setup: &Setup,
    parameters: &[Vec<f64>],
    nodes: &[NodeId],
    features: Features,
) -> Option<String> {
    let until = program.end().min(ROWS * setup.step);
    let found = match lanes(&program.model, (setup, until), nodes, parameters, features) {
        Ok(found) => found,
        Err(reason) => return Some(format!("{reason:?}")),
    };
    assert_eq!(found.len(), parameters.len());
    for (run, (parameters, found)) in parameters.iter().zip(found).enumerate() {
        let setup = Setup { parameters: parameters.clone(), ..setup.clone() };
        let expected = single(&program.model, &setup, until, nodes);
        assert!(found.1 == expected.1, "{name}, run {run}: {:?} instead of {:?}", found.1, expected.1);
        let first = found.0.iter().zip(&expected.0).position(|(found, expected)| found != expected);
        assert_eq!((first, found.0.len()), (None, expected.0.len()), "{name}, run {run}");
    }
    None
}

#[test]
fn documents_have_the_bits_of_single_runs() {
    let mut alone = Vec::new();
    for (name, program) in programs("../../simulations").into_iter().chain(programs("../../simulations/theories")) {
        let mut setup = Setup::of(&program);
        let read = nodes(&program);
        let reason = compare(&name, &program, &setup, &varied(&setup, 11), &read, Features::Best);
        if let Some(reason) = reason {
            alone.push(format!("{name}: {reason}"));
            continue;
        }
        compare(&name, &program, &setup, &varied(&setup, 4), &[], Features::Least);
        if EVENTFUL.contains(&name.as_str()) {
            let until = program.end().min(ROWS * setup.step);
            let rows = rows(&program.model, &setup, until);
            assert!(rows as f64 > until / setup.step + 2.0, "{name} has no events in {rows} rows");
        }
        for method in [Method::Euler, Method::EulerRichardson, Method::VelocityVerlet, Method::RungeKutta4] {
            setup.method = method;
            compare(&name, &program, &setup, &varied(&setup, 9), &read, Features::Avx2);
            compare(&name, &program, &setup, &varied(&setup, 3), &[], Features::Best);
        }
    }
    let expected = [
        "double-pendulum: Interpreted(LinearSystem)",
        "fourier: ChangesInTime",
        "logistic-map: Interpreted(Counting)",
        "van-der-pol: Interpreted(Method(Rosenbrock))",
    ];
    assert_eq!(alone, expected);
}
