//! Starting estimate of a damped sinusoid, over the range of possible records.

use crate::support::{Noise, utube};
use analysis::cycles::{Estimate, estimate};

/// Record of a true curve at `rows` times over `span`.
fn record(truth: &Estimate, rows: usize, span: f64, noise: f64) -> (Vec<f64>, Vec<f64>) {
    let mut random = Noise::new(7);
    let times: Vec<f64> = (0..rows).map(|row| truth.origin + span * row as f64 / (rows - 1) as f64).collect();
    let values = times.iter().map(|time| truth.value(*time) + noise * truth.amplitude * random.normal()).collect();
    (times, values)
}

/// The root mean square distance of two estimates over the times, in amplitudes.
fn distance(one: &Estimate, other: &Estimate, times: &[f64]) -> f64 {
    let squares: f64 =
        times.iter().map(|time| (one.value(*time) - other.value(*time)) / other.amplitude).map(|d| d * d).sum();
    (squares / times.len() as f64).sqrt()
}

#[test]
fn it_lies_close_to_the_truth() {
    let truth = |frequency: f64, damping: f64, phase: f64, offset: f64| Estimate {
        origin: 0.4,
        offset,
        amplitude: 0.05,
        angular_frequency: frequency,
        damping,
        phase,
    };
    // Rows a period, periods, damping over frequency, noise over amplitude.
    for (density, periods, relative, noise) in [
        (20.0, 1.5, 0.04, 0.01),
        (20.0, 1.5, 0.1, 0.0),
        (20.0, 15.0, 0.04, 0.02),
        (20.0, 15.0, 0.04, 0.2),
        (6.0, 100.0, 0.001, 0.1),
        (20.0, 100.0, 0.0, 0.1),
        (3.5, 20.0, 0.01, 0.05),
        (200.0, 3.0, 0.3, 0.02),
        (40.0, 6.0, -0.02, 0.05),
        (200.0, 0.8, 0.0, 0.001),
    ] {
        for phase in [-3.0, -1.5, 0.0, 1.0, 2.0] {
            for offset in [0.0, -0.02, 3.0] {
                let truth = truth(9.6, 9.6 * relative, phase, offset);
                let span = periods * core::f64::consts::TAU / 9.6;
                let (times, values) = record(&truth, (density * periods) as usize, span, noise);
                let found = estimate(&times, &values).expect("there is an oscillation");
                let distance = distance(&found, &truth, &times);
                let allowed = 0.01 + noise;
                assert!(
                    distance < allowed,
                    "{density} {periods} {relative} {noise} {phase} {offset}: {distance} {found:?} {truth:?}"
                );
            }
        }
    }
}

#[test]
fn scale_and_gaps_do_not_matter() {
    let truth =
        Estimate { origin: 0.0, offset: -3e-3, amplitude: 0.056, angular_frequency: 9.6, damping: 0.39, phase: -1.6 };
    let (times, mut values) = record(&truth, 267, 8.9, 0.02);
    let found = estimate(&times, &values).expect("there is an oscillation");
    for scale in [1e-200, 1e-9, 1e6, 1e200] {
        let large: Vec<f64> = values.iter().map(|value| value * scale).collect();
        let late: Vec<f64> = times.iter().map(|time| time * 1e-3 / scale).collect();
        let other = estimate(&late, &large).expect("there is an oscillation");
        assert!((other.amplitude / (found.amplitude * scale) - 1.0).abs() < 1e-6, "{scale}: {other:?}");
        assert!((other.damping / (found.damping * scale * 1e3) - 1.0).abs() < 1e-6, "{scale}: {other:?}");
    }
    for gap in [10..26, 40..41, 60..110, 200..260] {
        values[gap].fill(f64::NAN);
        let found = estimate(&times, &values).expect("there is an oscillation");
        assert!(distance(&found, &truth, &times) < 0.02, "{found:?}");
    }
    let backwards: (Vec<f64>, Vec<f64>) = times.iter().zip(&values).rev().map(|(t, v)| (*t, *v)).unzip();
    assert_eq!(estimate(&backwards.0, &backwards.1), estimate(&times, &values));
}

#[test]
fn nothing_is_estimated_where_nothing_moves() {
    let times: Vec<f64> = (0..100).map(f64::from).collect();
    assert_eq!(estimate(&times, &[2.0; 100]), None);
    assert_eq!(estimate(&times, &[f64::NAN; 100]), None);
    assert_eq!(estimate(&[1.0; 100], &times), None);
    assert_eq!(estimate(&times[..5], &[0.0, 1.0, 0.0, -1.0, 0.0]), None);
    assert_eq!(estimate(&[], &[]), None);
}

#[test]
#[ignore = "needs the measured records in ../shared/data/utube"]
fn measured_records_are_near_their_published_fits() {
    for (name, frequency, damping, offset) in [
        ("U1", 10.553, 0.564, -3.61e-3),
        ("U2", 10.467, 0.414, -3.88e-3),
        ("U3", 9.609, 0.387, -2.69e-3),
        ("U4", 9.622, 0.383, -3.31e-3),
    ] {
        let table = utube(name);
        let found = estimate(&table[0], &table[1]).expect("there is an oscillation");
        assert!((found.angular_frequency - frequency).abs() < 0.02, "{name}: {found:?}");
        assert!((found.damping - damping).abs() < 0.02, "{name}: {found:?}");
        assert!((found.offset - offset).abs() < 1e-4, "{name}: {found:?}");
        let velocity = estimate(&table[0], &table[2]).expect("there is an oscillation");
        assert!((velocity.angular_frequency - frequency).abs() < 0.06, "{name}: {velocity:?}");
        assert!((velocity.damping - damping).abs() < 0.05, "{name}: {velocity:?}");
    }
}
