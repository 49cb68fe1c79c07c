//! Trials that need more computation than one trial may take.

use crate::support::fitting::{model, observation, record, task};
use analysis::fit::Fit;
use units::Language;

/// Fit of an oscillation of 1e5 rad/s to a record of this many rows, 0.1 s apart. It has made its first trial.
fn fast(rows: usize) -> Fit {
    let model = model(
        "
parameter omega = 1e5 [1/s] in 9e4..1.1e5
parameter y_0 = 1 [m]
y'' = -omega^2*y
y(0) = y_0
y'(0) = 0 [m/s]
",
    );
    let times: Vec<f64> = (0..rows).map(|row| 0.1 * row as f64).collect();
    let values: Vec<f64> = times.iter().map(|time| libm::cos(1e5 * time)).collect();
    let level = observation(&model, "y", 0, &times, &values);
    Fit::new(&model, task(&model, record(vec![level]), &["omega"])).unwrap()
}

#[test]
fn a_trial_that_needs_too_many_steps_is_given_up_and_the_fit_says_so() {
    assert!(fast(200).gave_up());
    let mut short = fast(5);
    assert!(!short.gave_up(), "a shorter part of the record");
    short.complete();
    let mut outcome = short.outcome().unwrap();
    let sentences = outcome.search_texts(Language::English);
    outcome.gave_up = true;
    assert_eq!(outcome.search_texts(Language::English).len(), sentences.len() + 1);
}
