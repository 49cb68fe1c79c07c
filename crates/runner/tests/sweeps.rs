//! Sweeps in lanes have the bits of sweeps run by run, in every value that is kept.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use document::Document;
use engine::Setup;
use runner::{Axis, Plan, Points, Sweep, SweepCode, Taken, Values};
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

/// Bits of the values of each of `count` numbers, and the errors of the runs.
fn bits(taken: &Taken, count: usize) -> (Vec<Vec<u64>>, String) {
    let bits = |number: usize| taken.values(number).map(f64::to_bits).collect();
    ((0..count).map(bits).collect(), format!("{:?}", taken.errors()))
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
                let taken = Sweep::new(model, (&setup, until), &plan, (&outcomes, code)).compute(0..plan.runs());
                bits(&taken, outcomes.curves.len())
            };
            let (found, expected) = (compute(&code), compute(&code.clone().one_by_one()));
            assert!(found.0.iter().all(|values| values.len() == 19));
            assert_eq!(found, expected, "{name}, {}", model.parameters[parameter].name);
        }
    }
    assert_eq!(alone, ["double-pendulum.md", "fourier.md", "logistic-map.md", "van-der-pol.md"]);
}

/// Of 19 runs those fail whose state becomes infinite. Their values are gaps, in lanes and run by run.
#[test]
fn runs_that_fail_leave_gaps() {
    let text = "---\nuntil: 1 [s]\nstep: 0.05\n---\n\n```model\nparameter a = 1\nx' = 1 [1/s]*a*x^2\nx(0) = 1\n```\n";
    let mut document = document::open(text, &[]).document.unwrap();
    let outcomes = runner::kept(&mut document, "x at end, maximum(x)").unwrap();
    for method in [engine::Method::DormandPrince, engine::Method::RungeKutta4] {
        let setup = Setup { method, ..Setup::of(&document.program) };
        let values = Values::Range { low: 0.0, high: 90.0, step: Some(5.0) };
        let plan = Plan::new(vec![Axis { parameter: 0, values }], Points::Grid).unwrap();
        let model = &document.program.model;
        let code = SweepCode::new(model, (&setup, 1.0), &outcomes);
        assert_eq!(code.no_lanes(), None);
        let compute = |code: &SweepCode| {
            let taken = Sweep::new(model, (&setup, 1.0), &plan, (&outcomes, code)).compute(3..19);
            let failed: Vec<u64> = taken.errors().iter().map(|(run, _)| *run).collect();
            for number in 0..2 {
                let gaps = (taken.runs().zip(taken.values(number))).filter(|(_, value)| value.is_nan());
                assert_eq!(gaps.map(|(run, _)| run).collect::<Vec<_>>(), failed, "{method:?}");
            }
            assert!(!failed.is_empty(), "{method:?}");
            bits(&taken, 2)
        };
        assert_eq!(compute(&code), compute(&code.clone().one_by_one()), "{method:?}");
    }
}
