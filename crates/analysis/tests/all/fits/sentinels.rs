//! Values that stand for a missing measurement: they are reported as outliers, and good values are not.

use crate::support::Noise;
use crate::support::fitting::{DAMPED_COSINE, DAMPED_COSINE_NAMES, model, observation, record, task, value};
use analysis::fit::{Fit, Loss, Outcome, Task, Verdict};
use units::Language;

/// Fit of 100 good values, of which some rows are replaced.
fn fit(loss: Loss, replaced: &[(usize, f64)]) -> Outcome {
    let model = model(DAMPED_COSINE);
    let mut noise = Noise::new(9);
    let times: Vec<f64> = (0..100).map(|row| f64::from(row) / 30.0).collect();
    let truth = |time: f64| 0.05 * libm::exp(-0.4 * time) * libm::cos(9.6 * time + 0.5) + 0.002;
    let mut values: Vec<f64> = times.iter().map(|time| truth(*time) + 5e-4 * noise.normal()).collect();
    replaced.iter().for_each(|&(row, value)| values[row] = value);
    let record = record(vec![observation(&model, "y", 0, &times, &values)]);
    let task = task(&model, record, &DAMPED_COSINE_NAMES);
    let mut fit = Fit::new(&model, Task { loss, ..task }).unwrap();
    fit.complete();
    fit.outcome().unwrap()
}

#[test]
fn the_sentinel_is_named_and_no_good_value() {
    for loss in [Loss::Squares, Loss::Huber, Loss::Tukey] {
        for sentinel in [9999.0, -3.0] {
            for rows in [&[0][..], &[40], &[99], &[15, 40, 41, 75]] {
                let outcome = fit(loss, &rows.iter().map(|&row| (row, sentinel)).collect::<Vec<_>>());
                let named: Vec<usize> = outcome.outliers.iter().map(|one| one.row).collect();
                assert_eq!(named, rows, "{loss:?} {sentinel}");
                assert!(outcome.outliers.iter().all(|one| one.sigmas * sentinel > 0.0));
                assert_eq!(outcome.misled, outcome.verdict() == Verdict::Misled);
                // A fit that is not misled has found the true values.
                assert!(
                    outcome.misled || (value(&outcome, "gamma") - 0.4).abs() < 0.02,
                    "{loss:?} {sentinel} {rows:?}"
                );
            }
        }
    }
    let misled = fit(Loss::Squares, &[(40, 9999.0)]);
    assert!(misled.misled);
    assert_eq!(
        [Language::English, catalogues::with(Language::Spanish)].map(|language| misled.verdict_text(language)),
        [
            "The curve misses the data: the RMS residual of y is 2175 times its swing from peak to peak. The residuals cannot be \
             used to judge the model: outliers dominate the fit.",
            "La curva no coincide con los datos: el residuo RMS de y es 2175 veces su amplitud de pico a pico. Los residuos no \
             sirven para juzgar el modelo: los valores atípicos dominan el ajuste.",
        ]
    );
    assert!(!fit(Loss::Huber, &[(40, 9999.0)]).misled);
}

/// The other minima of least squares are not minima of a robust loss.
#[test]
fn a_robust_loss_has_no_rival_of_least_squares() {
    assert!(fit(Loss::Squares, &[(40, 9999.0)]).rival.is_some());
    assert!(fit(Loss::Tukey, &[(40, 9999.0)]).rival.is_none());
}

/// A curve that describes all values is not misled, however far away one is.
#[test]
fn a_first_value_far_from_the_others_may_be_right() {
    let model = model("parameter A = 1 [m]\nparameter gamma = 2 [1/s]\ny = A*exp(-gamma*t)");
    let times: Vec<f64> = (0..20).map(f64::from).collect();
    let values: Vec<f64> = times.iter().map(|time| 2.0 * libm::exp(-3.0 * time)).collect();
    let record = record(vec![observation(&model, "y", 0, &times, &values)]);
    let mut fit = Fit::new(&model, task(&model, record, &["A", "gamma"])).unwrap();
    fit.complete();
    let outcome = fit.outcome().unwrap();
    assert!(outcome.outliers.is_empty() && !outcome.misled, "{:?}", outcome.outliers);
}
