//! Fits of columns that come to rest by dry friction, whose sum of squares has a kink wherever the number of half
//! oscillations changes.

use crate::support::Noise;
use crate::support::fitting::{model, observation, record, task};
use analysis::fit::{Fit, Task};
use engine::{Method, Run, Setup};
use program::Model;
use std::path::Path;

/// A theory that ships, as its document states it.
pub fn theory(name: &str) -> Model {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../simulations/theories").join(format!("{name}.md"));
    let text = std::fs::read_to_string(path).unwrap();
    model(text.split_once("```model").unwrap().1.split_once("```").unwrap().0)
}

/// The level that a theory gives with these parameters, at `rate` values a second for `duration` seconds, with noise of
/// standard deviation `noise`, m.
pub fn level(
    model: &Model,
    parameters: &[(&str, f64)],
    (rate, duration): (f64, f64),
    (noise, seed): (f64, u64),
) -> (Vec<f64>, Vec<f64>) {
    let mut setup = Setup { method: Method::DormandPrince, step: 1.0 / rate, ..Setup::defaults(model) };
    let place = |name: &str| model.parameters.iter().position(|parameter| parameter.name == name).unwrap();
    parameters.iter().for_each(|(name, value)| setup.parameters[place(name)] = *value);
    let c = setup.parameters[place("c")];
    let mut run = Run::start(model, setup).unwrap();
    let rows = (rate * duration) as usize;
    for _ in 0..rows {
        run.advance().unwrap();
    }
    let x = model.states.iter().position(|state| state.name() == "x").unwrap();
    let history = run.history();
    let on_grid = |row: &usize| (history.time(*row) * rate - (history.time(*row) * rate).round()).abs() < 1e-9;
    let rows: Vec<usize> = (0..history.len()).filter(on_grid).collect();
    let mut random = Noise::new(seed);
    let times = rows.iter().map(|&row| history.time(row)).collect();
    (times, rows.iter().map(|&row| history.column(x)[row] + c + noise * random.normal()).collect())
}

const NAMES: [&str; 6] = ["L", "gamma", "mu", "y_0", "c", "v_0"];

/// Record of dry friction with random parameters for each seed: the task, the true values, and true if `v_0` is fixed.
fn dry(model: &Model, seed: u64) -> (Task, Vec<f64>) {
    let mut random = Noise::new(1000 + seed);
    let mut between = |low: f64, high: f64| low + (high - low) * random.uniform();
    let held = seed.is_multiple_of(2);
    let [l, gamma, y_0] = [between(0.18, 0.32), between(0.05, 0.5), between(0.02, 0.05)];
    // Number of half oscillations without the other friction.
    let mu = 9.8 / l * y_0 / libm::exp(between(1.0, 3.2));
    let y_0 = if seed.is_multiple_of(3) { -y_0 } else { y_0 };
    let (c, v_0) = (between(-0.004, 0.004), if held { 0.0 } else { between(-0.2, 0.2) });
    let truth = [l, gamma, mu, y_0, c, v_0];
    let sampling = ([30.0, 50.0, 60.0][(seed % 3) as usize], between(5.0, 8.0));
    let values: Vec<(&str, f64)> = NAMES.into_iter().zip(truth).collect();
    let (times, values) = level(model, &values, sampling, (3e-4, seed));
    let names = if held { &NAMES[..5] } else { &NAMES[..] };
    (task(model, record(vec![observation(model, "y", 0, &times, &values)]), names), truth[..names.len()].to_vec())
}

/// Sum of squares of a fit from the document's own values, divided by that of a fit from the true values.
fn found(model: &Model, seed: u64) -> f64 {
    let (task, truth) = dry(model, seed);
    let mut fit = Fit::new(model, task.clone()).unwrap();
    fit.complete();
    let trials = fit.trials();
    let outcome = fit.outcome().unwrap();
    let mut known = Fit::again(model, task, &truth).unwrap();
    known.complete();
    let ratio = outcome.chi2 / known.outcome().unwrap().chi2;
    println!(
        "seed {seed:3}: {ratio:.6}, rmse {:.3e}, converged {}, {} starts, {trials} trials",
        outcome.rmse, outcome.converged, outcome.starts
    );
    ratio
}

#[test]
fn dry_friction_is_found() {
    let model = theory("dry-friction");
    // For the first two of these, the search from the own values alone ends in another minimum.
    for seed in [4, 18, 9, 12] {
        let ratio = found(&model, seed);
        assert!(ratio < 1.0 + 1e-6, "seed {seed}: {ratio}");
    }
}

#[test]
#[ignore = "takes minutes"]
fn dry_friction_is_found_in_thirty_of_thirty() {
    let model = theory("dry-friction");
    let count = (1..=30).filter(|&seed| found(&model, seed) < 1.0 + 1e-6).count();
    assert_eq!(count, 30);
}
