//! Fits from the values of a document reach the minimum that a search from the true values reaches, or warn that another
//! minimum may exist.

use super::kinds::{COSINE, KINDS, Kind, TWO_EXPONENTIALS, grid};
use crate::support::Noise;
use crate::support::fitting::{model, observation, on_all_processors, record, task};
use analysis::fit::{Fit, Lack, Outcome, Task, rank};
use core::f64::consts::TAU;
use program::Model;

/// End of a fit beside that of a search from the true values.
struct End {
    reached: bool,
    warned: bool,
    text: String,
}

fn task_of(model: &Model, kind: &Kind, times: &[f64], values: &[f64]) -> Task {
    task(model, record(vec![observation(model, "y", 0, times, values)]), kind.varied)
}

fn finished(mut fit: Fit) -> (Outcome, usize) {
    fit.complete();
    (fit.outcome().expect("a curve"), fit.trials())
}

fn end(kind: &Kind, seed: u64) -> End {
    let mut random = Noise::new(seed);
    let made = (kind.make)(&mut random);
    let values: Vec<f64> = made.values.iter().map(|value| value + made.noise * random.normal()).collect();
    let model = model(kind.text);
    // The true values count from the first row.
    let since: Vec<f64> = made.times.iter().map(|time| time - made.times[0]).collect();
    let (best, _) = finished(Fit::again(&model, task_of(&model, kind, &since, &values), &made.truth).expect("a task"));
    let (found, trials) = finished(Fit::new(&model, task_of(&model, kind, &made.times, &values)).expect("a task"));
    let reached = found.rmse <= best.rmse * (1.0 + 1e-4);
    let warned = found.rival.is_some() || found.unexplained.is_some();
    let numbers: Vec<String> = found
        .parameters
        .iter()
        .zip(&made.truth)
        .map(|(one, truth)| format!("{} {:.4} ({truth:.4})", one.name, one.value))
        .collect();
    let text = format!(
        "{} seed {seed}: rmse {:.4} of the minimum, {trials} trials, {} starts, from {}: {}",
        kind.name,
        found.rmse / best.rmse,
        found.starts,
        made.times[0],
        numbers.join(", ")
    );
    End { reached, warned, text }
}

/// Three records of each kind.
#[test]
fn the_minimum_is_reached_or_a_warning_given() {
    let all: Vec<(&Kind, u64)> = KINDS.iter().flat_map(|kind| [31, 32, 33].map(|seed| (kind, seed))).collect();
    let ends = on_all_processors(&all, |(kind, seed)| end(kind, *seed));
    for end in &ends {
        assert!(end.reached || end.warned, "{}", end.text);
    }
    let warned = ends.iter().filter(|end| end.reached && end.warned).count();
    let missed: Vec<&str> = ends.iter().filter(|end| !end.reached).map(|end| end.text.as_str()).collect();
    assert!(warned <= 1 && missed.len() <= 1, "{warned} warned, missed: {missed:#?}");
}

/// Formulas and drives whose sinusoids have their phase in a range of one turn, from one start to all true values, with time and
/// with another independent variable.
#[test]
fn a_phase_turns_freely_in_its_range() {
    let times = grid(201, 6.2);
    for (head, argument) in [
        ("independent x\nparameter f = 1 in 0..100\n", "f*x + phi"),
        ("parameter f = 1 [rad/s] in 0..100\n", "f*t + phi"),
        ("parameter f = 2 [rad/s] in 0..100\n", "-phi - f*t"),
    ] {
        for (range, shift) in [("0..6.2832", 0.0), ("0..6.28", 0.0), ("-3.1416..3.1416", -TAU), ("-20..20", 0.0)] {
            for turn in 0..8_u32 {
                let phi = 0.2 + 0.8 * f64::from(turn);
                let mut random = Noise::new(turn.into());
                let sign = if argument.starts_with('-') { -1.0 } else { 1.0 };
                let values: Vec<f64> =
                    times.iter().map(|x| 1.3 * libm::sin(sign * (3.0 * x + phi)) + 0.03 * random.normal()).collect();
                let text =
                    format!("{head}parameter A = 1 in 0..10\nparameter phi = 0.5 in {range}\ny = A*sin({argument})");
                let model = model(&text);
                let task = task(&model, record(vec![observation(&model, "y", 0, &times, &values)]), &["A", "f", "phi"]);
                let (found, _) = finished(Fit::new(&model, task).expect("a task"));
                let value = found.estimate("phi").expect("phi").value;
                let (low, high) =
                    model.parameters.iter().find(|one| one.name == "phi").and_then(|one| one.range).unwrap();
                let off = (value - phi) / TAU;
                let case = format!("{argument} in {range}: {value} for {phi} {shift}, rmse {}", found.rmse);
                assert!((low..=high).contains(&value), "{case}");
                assert!(found.rmse < 0.04 && (off - off.round()).abs() < 0.02, "{case}");
            }
        }
    }
}

/// Equal numbers are moved apart, so that two exponentials are not the curve of one.
#[test]
fn two_exponentials_are_told_from_one() {
    let mut random = Noise::new(4);
    let times = grid(101, 10.0);
    let curve = |t: &f64| 3.0 * libm::exp(-t / 0.8) + 2.0 * libm::exp(-t / 2.1) + 0.02 * random.normal();
    let values: Vec<f64> = times.iter().map(curve).collect();
    let fitted = |text: &str, names: &[&str]| {
        let model = model(text);
        let task = task(&model, record(vec![observation(&model, "y", 0, &times, &values)]), names);
        finished(Fit::new(&model, task).expect("a task")).0
    };
    let one = fitted("parameter A = 1 [V] in 0..100\nparameter a = 1 [s] in 0.001..100\ny = A*exp(-t/a)", &["A", "a"]);
    let two = fitted(TWO_EXPONENTIALS, &["A", "a", "B", "b"]);
    assert!(two.undetermined.iter().all(|one| one.lack == Lack::Exchange), "{:?}", two.undetermined);
    let ranked = rank(&[&one, &two]);
    assert_eq!(ranked.iter().map(|one| (one.index, one.place)).collect::<Vec<_>>(), [(1, 1), (0, 2)]);
}

/// A clock that begins late is moved where other values give the same curve, and only there.
#[test]
fn a_late_clock_is_moved_where_the_curve_may_be_translated() {
    let swing = |t: f64| 0.05 * libm::exp(-0.4 * t) * libm::cos(9.6 * t + 0.5) + 0.002;
    let moved = |text: &str, names: &[&str], begins: f64, origin: Option<f64>| {
        let times: Vec<f64> = grid(200, 6.0).iter().map(|time| begins + time).collect();
        let values: Vec<f64> = times.iter().map(|time| swing(time - begins)).collect();
        let model = model(text);
        let mut task = task(&model, record(vec![observation(&model, "y", 0, &times, &values)]), names);
        task.records[0].origin = origin;
        let mut fit = Fit::new(&model, task).expect("a task");
        fit.complete();
        fit.outcome().map_or_else(Vec::new, |outcome| outcome.origins)
    };
    let all = ["A", "gamma", "omega", "delta", "c"];
    for begins in [30.0, 1000.0, 1e9, -500.0] {
        assert_eq!(moved(COSINE, &all, begins, None), [begins]);
    }
    // A record that begins soon after 0, a given origin, a phase that is held.
    assert!(moved(COSINE, &all, 3.0, None).is_empty() && moved(COSINE, &all, 30.0, Some(0.0)).is_empty());
    assert!(moved(COSINE, &["A", "gamma", "omega", "c"], 30.0, None).is_empty());
    // A pulse whose moment may lie in the record, and one whose moment may not.
    let pulse = |range: &str| {
        format!(
            "parameter A = 1 [m]\nparameter t_0 = 1 [s] in {range}\nparameter s = 1 [s]\ny = A*exp(-((t - t_0)/s)^2)"
        )
    };
    assert!(moved(&pulse("0..2000"), &["A", "t_0", "s"], 1000.0, None).is_empty());
    assert_eq!(moved(&pulse("0..8"), &["A", "t_0", "s"], 1000.0, None), [1000.0]);
    // A line over another variable has no clock.
    let line = "independent x\nparameter a = 1\nparameter b = 1\ny = a + b*x";
    assert!(moved(line, &["a", "b"], 1000.0, None).is_empty());
    // A drive with a phase of its own, and one without.
    let driven = |phase: &str| {
        format!(
            "parameter k = 90 [1/s^2]\nparameter d = 0.3\nparameter x0 = 0.1 [m]\nparameter v0 = 0 [m/s]\n\
             y'' = -k*y + 1 [m/s^2]*cos(3 [1/s]*t + {phase})\ny(0) = x0\ny'(0) = v0"
        )
    };
    assert_eq!(moved(&driven("d"), &["k", "d", "x0", "v0"], 30.0, None), [30.0]);
    assert_eq!(moved(&driven("0"), &["k", "x0", "v0"], 30.0, None), [0.0]);
}

/// Prints for each kind how many of 20 fits reach the minimum, and how many warn.
#[test]
#[ignore = "takes a minute"]
fn many_records_of_each_kind() {
    for kind in &KINDS {
        let seeds: Vec<u64> = (1..=20).collect();
        let ends = on_all_processors(&seeds, |seed| end(kind, *seed));
        let count = |of: &dyn Fn(&End) -> bool| ends.iter().filter(|end| of(end)).count();
        println!(
            "{}: {} reached, {} of them warned, {} missed without a warning",
            kind.name,
            count(&|end| end.reached),
            count(&|end| end.reached && end.warned),
            count(&|end| !end.reached && !end.warned)
        );
        ends.iter().filter(|end| !end.reached).for_each(|end| println!("    {}", end.text));
    }
}
