//! Scale of a film, common to all lengths of a record, as a number with a prior.

use crate::support::Noise;
use crate::support::fitting::{
    DAMPED_COSINE, DAMPED_COSINE_NAMES, fitted, model, observation, parameter, record, task,
};
use analysis::fit::{Fit, FitError, Loss, Observation, Outcome, Record, Varied};
use program::Model;

/// A damped cosine with its velocity.
fn swing() -> Model {
    model(&format!("{DAMPED_COSINE}v = A*exp(-gamma*t)*(-gamma*cos(omega*t + phi) - omega*sin(omega*t + phi))\n"))
}

const PENDULUM: &str = "
parameter g = 9.8 [m/s^2]
parameter l = 0.6 [m]
parameter theta_0 = 0.7
theta'' = -g/l*sin(theta)
theta(0) = theta_0
theta'(0) = 0
x = l*sin(theta)
y = -l*cos(theta)
";

const FALL: &str = "
parameter g = 9.8 [m/s^2]
parameter c = 0.3 [m]
y = c - g*t^2/2
";

/// Values of the model at its own parameters.
fn curve(model: &Model, name: &str, times: &[f64]) -> Vec<f64> {
    let mut task = task(model, record(vec![observation(model, name, 0, times, times)]), &[]);
    let own = model.parameters[0].value;
    task.varied = vec![Varied { bounds: Some((own.next_down(), own.next_up())), ..Varied::parameter(0) }];
    let mut fit = Fit::new(model, task).unwrap();
    fit.complete();
    fit.outcome().unwrap().observations[0].fitted.clone()
}

fn times(rows: u32, rate: f64) -> Vec<f64> {
    (0..rows).map(|row| f64::from(row) / rate).collect()
}

/// The standard deviation of the noise, in metres.
const NOISE: f64 = 1e-4;

/// The clean values of a column times a scale, with noise.
fn seen(model: &Model, name: &str, times: &[f64], scale: f64, noise: &mut Noise) -> Observation {
    let values: Vec<f64> =
        curve(model, name, times).iter().map(|value| scale * value + NOISE * noise.normal()).collect();
    observation(model, name, 0, times, &values)
}

fn with_errors(observation: Observation) -> Observation {
    Observation { errors: Some(vec![NOISE; observation.values.len()]), ..observation }
}

/// Deviation of an estimate from the model's own value, and its error.
fn off(outcome: &Outcome, model: &Model, name: &str) -> (f64, f64) {
    let estimate = outcome.estimate(name).unwrap();
    (estimate.value - model.parameters[parameter(model, name)].value, estimate.stderr_hac.unwrap())
}

/// A scale that is 1 % wrong: the length is wrong by as much, and its error covers this. Times, rates and the quality of
/// the fit are the same as without the scale.
#[test]
fn a_wrong_scale_is_in_the_errors_of_lengths_alone() {
    let model = swing();
    let times = times(200, 30.0);
    for given in [false, true] {
        let of = |scale_error| {
            let mut observed = seen(&model, "y", &times, 1.01, &mut Noise::new(7));
            if given {
                observed = with_errors(observed);
            }
            fitted(&model, task(&model, Record { scale_error, ..record(vec![observed]) }, &DAMPED_COSINE_NAMES))
        };
        let (with, without) = (of(Some(0.01)), of(None));
        let (wrong, error) = off(&with, &model, "A");
        let (_, alone) = off(&without, &model, "A");
        assert!(wrong > 5.0 * alone, "{wrong} {alone}");
        assert!((error / (0.01 * 0.05) - 1.0).abs() < 0.05, "{error}");
        for name in ["gamma", "omega", "phi"] {
            let [(one, sigma), (other, before)] = [&with, &without].map(|outcome| off(outcome, &model, name));
            assert!((one - other).abs() < 1e-3 * before && (sigma / before - 1.0).abs() < 0.01, "{name}");
        }
        let [scale] = with.scales[..] else { panic!("{:?}", with.scales) };
        assert!((scale.value - 1.0).abs() < 1e-6 && scale.record == 0 && scale.prior == 0.01, "{scale:?}");
        assert!((scale.stderr.unwrap() / 0.01 - 1.0).abs() < 1e-3, "{scale:?}");
        assert!(without.scales.is_empty());
        assert_eq!((with.n, with.dof, with.parameters.len()), (without.n, without.dof, 5));
        for (one, other) in
            [(with.aicc.unwrap(), without.aicc.unwrap()), (with.bic, without.bic), (with.r2, without.r2)]
        {
            assert!((one - other).abs() < 1e-6 * other.abs(), "{one} {other}");
        }
        assert_eq!(with.correlation.len(), 25);
    }
}

/// If no other number can compensate for the scale, the data determine it: here g is known. Its prior then has no
/// influence.
#[test]
fn data_determine_the_scale_where_another_length_is_known() {
    let model = model(FALL);
    let times = times(60, 120.0);
    for given in [false, true] {
        let mut observed = seen(&model, "y", &times, 1.03, &mut Noise::new(3));
        if given {
            observed = with_errors(observed);
        }
        let outcome =
            fitted(&model, task(&model, Record { scale_error: Some(0.05), ..record(vec![observed]) }, &["c"]));
        let [scale] = outcome.scales[..] else { panic!("{:?}", outcome.scales) };
        let error = scale.stderr.unwrap();
        assert!(error < 0.002 && (scale.value - 1.03).abs() < 3.0 * error, "{scale:?}");
        // The curve includes the scale of the film.
        assert!(outcome.rmse < 1.3 * NOISE);
        assert_eq!(outcome.dof, 59);
    }
}

/// Velocities have the scale of the positions, and two records each have their own.
#[test]
fn columns_share_a_scale_and_records_do_not() {
    let model = swing();
    let times = times(150, 30.0);
    let mut noise = Noise::new(11);
    let mut film = |scale| {
        let columns = ["y", "v"].map(|name| with_errors(seen(&model, name, &times, scale, &mut noise)));
        Record { scale_error: Some(0.01), ..record(columns.to_vec()) }
    };
    let (first, second) = (film(1.0), film(1.0));
    let one = fitted(&model, task(&model, first.clone(), &DAMPED_COSINE_NAMES));
    assert_eq!(one.scales.len(), 1);
    let mut both = task(&model, first, &DAMPED_COSINE_NAMES);
    both.records.push(second);
    both.varied.iter_mut().for_each(|varied| varied.shared = true);
    let both = fitted(&model, both);
    assert_eq!(both.scales.iter().map(|scale| scale.record).collect::<Vec<_>>(), [0, 1]);
    let [(_, alone), (_, together)] = [&one, &both].map(|outcome| off(outcome, &model, "A"));
    // Two rulers give a smaller error than one.
    assert!((alone / together / std::f64::consts::SQRT_2 - 1.0).abs() < 0.02, "{alone} {together}");
}

/// For a pendulum seen in both coordinates, g follows from its length; an equation of motion.
#[test]
fn g_of_a_pendulum_has_the_error_of_the_scale() {
    let model = model(PENDULUM);
    let times = times(120, 30.0);
    let mut noise = Noise::new(5);
    let columns = ["x", "y"].map(|name| with_errors(seen(&model, name, &times, 1.01, &mut noise)));
    let of = |scale_error| {
        let record = Record { scale_error, ..record(columns.to_vec()) };
        fitted(&model, task(&model, record, &["g", "l", "theta_0"]))
    };
    let (with, without) = (of(Some(0.01)), of(None));
    let (wrong, error) = off(&with, &model, "g");
    assert!(wrong.abs() > 5.0 * off(&without, &model, "g").1 && wrong.abs() < 1.3 * error, "{wrong} {error}");
    assert!((error / 0.098 - 1.0).abs() < 0.1, "{error}");
    // The oscillation is an angle.
    let [(one, sigma), (other, before)] = [&with, &without].map(|outcome| off(outcome, &model, "theta_0"));
    assert!((one - other).abs() < 0.01 * before && (sigma / before - 1.0).abs() < 0.01);
}

#[test]
fn two_of_three_intervals_contain_the_truth() {
    let model = swing();
    let times = times(150, 30.0);
    let clean = curve(&model, "y", &times);
    let mut noise = Noise::new(2_026);
    for (loss, given) in [(Loss::Squares, true), (Loss::Squares, false), (Loss::Huber, false)] {
        let mut inside = [0; 5];
        for _ in 0..200 {
            // The scale and the noise contribute equally to the error of A.
            let scale = 1.0 + 5e-4 * noise.normal();
            let values: Vec<f64> = clean.iter().map(|value| scale * value + NOISE * noise.normal()).collect();
            let mut observed = observation(&model, "y", 0, &times, &values);
            if given {
                observed = with_errors(observed);
            }
            let mut task =
                task(&model, Record { scale_error: Some(5e-4), ..record(vec![observed]) }, &DAMPED_COSINE_NAMES);
            task.loss = loss;
            let outcome = fitted(&model, task);
            for (count, name) in inside.iter_mut().zip(DAMPED_COSINE_NAMES) {
                let (off, error) = off(&outcome, &model, name);
                *count += i32::from(off.abs() <= error);
            }
        }
        // 136 are expected, with a standard deviation of 6.6.
        for (count, name) in inside.iter().zip(DAMPED_COSINE_NAMES) {
            assert!((116..=156).contains(count), "{loss:?} {name}: {count} of 200");
        }
    }
}

#[test]
fn an_angle_has_no_scale_and_a_bad_error_is_refused() {
    let model = model("parameter a = 0.2\nparameter w = 3 [1/s]\ntheta = a*cos(w*t)");
    let times = times(50, 10.0);
    let values: Vec<f64> = times.iter().map(|t| 0.2 * libm::cos(3.0 * t)).collect();
    let of = |scale_error| {
        let record = Record { scale_error, ..record(vec![observation(&model, "theta", 0, &times, &values)]) };
        Fit::new(&model, task(&model, record, &["a", "w"]))
    };
    let mut fit = of(Some(0.01)).unwrap();
    fit.complete();
    assert!(fit.outcome().unwrap().scales.is_empty());
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert_eq!(of(Some(bad)).unwrap_err(), FitError::BadScaleError(0));
    }
}

/// A fit resumed from its answer gives the same result.
#[test]
fn again_from_the_answer() {
    let model = swing();
    let observed = seen(&model, "y", &times(200, 30.0), 1.0, &mut Noise::new(7));
    let task = task(&model, Record { scale_error: Some(0.01), ..record(vec![observed]) }, &DAMPED_COSINE_NAMES);
    let first = fitted(&model, task.clone());
    let found: Vec<f64> = first.parameters.iter().map(|one| one.value).collect();
    let mut again = Fit::again(&model, task, &found).unwrap();
    again.complete();
    let second = again.outcome().unwrap();
    assert_eq!(second.starts, 1);
    for (one, other) in first.parameters.iter().zip(&second.parameters) {
        assert!((one.value - other.value).abs() < 1e-6 * one.stderr.unwrap(), "{}", one.name);
    }
}
