//! A program that is written to a bundle and read back is the same: the same texts, and bit-identical runs.

use crate::simulations::{faultless, names};
use engine::checks::Checking;
use engine::{Advance, Run, Setup};
use program::{Entry, LinearSystem, NodeId, Program, bundle};

/// Number of steps whose bits are compared.
const MOST_STEPS: usize = 4000;

fn read_back(program: &Program) -> Program {
    let bytes = bundle::write(program).unwrap();
    let read = bundle::read(&bytes).unwrap();
    assert_eq!(bundle::write(&read).unwrap(), bytes);
    read
}

/// Bits of all rows of a run of 20 units of the independent variable, or of its first steps if these are very small, and of
/// all values of the scene at its end.
fn bits(program: &Program) -> Vec<u64> {
    let model = &program.model;
    let defaults = Setup::defaults(model);
    let setup = Setup {
        method: program.method.unwrap_or(defaults.method),
        step: program.step.unwrap_or(defaults.step),
        tolerance: program.tolerance.unwrap_or(defaults.tolerance),
        ..defaults
    };
    let mut run = Run::start(model, setup).unwrap();
    for _ in 0..MOST_STEPS {
        if run.time() >= 20.0 || !matches!(run.advance(), Ok(Advance::Step | Advance::Event)) {
            break;
        }
    }
    let history = run.history();
    let mut bits: Vec<u64> = Vec::new();
    for state in 0..model.states.len() {
        bits.extend(history.column(state).iter().map(|value| value.to_bits()));
    }
    let scene = program.editions.iter().filter_map(|edition| edition.scene.as_ref());
    let drawn = scene.flat_map(|scene| &scene.values).map(|value| value.node);
    let shown = drawn.chain(model.quantities.iter().map(|quantity| quantity.value.node)).collect::<Vec<_>>();
    let mut readings = engine::Readings::new(model, &shown);
    bits.extend(readings.at_row(history, history.len() - 1).iter().map(|value| value.to_bits()));
    bits
}

#[test]
fn every_simulation_is_the_same_when_it_is_read_back() {
    for name in names() {
        let program = faultless(&name).program;
        let read = read_back(&program);
        assert_eq!(bits(&program), bits(&read), "{name}");
        assert_eq!((&program.title, &program.language), (&read.title, &read.language));
        assert_eq!(program.model.parameters, read.model.parameters, "{name}");
        assert_eq!(program.model.states, read.model.states, "{name}");
        assert_eq!(program.model.quantities, read.model.quantities, "{name}");
        assert_eq!(program.model.events, read.model.events, "{name}");
        assert_eq!(program.model.texts, read.model.texts, "{name}");
        assert_eq!((&program.plots, &program.presets), (&read.plots, &read.presets), "{name}");
        assert_eq!((&program.questions, &program.checks), (&read.questions, &read.checks), "{name}");
        assert_eq!(program.survey, read.survey, "{name}");
        assert_eq!(format!("{:?}", program.editions), format!("{:?}", read.editions), "{name}");
    }
}

#[test]
fn damaged_bundles_are_refused() {
    let bytes = bundle::write(&faultless("utube").program).unwrap();
    assert_eq!(bundle::read(b"").unwrap_err(), bundle::BundleError::NoBundle);
    assert_eq!(bundle::read(b"meniscus\x0e").unwrap_err(), bundle::BundleError::OtherVersion(14));
    assert_eq!(bundle::read(&bytes[..bytes.len() - 1]).unwrap_err(), bundle::BundleError::Damaged);
    assert_eq!(bundle::read(&[&bytes[..], b"x"].concat()).unwrap_err(), bundle::BundleError::Damaged);
    // With any single wrong byte, a bundle that can be read can be run.
    for place in (9..bytes.len()).step_by(29) {
        let mut damaged = bytes.clone();
        damaged[place] ^= 0x15;
        if let Ok(program) = bundle::read(&damaged) {
            let mut setup = Setup::defaults(&program.model);
            setup.step = 0.1;
            if let Ok(mut run) = Run::start(&program.model, setup) {
                let _ = run.advance();
            }
            let _ = Checking::new().advance(&program, 1000);
        }
    }
}

#[test]
fn linear_systems_that_are_unsound_or_too_large_are_refused() {
    let program = faultless("double-pendulum").program;
    let node = NodeId(0);
    let entry = |row, column| Entry { row, column, node };
    let dense = |size: usize| {
        let entries = (0..size * size).map(|place| ((place / size, place % size), node));
        LinearSystem::new(entries, vec![node; size])
    };
    let line = |size: usize| {
        let entries =
            (0..size).flat_map(|row| (row.saturating_sub(1)..size.min(row + 2)).map(move |column| (row, column)));
        LinearSystem::new(entries.map(|place| (place, node)), vec![node; size])
    };
    for (system, numbers) in [(dense(32), Some(1024)), (dense(33), None), (line(100), Some(400))] {
        assert_eq!(system.numbers(), numbers);
    }
    let two = |entries: Vec<Entry>| LinearSystem { entries, right: vec![node; 2] };
    for (system, sound) in [
        (dense(3), true),
        (line(1000), true),
        (two(vec![entry(0, 1), entry(1, 0)]), true),
        (two(vec![entry(1, 0), entry(0, 1)]), false),
        (two(vec![entry(0, 0), entry(0, 0)]), false),
        (two(vec![entry(0, 2)]), false),
        (two(vec![entry(2, 0)]), false),
        (dense(40), false),
        (line(300_000), false),
    ] {
        let mut hostile = program.clone();
        hostile.model.graph.insert_system(system);
        assert_eq!(bundle::read(&bundle::write(&hostile).unwrap()).is_ok(), sound);
    }
}
