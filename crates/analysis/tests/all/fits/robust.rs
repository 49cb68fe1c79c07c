//! Robust losses: published results, good values, and outliers.

use crate::support::Noise;
use crate::support::fitting::{fitted, model, observation, record, task, value};
use analysis::fit::{Fit, Loss, Outcome, Task, Verdict};
use std::fmt::Write;

const LINE: &str = "parameter a = 1 [m]\nparameter s = 0 [m/s]\ny = a + s*t";

fn with(loss: Loss, task: &Task) -> Task {
    Task { loss, ..task.clone() }
}

/// Stack loss data of Brownlee (1965), with the output of the function `rlm` of Venables & Ripley's package MASS (Modern
/// Applied Statistics with S, 2002, section 6.5).
#[test]
fn published_results_are_found() {
    let flow = [80, 80, 75, 62, 62, 62, 62, 62, 58, 58, 58, 58, 58, 58, 50, 50, 50, 50, 50, 56, 70];
    let water = [27, 27, 25, 24, 22, 23, 24, 24, 23, 18, 18, 17, 18, 19, 18, 18, 19, 19, 20, 20, 20];
    let acid = [89, 88, 90, 87, 87, 87, 93, 93, 87, 80, 89, 88, 82, 93, 89, 86, 72, 79, 80, 82, 91];
    let lost = [42, 37, 37, 28, 18, 18, 19, 20, 15, 14, 14, 13, 11, 12, 8, 7, 8, 8, 9, 15, 15];
    // The row is the time.
    let mut text = "parameter a = 0\nparameter b = 0\nparameter c = 0\nparameter d = 0\n".to_owned();
    for (name, column) in [("p", flow), ("q", water), ("r", acid)] {
        let terms: Vec<String> = column
            .iter()
            .enumerate()
            .map(|(row, value)| {
                let (before, after) = (row as f64 - 0.5, row as f64 + 0.5);
                format!("(if t > {before} [s] and t < {after} [s] then {value} else 0)")
            })
            .collect();
        writeln!(text, "{name} = {}", terms.join(" + ")).unwrap();
    }
    text.push_str("y = a + b*p + c*q + d*r\n");
    let model = model(&text);
    let times: Vec<f64> = (0..21).map(f64::from).collect();
    let values: Vec<f64> = lost.map(f64::from).to_vec();
    let task = task(&model, record(vec![observation(&model, "y", 0, &times, &values)]), &["a", "b", "c", "d"]);
    // Values, standard errors, and the scale of the residuals.
    for (loss, expected, errors, scale) in [
        (Loss::Squares, [-39.9197, 0.7156, 1.2953, -0.1521], [11.8960, 0.1349, 0.3680, 0.1563], None),
        (Loss::Huber, [-41.0265, 0.8294, 0.9261, -0.1278], [9.8073, 0.1112, 0.3034, 0.1289], Some(2.441)),
        (Loss::Tukey, [-42.2853, 0.9275, 0.6507, -0.1123], [9.5045, 0.1077, 0.2940, 0.1249], Some(2.282)),
    ] {
        let outcome = fitted(&model, with(loss, &task));
        for ((name, expected), error) in ["a", "b", "c", "d"].into_iter().zip(expected).zip(errors) {
            let found = value(&outcome, name);
            assert!((found - expected).abs() < 1e-3 * expected.abs().max(1.0), "{loss:?} {name}: {found} {expected}");
            // The package takes the variance of the slopes with n - 1 instead of n.
            let found = outcome.estimate(name).unwrap().stderr.unwrap();
            assert!((found / error - 1.0).abs() < 5e-3, "{loss:?} {name}: {found} {error}");
        }
        let found = outcome.reweighted.as_ref().map(|robust| robust.scale);
        assert!(found.zip(scale).is_none_or(|(found, scale)| (found - scale).abs() < 2e-3), "{loss:?}: {found:?}");
        assert_eq!(found.is_some(), scale.is_some());
        // The least-squares estimate is reported beside it.
        if let Some(robust) = &outcome.reweighted {
            assert!((robust.least_squares[0] + 39.9197).abs() < 1e-3);
            assert!(outcome.r2.is_nan() && outcome.aicc.unwrap().is_finite());
        }
    }
}

/// For normal errors a robust loss finds nearly the same values, with errors larger by 1/sqrt(0.95) and the same coverage.
#[test]
fn good_values_lose_little() {
    let model = model(LINE);
    let times: Vec<f64> = (0..100).map(|row| f64::from(row) / 30.0).collect();
    let mut noise = Noise::new(6);
    let mut ratios = [0.0; 2];
    let mut inside = [0; 2];
    let records = 200;
    for _ in 0..records {
        let values: Vec<f64> = times.iter().map(|time| 2.0 - 0.3 * time + 0.01 * noise.normal()).collect();
        let task = task(&model, record(vec![observation(&model, "y", 0, &times, &values)]), &["a", "s"]);
        let squares = fitted(&model, task.clone());
        for (place, loss) in [Loss::Huber, Loss::Tukey].into_iter().enumerate() {
            let robust = fitted(&model, with(loss, &task));
            let [one, other] = [&robust, &squares].map(|outcome| outcome.estimate("s").unwrap().clone());
            assert!((one.value - other.value).abs() < 1.5 * other.stderr.unwrap(), "{one:?} {other:?}");
            ratios[place] += one.stderr.unwrap() / other.stderr.unwrap() / f64::from(records);
            inside[place] += i32::from((one.value + 0.3).abs() <= one.stderr_hac.unwrap());
        }
    }
    assert!(ratios.iter().all(|ratio| (1.0..1.07).contains(ratio)), "{ratios:?}");
    assert!(inside.iter().all(|inside| (120..=150).contains(inside)), "{inside:?}");
}

/// A tenth of the values are off to one side: the true values are found, within the errors.
#[test]
fn bad_values_do_little_harm() {
    let model = model(
        "
parameter A = 0.05 [m]
parameter gamma = 0.3 [1/s]
parameter k = 90 [s^-2]
x'' = -2*gamma*x' - k*x
x(0) = A
x'(0) = 0
",
    );
    let times: Vec<f64> = (0..150).map(|row| f64::from(row) / 30.0).collect();
    let omega = libm::sqrt(92.16 - 0.16);
    let truth = |t: f64| 0.05 * libm::exp(-0.4 * t) * (libm::cos(omega * t) + 0.4 / omega * libm::sin(omega * t));
    let mut noise = Noise::new(8);
    let values: Vec<f64> = (times.iter().enumerate())
        .map(|(row, time)| truth(*time) + 5e-4 * noise.normal() + if row % 10 == 3 { 6e-3 } else { 0.0 })
        .collect();
    let task = task(&model, record(vec![observation(&model, "x", 0, &times, &values)]), &["A", "gamma", "k"]);
    let off = |outcome: &Outcome, name: &str, truth: f64| (value(outcome, name) / truth - 1.0).abs();
    let squares = fitted(&model, task.clone());
    for loss in [Loss::Huber, Loss::Tukey] {
        let robust = fitted(&model, with(loss, &task));
        for (name, truth) in [("A", 0.05), ("gamma", 0.4), ("k", 92.16)] {
            let estimate = robust.estimate(name).unwrap();
            assert!((estimate.value - truth).abs() < 4.0 * estimate.stderr_hac.unwrap(), "{loss:?} {estimate:?}");
        }
        assert!(off(&robust, "gamma", 0.4) < 0.05 && off(&robust, "A", 0.05) < 0.02, "{loss:?}");
        let robust_scale = robust.reweighted.as_ref().unwrap();
        assert!(robust_scale.half >= 15 && robust_scale.scale < 8e-4, "{robust_scale:?}");
        let rows: Vec<usize> = robust.outliers.iter().map(|one| one.row).collect();
        assert_eq!(rows, (0..15).map(|one| 10 * one + 3).collect::<Vec<_>>(), "{loss:?}");
        assert_eq!(robust.verdict(), Verdict::Compatible);
        // A fit resumed from its answer gives the same answer.
        if loss == Loss::Huber {
            continue;
        }
        let found: Vec<f64> = robust.parameters.iter().map(|one| one.value).collect();
        let mut again = Fit::again(&model, with(loss, &task), &found).unwrap();
        again.complete();
        let again = again.outcome().unwrap();
        for (one, other) in robust.parameters.iter().zip(&again.parameters) {
            assert!((one.value - other.value).abs() < 1e-3 * one.stderr.unwrap(), "{loss:?} {one:?} {other:?}");
        }
    }
    // Least squares has errors that are several times larger.
    let error = |outcome: &Outcome| outcome.estimate("gamma").unwrap().stderr.unwrap();
    let robust = fitted(&model, with(Loss::Tukey, &task));
    assert!(error(&squares) > 2.5 * error(&robust), "{} {}", error(&squares), error(&robust));
}

/// Theories are ranked by the same likelihood: the true one first, with and without outliers.
#[test]
fn theories_are_ranked_with_outliers() {
    let line = model(LINE);
    let parabola = model("parameter a = 1 [m]\nparameter s = 0 [m/s]\nparameter b = 0 [m/s^2]\ny = a + s*t + b*t^2");
    let times: Vec<f64> = (0..100).map(|row| f64::from(row) / 30.0).collect();
    let mut noise = Noise::new(17);
    for loss in [Loss::Huber, Loss::Tukey] {
        let mut values: Vec<f64> = times.iter().map(|t| 2.0 - 0.3 * t + 0.05 * t * t + 0.01 * noise.normal()).collect();
        (values[20], values[70]) = (7.0, -3.0);
        let fit = |model, names: &[&str]| {
            fitted(model, with(loss, &task(model, record(vec![observation(model, "y", 0, &times, &values)]), names)))
        };
        let (wrong, right) = (fit(&line, &["a", "s"]), fit(&parabola, &["a", "s", "b"]));
        assert!(wrong.aicc.unwrap() > right.aicc.unwrap() + 10.0, "{loss:?} {:?} {:?}", wrong.aicc, right.aicc);
    }
}
