//! Fits whose sum of squares has several minima: further searches if the model has events or branches, and restarts from a
//! lower minimum found by a profile.

use super::kinks::theory;
use crate::support::fitting::{fitted, model, observation, record, task, value};
use crate::support::{Noise, utube};
use analysis::fit::{Fit, Task, profiles};
use engine::{Method, Run, Setup};
use program::Model;

const NAMES: [&str; 6] = ["L", "gamma", "mu", "y_0", "v_0", "c"];

fn dry(model: &Model, times: &[f64], values: &[f64]) -> Task {
    task(model, record(vec![observation(model, "y", 0, times, values)]), &NAMES)
}

/// From the first crossing of the rest level after 1 s, without starting values.
#[test]
#[ignore = "needs the measured records in ../shared/data/utube"]
fn dry_friction_is_found_in_measured_columns() {
    let model = theory("dry-friction");
    for (name, from, most) in [("U1", 1.3, 0.594e-3), ("U2", 1.2, 0.888e-3)] {
        let columns = utube(name);
        let outcome = fitted(&model, Task { from: Some(from), ..dry(&model, &columns[0], &columns[1]) });
        assert!(outcome.rmse <= most, "{name}: {:e}", outcome.rmse);
        assert!(outcome.starts > 4, "{}", outcome.starts);
    }
}

/// Columns that come to rest by dry friction: the fit from the document's own values is at least as good as that from the
/// true values.
#[test]
fn dry_friction_is_found_as_well_as_from_the_truth() {
    let model = theory("dry-friction");
    let truth = [0.17, 0.25, 0.06, 0.03, 0.1, -0.003];
    let mut setup = Setup { method: Method::DormandPrince, step: 1.0 / 30.0, ..Setup::defaults(&model) };
    let place = |name: &str| model.parameters.iter().position(|parameter| parameter.name == name).unwrap();
    NAMES.iter().zip(truth).for_each(|(name, value)| setup.parameters[place(name)] = value);
    let mut run = Run::start(&model, setup).unwrap();
    (0..150).for_each(|_| {
        run.advance().unwrap();
    });
    let x = model.states.iter().position(|state| state.name() == "x").unwrap();
    let history = run.history();
    let on_grid = |row: &usize| (history.time(*row) * 30.0 - (history.time(*row) * 30.0).round()).abs() < 1e-9;
    let rows: Vec<usize> = (0..history.len()).filter(on_grid).collect();
    let times: Vec<f64> = rows.iter().map(|&row| history.time(row)).collect();
    for seed in [1, 2] {
        let mut noise = Noise::new(seed);
        let values: Vec<f64> =
            rows.iter().map(|&row| history.column(x)[row] + truth[5] + 6e-4 * noise.normal()).collect();
        let found = fitted(&model, dry(&model, &times, &values));
        let mut from_truth = Fit::again(&model, dry(&model, &times, &values), &truth).unwrap();
        from_truth.complete();
        let best = from_truth.outcome().unwrap().chi2;
        assert!(found.chi2 <= best * (1.0 + 1e-6), "seed {seed}: {} {best}", found.chi2);
    }
}

/// A smooth model is searched from one start, if that explains the data.
#[test]
fn a_smooth_model_is_not_tried_from_elsewhere() {
    let times: Vec<f64> = (0..100).map(|row| f64::from(row) / 20.0).collect();
    let mut noise = Noise::new(3);
    let values: Vec<f64> =
        times.iter().map(|t| 0.05 * libm::exp(-0.4 * t) * libm::cos(9.0 * t) + 1e-3 * noise.normal()).collect();
    for (text, starts) in [
        ("y = A*exp(-gamma*t)*cos(omega*t)", 1..=1),
        ("y = A*exp(-abs(gamma)*t)*cos(omega*t)", 2..=9),
        ("y = A*exp(-gamma*t)*cos(omega*t) + (if A > 9 [m] then 1 [m] else 0 [m])", 2..=9),
        // Branches that are not part of the curve do not count.
        ("y = A*exp(-gamma*t)*cos(omega*t)\nregime = if gamma > omega then 1 else 0", 1..=1),
    ] {
        let head = "parameter A = 0.04 [m]\nparameter gamma = 0.3 [1/s]\nparameter omega = 8.8 [1/s]\n";
        let model = model(&[head, text].concat());
        let one = record(vec![observation(&model, "y", 0, &times, &values)]);
        let outcome = fitted(&model, task(&model, one, &["A", "gamma", "omega"]));
        assert!(starts.contains(&outcome.starts), "{text}: {}", outcome.starts);
        assert!((value(&outcome, "omega") - 9.0).abs() < 0.1 && outcome.rival.is_none(), "{text}");
    }
}

/// A start at a wrong frequency leads to a local minimum; the profile finds the lower one.
#[test]
fn a_profile_that_meets_a_lower_minimum_goes_there() {
    let model = model("parameter omega = 1 [1/s]\ny = sin(omega*t)*(1 [m])");
    let times: Vec<f64> = (0..20).map(|row| f64::from(row) * 0.3).collect();
    let mut state = 1_u64;
    let disturbed = |time: &f64| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        libm::sin(2.0 * time) + 2.0 * ((state >> 33) as f64 / f64::from(1_u32 << 31) - 0.5)
    };
    let values: Vec<f64> = times.iter().map(disturbed).collect();
    let task = task(&model, record(vec![observation(&model, "y", 0, &times, &values)]), &["omega"]);
    let mut fit = Fit::again(&model, task, &[3.17]).unwrap();
    fit.complete();
    let mut outcome = fit.outcome().unwrap();
    assert!(outcome.converged && (value(&outcome, "omega") - 3.17).abs() < 0.05);
    let before = outcome.chi2;
    let intervals = profiles(&mut fit, &mut outcome);
    assert!(outcome.improved > 0 && outcome.converged && outcome.chi2 < 0.5 * before);
    assert!((value(&outcome, "omega") - 2.0).abs() < 0.05, "{}", value(&outcome, "omega"));
    for interval in intervals[0].unwrap() {
        let (low, high) = (interval.low.unwrap(), interval.high.unwrap());
        assert!(low < value(&outcome, "omega") && value(&outcome, "omega") < high, "{interval:?}");
    }
}
