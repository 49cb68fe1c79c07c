//! Fits that end at a frequency above half the sample rate, which residuals cannot show.

use crate::support::fitting::{fitted, model, observation, record, task, value};

/// A damped cosine of 1 Hz.
fn swing(time: f64) -> f64 {
    0.05 * libm::exp(-0.1 * time) * libm::cos(core::f64::consts::TAU * time + 0.5) + 0.002
}

/// Fit of it from a start at `start` Hz: the frequency found, and the records that are undersampled.
fn found(times: &[f64], start: f64) -> (f64, Vec<usize>) {
    let text = format!(
        "parameter A = 0.05 [m]\nparameter gamma = 0.1 [1/s]\nparameter f = {start} [Hz]\nparameter phi = 0.5\n\
         parameter c = 0.002 [m]\ny = A*exp(-gamma*t)*cos(2*pi*f*t + phi) + c"
    );
    let model = model(&text);
    let values: Vec<f64> = times.iter().map(|time| swing(*time)).collect();
    let record = record(vec![observation(&model, "y", 0, times, &values)]);
    let outcome = fitted(&model, task(&model, record, &["A", "gamma", "f", "phi", "c"]));
    (value(&outcome, "f").abs(), outcome.undersampled)
}

fn samples(rate: f64, count: u32) -> Vec<f64> {
    (0..count).map(|row| f64::from(row) / rate).collect()
}

#[test]
fn an_alias_is_named() {
    for (rate, count, start, alias) in
        [(3.0, 60, 4.0, 4.0), (3.0, 60, 2.0, 2.0), (3.0, 60, 49.0, 49.0), (30.0, 200, 31.0, 31.0)]
    {
        let (frequency, undersampled) = found(&samples(rate, count), start);
        assert!((frequency - alias).abs() < 1e-3, "{rate} {start}: {frequency}");
        assert_eq!(undersampled, [0], "{rate} {start}");
    }
    // Missing frames do not change the step.
    let mut times = samples(3.0, 60);
    [40, 23, 22, 7].into_iter().for_each(|row| _ = times.remove(row));
    assert_eq!(found(&times, 4.0).1, [0]);
}

#[test]
fn an_oscillation_below_half_the_sampling_rate_is_none() {
    for (rate, count) in [(30.0, 200), (3.0, 60), (2.2, 60), (2.02, 30), (30.0, 12)] {
        let (frequency, undersampled) = found(&samples(rate, count), 1.0);
        assert!((frequency - 1.0).abs() < 1e-3, "{rate}: {frequency}");
        assert!(undersampled.is_empty(), "{rate}");
    }
}

/// Samples at uneven times distinguish a fast oscillation from a slow one.
#[test]
fn uneven_samples_have_no_alias() {
    let times: Vec<f64> = (0..60).map(|row| f64::from(row) + 0.3 * libm::sin(2.4 * f64::from(row))).collect();
    let (frequency, undersampled) = found(&times, 1.0);
    assert!((frequency - 1.0).abs() < 1e-3, "{frequency}");
    assert!(undersampled.is_empty());
}
