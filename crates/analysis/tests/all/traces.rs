//! The fitted curve between the values, and its uncertainty.
use crate::support::fitting::{model, observation, record, task};
use analysis::fit::Fit;

/// Straight line with scatter, and an offset.
#[test]
fn the_curve_goes_on_between_the_values() {
    let model = model("parameter a = 0 [m]\nparameter b = 0 [m/s]\ny = a + b*t");
    let times: Vec<f64> = (0..40).map(|row| 1.0 + 0.1 * f64::from(row)).collect();
    let scatter = |row: usize| [0.01, -0.02, 0.015, 0.0, -0.005][(row * row) % 5];
    let values: Vec<f64> = times.iter().enumerate().map(|(row, time)| 0.5 - 0.2 * time + scatter(row)).collect();
    let mut fit =
        Fit::new(&model, task(&model, record(vec![observation(&model, "y", 0, &times, &values)]), &["a", "b"]))
            .unwrap();
    fit.complete();
    let outcome = fit.outcome().unwrap();
    let traces = fit.traces(79);
    assert_eq!((traces.len(), traces[0].record, traces[0].observation), (1, 0, 0));
    let trace = &traces[0];
    for (row, fitted) in outcome.observations[0].fitted.iter().enumerate() {
        assert!((trace.times[2 * row] - times[row]).abs() < 1e-12);
        assert!((trace.values[2 * row] - fitted).abs() < 1e-12);
    }
    // From the covariance of a and b, the error of a + b t is that of a at t = 0, and smallest near the middle.
    let [a, b] = ["a", "b"].map(|name| outcome.estimate(name).unwrap().stderr_hac.unwrap());
    let variance = |time: f64| {
        let row = trace.times.iter().position(|t| (t - time).abs() < 1e-9).unwrap();
        trace.stderr[row] * trace.stderr[row]
    };
    // A parabola through three of its values.
    let (first, middle, last) = (variance(1.0), variance(2.95), variance(4.9));
    let curvature = (first - 2.0 * middle + last) / (2.0 * 1.95 * 1.95);
    let slope = (last - first) / (2.0 * 1.95);
    assert!((curvature / (b * b) - 1.0).abs() < 1e-6);
    assert!(((middle - slope * 2.95 + curvature * 2.95 * 2.95) / (a * a) - 1.0).abs() < 1e-6);
    assert!(middle < first && middle < last);
}
