//! Sweeps in lanes have the bits of sweeps run by run, in every value that is kept.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use document::Document;
use engine::Setup;
use runner::{Axis, Outcome, Plan, Points, Sweep, SweepCode, Values};
use std::path::Path;

/// Greatest number of rows of a run.
const ROWS: f64 = 200.0;

fn documents() -> Vec<(String, Document)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../simulations");
    let mut found = Vec::new();
    for folder in [root.clone(), root.join("theories")] {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            let name = path.file_name().unwrap().to_string_lossy().into_owned();
            let text = if name.ends_with(".md") { std::fs::read_to_string(path).unwrap() } else { continue };
            if document::translates(&text).is_none() {
                found.push((name, document::open(&text, &[]).document.unwrap()));
            }
        }
    }
    found.sort_by(|a, b| a.0.cmp(&b.0));
    found
}

/// Runs with values of one parameter around its own.
fn plan(setup: &Setup, parameter: usize) -> Plan {
    let value = setup.parameters[parameter];
    let values = Values::Range { low: 0.9 * value, high: 1.2 * value, step: None };
    Plan::new(vec![Axis { parameter, values }], Points::Random(19, 3)).unwrap()
}

fn bits(outcomes: &[Outcome]) -> Vec<(u64, Result<Vec<u64>, String>)> {
    let taken = |outcome: &Outcome| match &outcome.taken {
        Ok(values) => Ok(values.iter().map(|value| value.to_bits()).collect()),
        Err(error) => Err(format!("{error:?}")),
    };
    outcomes.iter().map(|outcome| (outcome.run, taken(outcome))).collect()
}

#[test]
fn lanes_keep_the_values_of_single_runs() {
    let mut alone = Vec::new();
    for (name, mut document) in documents() {
        let model = &document.program.model;
        let varying = model.quantities.iter().find(|quantity| quantity.varies && !quantity.remembered);
        let state = model.states.iter().find(|state| state.role != program::Role::Remembered).map(|state| state.name());
        let state = state.or(varying.map(|quantity| quantity.name.clone())).unwrap();
        let keep = format!("{state} at end, maximum({state}), mean({state}) from 1, maximum({state}) - {state} at end");
        let keep = if runner::kept(&mut document.clone(), &keep).is_ok() {
            keep
        } else {
            format!("{state} at end, maximum({state}), minimum({state})")
        };
        let outcomes = runner::kept(&mut document, &keep).unwrap_or_else(|refusal| panic!("{name}: {refusal:?}"));
        let setup = Setup::of(&document.program);
        let until = document.program.end().min(ROWS * setup.step);
        let model = &document.program.model;
        let code = SweepCode::new(model, (&setup, until), &outcomes);
        alone.extend(code.no_lanes().map(|_| name.clone()));
        let numbers = (0..model.parameters.len()).filter(|&parameter| model.parameters[parameter].is_number());
        for parameter in numbers.take(3) {
            let plan = plan(&setup, parameter);
            let compute = |code: &SweepCode| {
                bits(&Sweep::new(model, (&setup, until), &plan, (&outcomes, code)).compute(0..plan.runs()))
            };
            let (found, expected) = (compute(&code), compute(&code.clone().one_by_one()));
            assert_eq!(found.len(), 19);
            assert_eq!(found, expected, "{name}, {}", model.parameters[parameter].name);
        }
    }
    let expected =
        ["double-pendulum.md", "fourier.md", "gas.md", "logistic-map.md", "random-walk.md", "van-der-pol.md"];
    assert_eq!(alone, expected);
}
