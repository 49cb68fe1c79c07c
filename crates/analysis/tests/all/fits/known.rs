//! Fits with known results, and reports of what is not determined.

use crate::support::Noise;
use crate::support::fitting::{fitted, model, observation, parameter, record, task, value};
use analysis::fit::{Fit, Lack, Outcome, Record, Undetermined, Varied, Verdict};
use analysis::virtual_record::tracked_velocities;
use engine::Method;
use program::Model;
use units::Language;

fn frames(rate: f64, count: u32) -> Vec<f64> {
    (0..count).map(|row| f64::from(row) / rate).collect()
}

fn noisy(times: &[f64], sigma: f64, seed: u64, truth: impl Fn(f64) -> f64) -> Vec<f64> {
    let mut noise = Noise::new(seed);
    times.iter().map(|&time| truth(time) + sigma * noise.normal()).collect()
}

/// Deviation of an estimate in standard errors.
fn off(outcome: &Outcome, name: &str, truth: f64) -> f64 {
    let estimate = outcome.estimate(name).unwrap();
    (estimate.value - truth) / estimate.stderr.unwrap()
}

const COLUMN: &str = "
parameter g   = 9.8  [m/s^2]
parameter rho = 1000 [kg/m^3]
parameter S   = 0.05 [m^2]
parameter b   = 50   [kg/s]
parameter h_l = 3    [m]
parameter h_r = 2    [m]
parameter q   = 3    [m]
L = 2 [m] + h_l + h_r
m = rho*S*L
rho*S*L*y'' + b*y' + 2*rho*S*g*y = 0
y(0)  = (h_l - h_r)/2
y'(0) = 0
gamma = b/(2*m)
";

/// The swinging column with b = 60 kg/s, 200 values with errors of 2 mm.
fn column() -> (Model, Record) {
    let model = model(COLUMN);
    let (times, gamma) = (frames(10.0, 200), 60.0 / 700.0);
    let omega = libm::sqrt(2.8 - gamma * gamma);
    let values = noisy(&times, 2e-3, 3, |t| {
        0.5 * libm::exp(-gamma * t) * (libm::cos(omega * t) + gamma / omega * libm::sin(omega * t))
    });
    let record = record(vec![observation(&model, "y", 0, &times, &values)]);
    (model, record)
}

#[test]
fn damping_and_density_are_known_as_a_quotient_only() {
    let (model, record) = column();
    let outcome = fitted(&model, task(&model, record.clone(), &["b", "rho", "g"]));
    let only = Undetermined {
        names: vec!["b".to_owned(), "rho".to_owned()],
        combinations: vec!["b/rho".to_owned()],
        lack: Lack::Flat,
    };
    assert_eq!(outcome.undetermined, [only]);
    for name in ["b", "rho"] {
        let estimate = outcome.estimate(name).unwrap();
        assert!(!estimate.determined && estimate.stderr.is_none() && estimate.stderr_hac.is_none());
    }
    // A quantity that depends on the quotient is as certain as if one of the two were known.
    let known = fitted(&model, task(&model, record, &["b", "g"]));
    assert_eq!((outcome.dof, known.undetermined.len()), (198, 0));
    for name in ["g", "gamma"] {
        let (one, other) = (outcome.estimate(name).unwrap(), known.estimate(name).unwrap());
        assert!(one.determined && (one.value / other.value - 1.0).abs() < 1e-6);
        assert!((one.stderr.unwrap() / other.stderr.unwrap() - 1.0).abs() < 1e-5);
    }
    assert!(off(&outcome, "gamma", 60.0 / 700.0).abs() < 3.0 && off(&outcome, "g", 9.8).abs() < 3.0);
}

#[test]
fn what_changes_nothing_is_named_and_left_alone() {
    let (model, record) = column();
    let outcome = fitted(&model, task(&model, record.clone(), &["b", "q", "g"]));
    assert_eq!(
        outcome.undetermined,
        [Undetermined { names: vec!["q".to_owned()], combinations: Vec::new(), lack: Lack::Flat }]
    );
    assert_eq!(value(&outcome, "q"), 3.0);
    let without = fitted(&model, task(&model, record, &["b", "g"]));
    assert!((value(&outcome, "b") / value(&without, "b") - 1.0).abs() < 1e-6);
    // It does not count in the criterion either.
    assert!((outcome.aicc.unwrap() - without.aicc.unwrap()).abs() < 1e-6);
}

/// Heights of a ball that is dropped and bounces; only the bounces distinguish restitution from gravity.
#[test]
fn a_bouncing_ball_tells_gravity_and_restitution() {
    let ball = model(
        "
parameter g = 9 [m/s^2]
parameter e = 0.7
parameter h = 1.8 [m]
y'' = -g
y(0) = h
y'(0) = 0
when y < 0 [m] {
    y' = -e*y'
    y  = 0 [m]
}
",
    );
    let (g, e, h) = (9.81, 0.8, 2.0);
    let times = frames(60.0, 210);
    let height = |time: f64| {
        let (mut start, mut speed, mut first) = (0.0, libm::sqrt(2.0 * g * h), libm::sqrt(2.0 * h / g));
        if time < first {
            return h - g * time * time / 2.0;
        }
        loop {
            start += first;
            speed *= e;
            first = 2.0 * speed / g;
            if time < start + first {
                return speed * (time - start) - g * (time - start) * (time - start) / 2.0;
            }
        }
    };
    for seed in 1..=3 {
        let values = noisy(&times, 3e-3, seed, height);
        let outcome =
            fitted(&ball, task(&ball, record(vec![observation(&ball, "y", 0, &times, &values)]), &["g", "e", "h"]));
        assert!(outcome.rmse < 3.4e-3, "{}", outcome.rmse);
        for (name, truth) in [("g", g), ("e", e), ("h", h)] {
            let estimate = outcome.estimate(name).unwrap();
            assert!(off(&outcome, name, truth).abs() < 3.5, "{estimate:?}");
            assert!(estimate.stderr.unwrap() < 2e-3 * truth, "{estimate:?}");
        }
    }
}

#[test]
fn records_share_what_is_common() {
    let fall = model("parameter g = 5 [m/s^2]\nparameter h = 1 [m]\ny = h - g*t^2/2");
    let times = frames(60.0, 40);
    let records: Vec<Record> = [1.5, 2.5, 3.5]
        .iter()
        .zip(1..)
        .map(|(h, seed)| {
            let values = noisy(&times, 4e-3, seed, |t| h - 9.81 * t * t / 2.0);
            Record { name: format!("fall {seed}"), ..record(vec![observation(&fall, "y", 0, &times, &values)]) }
        })
        .collect();
    let mut together = task(&fall, Record::default(), &["h"]);
    together.varied.push(Varied { shared: true, ..Varied::parameter(parameter(&fall, "g")) });
    together.records = records.clone();
    let outcome = fitted(&fall, together);
    let names: Vec<(&str, Option<usize>)> =
        outcome.parameters.iter().map(|estimate| (estimate.name.as_str(), estimate.record)).collect();
    assert_eq!(names, [("h", Some(0)), ("h", Some(1)), ("h", Some(2)), ("g", None)]);
    for (estimate, truth) in outcome.parameters.iter().zip([1.5, 2.5, 3.5, 9.81]) {
        assert!((estimate.value - truth).abs() < 3.0 * estimate.stderr.unwrap(), "{estimate:?}");
    }
    // Three records determine g better than one, by a factor of the square root of three.
    let alone = fitted(&fall, task(&fall, records[0].clone(), &["h", "g"]));
    let gain = alone.estimate("g").unwrap().stderr.unwrap() / outcome.estimate("g").unwrap().stderr.unwrap();
    assert!((1.5..2.0).contains(&gain), "{gain}");
    assert_eq!((outcome.n, outcome.dof), (120, 116));
}

/// Three columns of different lengths with one friction: a fit resumed from the answer finds it at once, from one start.
#[test]
fn a_known_answer_is_found_again() {
    let column = model(
        "
parameter L = 0.2 [m] in 0.01..10
parameter gamma = 0.3 [1/s] in 0..20
parameter x_0 = 0.04 [m]
x'' = -2*gamma*x' - 2*(9.8 [m/s^2])/L*x
x(0) = x_0
x'(0) = 0
",
    );
    let times = frames(30.0, 150);
    let swing = |length: f64| {
        let omega = libm::sqrt(19.6 / length - 0.16);
        move |t: f64| 0.05 * libm::exp(-0.4 * t) * (libm::cos(omega * t) + 0.4 / omega * libm::sin(omega * t))
    };
    let records = [0.18, 0.24, 0.3].into_iter().zip(1..).map(|(length, seed)| {
        // Each film has its own clock.
        let clock: Vec<f64> = times.iter().map(|time| time + seed as f64).collect();
        let values = noisy(&times, 5e-4, seed, swing(length));
        record(vec![observation(&column, "x", 0, &clock, &values)])
    });
    let mut together = task(&column, Record::default(), &["L", "x_0"]);
    together.records = records.collect();
    together.varied.push(Varied { shared: true, ..Varied::parameter(parameter(&column, "gamma")) });
    let first = fitted(&column, together.clone());
    let found: Vec<f64> = first.parameters.iter().map(|estimate| estimate.value).collect();
    for (value, truth) in found.iter().zip([0.18, 0.24, 0.3, 0.05, 0.05, 0.05, 0.4]) {
        assert!((value / truth - 1.0).abs() < 0.02, "{found:?}");
    }
    let mut again = Fit::again(&column, together.clone(), &found).unwrap();
    again.complete();
    assert!(again.trials() < 10, "{}", again.trials());
    let second = again.outcome().unwrap();
    assert!(second.converged);
    assert!((second.chi2 / first.chi2 - 1.0).abs() < 1e-9);
    for (one, other) in first.parameters.iter().zip(&second.parameters) {
        assert!((one.value - other.value).abs() < 1e-4 * one.stderr.unwrap(), "{one:?} {other:?}");
    }
    // Values of another task are not used as a start.
    let mut anew = Fit::again(&column, together, &found[..2]).unwrap();
    anew.complete();
    assert!((anew.outcome().unwrap().chi2 / first.chi2 - 1.0).abs() < 1e-9);
}

/// Velocities that are differences of the positions add no information; independently measured ones do.
#[test]
fn a_column_made_from_another_is_no_second_witness() {
    let swing = model(
        "
parameter A = 0.05 [m]
parameter gamma = 0.4 [1/s]
parameter omega = 9.6 [1/s]
parameter phi = 0.5
y = A*exp(-gamma*t)*cos(omega*t + phi)
v = y'
",
    );
    let names = ["A", "gamma", "omega", "phi"];
    let times = frames(30.0, 200);
    let truth = |t: f64| 0.05 * libm::exp(-0.4 * t) * libm::cos(9.6 * t + 0.5);
    let rate = |t: f64| 0.05 * libm::exp(-0.4 * t) * (-0.4 * libm::cos(9.6 * t + 0.5) - 9.6 * libm::sin(9.6 * t + 0.5));
    let positions = noisy(&times, 5e-4, 5, truth);
    let position = observation(&swing, "y", 0, &times, &positions);
    let alone = fitted(&swing, task(&swing, record(vec![position.clone()]), &names));
    // Of the same relative error as the positions.
    let measured = observation(&swing, "v", 0, &times, &noisy(&times, 9.6 * 5e-4, 6, rate));
    let both = fitted(&swing, task(&swing, record(vec![position.clone(), measured]), &names));
    let mut made = observation(&swing, "v", 0, &times, &tracked_velocities(&times, &positions));
    made.derived_from = Some(0);
    let repeated = fitted(&swing, task(&swing, record(vec![position, made]), &names));
    assert_eq!((alone.n, both.n, repeated.n), (200, 400, 199));
    for name in names {
        let error = |outcome: &Outcome| outcome.estimate(name).unwrap().stderr.unwrap();
        let [both, repeated] = [&both, &repeated].map(|outcome| error(outcome) / error(&alone));
        assert!((0.62..0.80).contains(&both), "{name}: {both}");
        assert!((0.95..1.05).contains(&repeated), "{name}: {repeated}");
    }
}

#[test]
fn given_errors_are_taken_at_their_word() {
    let line = model("parameter a = 1 [m]\nparameter s = 0 [m/s]\ny = a + s*t");
    let times = frames(10.0, 300);
    let values = noisy(&times, 0.01, 8, |t| 2.0 - 0.3 * t);
    let fit = |claimed: Option<f64>| {
        let mut one = observation(&line, "y", 0, &times, &values);
        one.errors = claimed.map(|error| vec![error; times.len()]);
        fitted(&line, task(&line, record(vec![one]), &["a", "s"]))
    };
    let [none, right, large, small] = [None, Some(0.01), Some(0.02), Some(0.005)].map(fit);
    assert_eq!(none.chi2_reduced, None);
    let reduced = |outcome: &Outcome| outcome.chi2_reduced.unwrap();
    assert!((reduced(&right) - 1.0).abs() < 0.2, "{}", reduced(&right));
    assert!((reduced(&right) / reduced(&large) - 4.0).abs() < 1e-9);
    let verdicts = [&none, &right, &large, &small].map(Outcome::verdict);
    assert_eq!(verdicts, [Verdict::Compatible, Verdict::Compatible, Verdict::TooSmall, Verdict::TooLarge]);
    let error = |outcome: &Outcome| outcome.estimate("s").unwrap().stderr.unwrap();
    assert!((error(&large) / error(&right) - 2.0).abs() < 1e-9);
    assert!((error(&none) / error(&right) - reduced(&right).sqrt()).abs() < 1e-9);
    // Robust errors follow from the residuals, not from the given errors.
    let robust = |outcome: &Outcome| outcome.estimate("s").unwrap().stderr_hac.unwrap();
    assert!((robust(&large) / robust(&none) - 1.0).abs() < 1e-9);
}

#[test]
fn the_rest_of_a_record_is_predicted() {
    let decay = model("parameter A = 1 [m]\nparameter r = 1 [1/s]\ny = A*exp(-r*t)");
    let times = frames(10.0, 100);
    let values = noisy(&times, 0.01, 9, |t| 2.0 * libm::exp(-0.5 * t));
    let part = |from: Option<f64>, until: Option<f64>| {
        let mut task = task(&decay, record(vec![observation(&decay, "y", 0, &times, &values)]), &["A", "r"]);
        (task.from, task.until) = (from, until);
        fitted(&decay, task)
    };
    let whole = part(None, None);
    assert!(whole.n == 100 && whole.observations[0].outside.is_none());
    let some = part(Some(1.0), Some(4.0));
    let fit = &some.observations[0];
    let outside = fit.outside.unwrap();
    // Both ends belong to the fitted part.
    assert_eq!((some.n, outside.n, fit.times.len()), (31, 69, 100));
    let squares = fit.measured.iter().zip(&fit.fitted).zip(&fit.inside).filter(|(_, inside)| !**inside);
    let sum = squares.fold(0.0, |sum, ((measured, fitted), _)| sum + (measured - fitted) * (measured - fitted));
    assert!((outside.rmse - (sum / 69.0).sqrt()).abs() < 1e-15);
    assert!(outside.rmse < 0.05 && (some.rmse - 0.01).abs() < 0.004, "{outside:?} {}", some.rmse);
    assert!(off(&some, "r", 0.5).abs() < 3.0);
}

#[test]
fn what_is_stopped_by_its_range_has_no_error() {
    let line =
        model("parameter a = 1 [m]\nparameter s = 0 [m/s] in -1..0.2\nslope = 2*s\nlater = a + s*5 [s]\ny = a + s*t");
    let times = frames(10.0, 50);
    let values = noisy(&times, 0.01, 10, |t| 2.0 + 0.3 * t);
    let observed = || record(vec![observation(&line, "y", 0, &times, &values)]);
    let outcome = fitted(&line, task(&line, observed(), &["a", "s"]));
    let stopped = outcome.estimate("s").unwrap();
    assert!(stopped.at_bound && stopped.value == 0.2 && stopped.stderr.is_none());
    // A quantity that depends only on it has no error either.
    let slope = outcome.estimate("slope").unwrap();
    assert_eq!((slope.value, slope.stderr, slope.stderr_hac, slope.at_bound), (0.4, None, None, true));
    assert_eq!(slope.stopped_text(Language::English), Some("no error: its parameter is at the end of the range"));
    let (later, a) = (outcome.estimate("later").unwrap(), outcome.estimate("a").unwrap());
    assert!(later.stderr == a.stderr && !later.at_bound && later.stopped_text(Language::English).is_none());
    let mut held = task(&line, observed(), &["a"]);
    held.parameters[parameter(&line, "s")] = 0.2;
    let held = fitted(&line, held);
    let [one, other] = [&outcome, &held].map(|outcome| outcome.estimate("a").unwrap().clone());
    assert!((one.value - other.value).abs() < 1e-12 && (one.stderr.unwrap() - other.stderr.unwrap()).abs() < 1e-12);
    // A wider range given for the fit replaces that of the parameter.
    let mut wide = task(&line, observed(), &["a", "s"]);
    wide.varied[1].bounds = Some((-1.0, 1.0));
    let wide = fitted(&line, wide);
    assert!(!wide.estimate("s").unwrap().at_bound && off(&wide, "s", 0.3).abs() < 3.0);
}

/// Stiff relaxation towards a decay: x' = -k (x - a e^(-rt)) with k ten thousand times r.
#[test]
fn stiff_equations_are_fitted_by_their_method() {
    let follower = model(
        "
parameter k = 5000 [1/s]
parameter a = 1 [m]
parameter r = 1 [1/s]
x' = -k*(x - a*exp(-r*t))
x(0) = a
",
    );
    let (k, a, r) = (5000.0, 2.0, 0.5);
    let times = frames(20.0, 100);
    let exact = |t: f64| {
        let slow = a * k / (k - r);
        slow * libm::exp(-r * t) + (a - slow) * libm::exp(-k * t)
    };
    let values = noisy(&times, 1e-3, 12, exact);
    let mut task = task(&follower, record(vec![observation(&follower, "x", 0, &times, &values)]), &["a", "r"]);
    task.method = Method::Rosenbrock;
    let outcome = fitted(&follower, task);
    for (name, truth) in [("a", a), ("r", r)] {
        assert!(off(&outcome, name, truth).abs() < 3.0, "{:?}", outcome.estimate(name));
        assert!(outcome.estimate(name).unwrap().stderr.unwrap() < 1e-3);
    }
}
