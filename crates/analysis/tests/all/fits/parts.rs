//! Fits of a part of a record: initial values hold where the part begins, so that earlier rows have no influence. Also:
//! values that a fit refuses to leave out.

use crate::support::fitting::{fitted, model, observation, record, task, value};
use crate::support::{Noise, utube};
use analysis::fit::{Fit, FitError, Outcome, Record, Target, Task, Varied};
use program::Model;

/// Quadratic damping, whose initial values matter wherever they hold.
const QUADRATIC: &str = "
parameter L = 0.2 [m] in 0.01..10
parameter beta = 6 [1/m] in 0..200
parameter y_0 = 0.04 [m] in -1..1
parameter v_0 = 0 [m/s] in -5..5
parameter c = 0 [m] in -1..1
x'' + beta*abs(x')*x' + 2*(9.8 [m/s^2])/L*x = 0
x(0) = y_0
x'(0) = v_0
y = x + c
";
const NAMES: [&str; 5] = ["L", "beta", "y_0", "v_0", "c"];

/// Film of a damped column at 30 frames per second. The first second belongs to another motion: the column is released by
/// hand.
fn film(seed: u64, start: f64) -> (Vec<f64>, Vec<f64>) {
    let mut noise = Noise::new(seed);
    let row = |frame: u32| {
        let time = f64::from(frame) / 30.0;
        let swing = 0.05 * libm::exp(-0.4 * time) * libm::cos(9.6 * time) + if time < 1.0 { 0.02 } else { 0.0 };
        (start + time, swing + 5e-4 * noise.normal())
    };
    (0..180).map(row).unzip()
}

fn part(model: &Model, (times, values): &(Vec<f64>, Vec<f64>), from: Option<f64>) -> Task {
    Task { from, ..task(model, record(vec![observation(model, "y", 0, times, values)]), &NAMES) }
}

/// Record without the rows before `from`.
fn cut((times, values): &(Vec<f64>, Vec<f64>), from: f64) -> (Vec<f64>, Vec<f64>) {
    times.iter().zip(values).filter(|(time, _)| **time >= from).map(|(time, value)| (*time, *value)).unzip()
}

fn assert_same(part: &Outcome, cut: &Outcome, what: &str) {
    assert_eq!(part.n, cut.n, "{what}");
    assert!((part.rmse / cut.rmse - 1.0).abs() < 2e-3, "{what}: {} {}", part.rmse, cut.rmse);
    assert_eq!(part.origins, cut.origins, "{what}");
    for (one, other) in part.parameters.iter().zip(&cut.parameters) {
        let scale = other.stderr.unwrap();
        assert!((one.value - other.value).abs() < 0.02 * scale, "{what}: {one:?} {other:?}");
    }
}

#[test]
fn initial_values_hold_where_the_fitted_part_begins() {
    let model = model(QUADRATIC);
    let film = film(1, 0.5);
    for from in [1.5, 1.81, 2.5] {
        let outcome = fitted(&model, part(&model, &film, Some(from)));
        let alone = fitted(&model, part(&model, &cut(&film, from), None));
        assert_same(&outcome, &alone, &format!("from {from}"));
        let first = film.0.iter().position(|time| *time >= from).unwrap();
        assert_eq!(outcome.origins, [film.0[first]]);
        // Earlier rows are kept in the result, but nothing is predicted of them.
        let one = &outcome.observations[0];
        assert_eq!((one.early, one.times.len()), (first, film.0.len()));
        assert!(one.fitted[..first].iter().all(|value| value.is_nan()));
        assert!(one.fitted[first..].iter().all(|value| value.is_finite()));
        assert!(one.outside.is_none());
    }
    // Later rows are predicted.
    let mut middle = part(&model, &film, Some(1.5));
    middle.until = Some(4.0);
    let middle = fitted(&model, middle);
    let after = film.0.iter().filter(|time| **time > 4.0).count();
    assert_eq!(middle.observations[0].outside.unwrap().n, after);
    let one = &middle.observations[0];
    let later = (0..one.times.len()).filter(|&row| one.times[row] > 4.0);
    let square =
        later.map(|row| (one.measured[row] - one.fitted[row]) * (one.measured[row] - one.fitted[row])).sum::<f64>();
    let predicted = middle.predicted().unwrap();
    assert!(predicted < 3e-3 && (predicted / (square / after as f64).sqrt() - 1.0).abs() < 1e-12, "{predicted}");
}

#[test]
fn gaps_offsets_and_several_records_begin_where_their_part_begins() {
    let model = model(QUADRATIC);
    // With a gap at the beginning of the part, the first measured value is used.
    let mut gap = film(2, 0.0);
    let first = gap.0.iter().position(|time| *time >= 1.5).unwrap();
    gap.1[first] = f64::NAN;
    assert_eq!(fitted(&model, part(&model, &gap, Some(1.5))).origins, [gap.0[first + 1]]);
    // Two films with their own clocks, and an offset that is fitted.
    let films = [film(3, 0.0), film(4, 0.62)];
    let together = |films: [&(Vec<f64>, Vec<f64>); 2], from: Option<f64>| {
        let mut task = part(&model, films[0], from);
        task.records = films.map(|film| part(&model, film, None).records[0].clone()).to_vec();
        let c = task.varied.pop().unwrap();
        task.varied.push(Varied { target: Target::Offset(0), ..c });
        task.varied[0].shared = true;
        fitted(&model, task)
    };
    let cuts = [cut(&films[0], 2.0), cut(&films[1], 2.0)];
    let outcome = together([&films[0], &films[1]], Some(2.0));
    assert_same(&outcome, &together([&cuts[0], &cuts[1]], None), "two films");
    assert!(outcome.origins[0] != outcome.origins[1]);
    // A given origin is kept, and so is a varied one.
    let mut given = part(&model, &films[0], Some(2.0));
    given.records[0].origin = Some(1.5);
    let given = fitted(&model, given);
    assert_eq!((given.origins[0], given.observations[0].early), (1.5, 45));
    assert_eq!(given.observations[0].outside.unwrap().n, 15);
}

/// If the time occurs in the equations, or in a formula, the clock of the record is used whatever part is fitted.
#[test]
fn a_clock_that_counts_is_left_alone() {
    let driven = model(
        "
parameter a = 1 [m/s^2]
parameter v_0 = 0 [m/s]
x'' = a*sin(3 [1/s]*t)
x(0) = 0
x'(0) = v_0
",
    );
    let times: Vec<f64> = (0..100).map(|row| f64::from(row) / 20.0).collect();
    let values: Vec<f64> = times.iter().map(|t| (2.0 + 0.5) * t / 3.0 - 2.0 * libm::sin(3.0 * t) / 9.0).collect();
    let mut task = task(&driven, record(vec![observation(&driven, "x", 0, &times, &values)]), &["a", "v_0"]);
    task.from = Some(2.0);
    let outcome = fitted(&driven, task);
    assert_eq!((outcome.origins[0], outcome.observations[0].early), (0.0, 0));
    assert!((value(&outcome, "a") - 2.0).abs() < 1e-6);
    assert_eq!(outcome.observations[0].outside.unwrap().n, 40);
}

#[test]
#[ignore = "needs the measured records in ../shared/data/utube"]
fn measured_columns_are_fitted_as_if_the_rows_before_were_not_there() {
    let model = model(QUADRATIC);
    for (name, from) in [("U1", 1.0), ("U2", 1.3), ("U3", 2.0), ("U4", 1.3)] {
        let columns = utube(name);
        let film = (columns[0].clone(), columns[1].clone());
        let outcome = fitted(&model, part(&model, &film, Some(from)));
        let alone = fitted(&model, part(&model, &cut(&film, from), None));
        assert_same(&outcome, &alone, &format!("{name} from {from}"));
    }
}

/// A fit with numbers that are not finite is refused.
#[test]
fn what_is_no_number_is_refused() {
    let model = model("parameter a = 1 [m]\nparameter s = 0 [m/s]\ny = a + s*t");
    let times: Vec<f64> = (0..10).map(f64::from).collect();
    let with = |errors: Vec<f64>| {
        let mut one = observation(&model, "y", 0, &times, &times);
        one.errors = Some(errors);
        task(&model, record(vec![one]), &["a", "s"])
    };
    let refused = |task: Task| Fit::new(&model, task).map(|_| ()).unwrap_err();
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let mut errors = vec![1.0; 10];
        (errors[3], errors[7]) = (bad, bad);
        let mut part = with(errors.clone());
        part.until = Some(2.5);
        let bad = FitError::BadErrors { record: 0, observation: 0, count: 2, first: 3.0 };
        assert_eq!(refused(with(errors)), bad);
        // Outside the fitted part errors do not count.
        assert!(Fit::new(&model, part).is_ok());
    }
    let short = FitError::BadErrors { record: 0, observation: 0, count: 1, first: 9.0 };
    assert_eq!(refused(with(vec![1.0; 9])), short);
    let good = || with(vec![1.0; 10]);
    let mut start = good();
    start.varied[1].start = Some(f64::NAN);
    assert_eq!(refused(start), FitError::BadStart(1));
    let mut bounds = good();
    bounds.varied[1].bounds = Some((f64::NAN, 1.0));
    assert_eq!(refused(bounds), FitError::BadBounds(1));
    let mut parameter = good();
    parameter.parameters[0] = f64::NAN;
    assert_eq!(refused(parameter), FitError::BadValue(0));
    // Of several records, one without a value would leave its parameters undetermined.
    let mut empty = good();
    let late: Vec<f64> = times.iter().map(|time| time + 100.0).collect();
    empty.records.push(Record { ..record(vec![observation(&model, "y", 0, &late, &times)]) });
    empty.records[0].observations[0].errors = None;
    empty.until = Some(50.0);
    assert_eq!(refused(empty), FitError::RecordEmpty(1));
}

/// Each seed would give another minimum.
#[test]
fn what_draws_at_random_is_refused() {
    let model = model("random seed = 1\nparameter a = 1\ndiscrete y = a + normal(0, 1)");
    let one = observation(&model, "y", 0, &[0.0, 1.0, 2.0], &[1.0, 1.0, 1.0]);
    let refused = Fit::new(&model, task(&model, record(vec![one]), &["a"])).map(|_| ()).unwrap_err();
    assert!(refused.to_string().contains("draws at random"), "{refused}");
}

/// A stone falls from rest at a moment that is not known: h - g (t - t_0)^2/2 after t_0, h before. Value and standard error of t_0 are those
/// of linear least squares with the derivatives written by hand.
#[test]
fn a_moment_of_release_is_found_with_its_error() {
    let model = model("parameter g = 7 [m/s^2]\nparameter h = 1 [m]\ny'' = -g\ny(0) = h\ny'(0) = 0 [m/s]");
    let (g, h, t_0, sigma) = (9.8, 1.2, 0.4137, 1e-3);
    let times: Vec<f64> = (0..60).map(|row| f64::from(row) / 60.0).collect();
    let since = |time: f64| (time - t_0).max(0.0);
    let mut noise = Noise::new(12);
    let values: Vec<f64> =
        times.iter().map(|&time| h - 0.5 * g * since(time) * since(time) + sigma * noise.normal()).collect();
    let mut task = task(&model, record(vec![observation(&model, "y", 0, &times, &values)]), &["g", "h"]);
    task.varied.push(Varied { target: Target::Origin, shared: false, start: Some(0.3), bounds: None });
    let outcome = fitted(&model, task);
    let found = outcome.estimate("t_origin").unwrap();
    // Normal matrix of g, h and t_0, and the last entry of its inverse.
    let mut normal = [[0.0; 3]; 3];
    for &time in &times {
        let slopes = [-0.5 * since(time) * since(time), 1.0, g * since(time)];
        for (row, one) in normal.iter_mut().zip(slopes) {
            row.iter_mut().zip(slopes).for_each(|(sum, other)| *sum += one * other);
        }
    }
    let [[a, b, c], [_, d, e], [_, _, f]] = normal;
    let determinant = a * (d * f - e * e) - b * (b * f - c * e) + c * (b * e - c * d);
    let expected = outcome.rmse * (60.0_f64 / 57.0).sqrt() * ((a * d - b * b) / determinant).sqrt();
    let stderr = found.stderr.unwrap();
    assert!((stderr / expected - 1.0).abs() < 0.02, "{stderr} for {expected}");
    assert!((found.value - t_0).abs() < 3.0 * expected, "{} +- {expected}", found.value);
}
