//! The motion of translated documents beside values that were computed independently: by an evaluator of the JavaScript of the
//! simulations, in which definitions follow the states at once.

use crate::support::{Simulation, folder, import, simulations};
use ejss::{Imported, Section};
use engine::{Readings, Run, Setup};

/// Value of a variable of the simulation at a row of the document's run.
fn value(imported: &Imported, rows: usize, variable: &str) -> f64 {
    let of_table = |original: &&ejss::Original| {
        original.section == Section::Variables && original.source.split(" =").next() == Some(variable)
    };
    let name = &imported.originals.iter().find(of_table).expect(variable).name;
    let program = document::open(&imported.document, &[]).sound().expect("a document").program;
    let mut run = Run::start(&program.model, Setup::of(&program)).expect("a run");
    let until = rows as f64 * program.step.expect("a step");
    while run.time() < until - 1e-9 {
        run.advance().unwrap_or_else(|error| panic!("{variable}: {error:?}"));
    }
    // Events at this time.
    run.finish(until).unwrap_or_else(|error| panic!("{variable}: {error:?}"));
    let node = program.model.lookup(name, 0).expect(name).node;
    let mut readings = Readings::new(&program.model, &[node]);
    readings.at(run.parameters(), run.initial(), run.time(), run.state())[0]
}

#[test]
fn simulations_move_as_expected() {
    let random = std::fs::read_to_string(folder("random.txt")).expect("the simulations");
    let random = random
        .split("=====\n")
        .map(|text| (text.lines().next().unwrap_or_default().to_owned(), Simulation::read(text)));
    let mut wrong = Vec::new();
    let mut count = 0;
    for (name, simulation) in simulations().into_iter().chain(random) {
        let Some((until, values)) = simulation.expected() else { continue };
        let imported = import(simulation.ejss().as_bytes()).expect(&name);
        if imported.listed_because.is_some() {
            wrong.push(format!("{name} is listed"));
            continue;
        }
        let step = document::open(&imported.document, &[]).sound().expect(&name).program.step.expect(&name);
        for (state, expected) in values {
            let found = value(&imported, (until / step).round() as usize, &state);
            count += 1;
            if (found - expected).abs() > 1e-5 * expected.abs().max(1.0) {
                wrong.push(format!("{name}: {state} is {found}, expected {expected}"));
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
    assert!(count > 200, "{count} values");
}
