//! Undetermined numbers are reported: numbers without effect, combinations, numbers that can exchange their values.

use crate::support::Noise;
use crate::support::fitting::{DAMPED_COSINE, DAMPED_COSINE_NAMES, model, observation, record, task};
use analysis::fit::{Fit, Lack, Outcome, Undetermined, Verdict};
use engine::Method;
use units::Language;

/// Outcome of a fit of `name` for the model `text`.
fn fit(text: &str, name: &str, names: &[&str], data: &(Vec<f64>, Vec<f64>), method: Method) -> Outcome {
    let model = model(text);
    let mut task = task(&model, record(vec![observation(&model, name, 0, &data.0, &data.1)]), names);
    task.method = method;
    let mut fit = Fit::new(&model, task).unwrap();
    fit.complete();
    fit.outcome().unwrap()
}

/// Values of `curve` at `count` times up to `end`, with noise.
fn data(count: u32, end: f64, noise: f64, curve: impl Fn(f64) -> f64) -> (Vec<f64>, Vec<f64>) {
    let mut random = Noise::new(7);
    let times: Vec<f64> = (0..count).map(|row| end * f64::from(row) / f64::from(count - 1)).collect();
    let values = times.iter().map(|t| curve(*t) + noise * random.normal()).collect();
    (times, values)
}

fn of_lack(outcome: &Outcome, lack: Lack) -> Vec<&Undetermined> {
    outcome.undetermined.iter().filter(|one| one.lack == lack).collect()
}

#[test]
fn constant_values_determine_no_oscillation() {
    for level in [0.02, -3.0, 1e-6, 400.0, 0.0] {
        let outcome =
            fit(DAMPED_COSINE, "y", &DAMPED_COSINE_NAMES, &data(60, 3.0, 0.0, |_| level), Method::DormandPrince);
        for name in ["gamma", "omega", "phi"] {
            let one = outcome.estimate(name).unwrap();
            assert!(!one.determined && one.stderr.is_none(), "{level}: {one:?}");
        }
        assert!(outcome.undetermined.iter().all(|one| one.lack == Lack::Flat), "{:?}", outcome.undetermined);
        let c = outcome.estimate("c").unwrap();
        assert!(c.determined && (c.value - level).abs() <= 1e-9 * level.abs() + 1e-15, "{level}: {c:?}");
    }
}

#[test]
fn as_many_values_as_numbers_are_no_test() {
    let line = "parameter a = 1 [m]\nparameter s = 1 [m/s]\nparameter q = 0 [m/s^2]\ny = a + s*t + q*t^2";
    for (count, verdict) in [(3, Verdict::Saturated), (4, Verdict::Unknown)] {
        let outcome =
            fit(line, "y", &["a", "s", "q"], &data(count, 3.0, 0.1, |t| 1.0 + libm::sin(t)), Method::DormandPrince);
        assert_eq!(outcome.verdict(), verdict);
        assert_eq!(outcome.verdict_text(Language::English).contains("no test of the model"), count == 3);
        assert_eq!(outcome.verdict_text(catalogues::with(Language::Spanish)).contains("no pone a prueba"), count == 3);
    }
}

#[test]
fn a_product_of_three_is_named() {
    let text = "parameter a = 1\nparameter b = 2\nparameter d = 0.5\nparameter e = 1\ny = a*b^2/d*exp(-t/(1 [s])) + e";
    let outcome = fit(
        text,
        "y",
        &["a", "b", "d", "e"],
        &data(40, 3.0, 0.01, |t| 6.0 * libm::exp(-t) + 1.0),
        Method::DormandPrince,
    );
    let found = of_lack(&outcome, Lack::Flat);
    assert_eq!(found.len(), 1);
    assert_eq!((found[0].names.len(), &found[0].combinations[..]), (3, &["a*b^2/d".to_owned()][..]));
}

/// Saturation far below its half: only the initial slope is visible.
#[test]
fn a_combination_that_is_determined_much_better_is_named() {
    let text = "parameter a = 8 [m] in 0..1e6\nparameter K = 8 [s] in 0.1..1e6\ny = a*t/(K + t)";
    let outcome = fit(text, "y", &["a", "K"], &data(60, 2.0, 0.06, |t| 10.0 * t / (20.0 + t)), Method::DormandPrince);
    let found = of_lack(&outcome, Lack::Weak);
    assert_eq!(found.len(), 1, "{:?}", outcome.parameters);
    assert_eq!(found[0].combinations, ["a/K"]);
    assert!(found[0].text(catalogues::with(Language::Spanish)).contains("a/K"));
    // With values up to the half, both parameters are determined.
    let outcome = fit(text, "y", &["a", "K"], &data(60, 30.0, 0.06, |t| 10.0 * t / (20.0 + t)), Method::DormandPrince);
    assert_eq!(outcome.undetermined, []);
}

#[test]
fn rates_of_a_chain_can_exchange_their_values() {
    let chain = "
parameter N = 1
parameter p = 0.5 [1/s]
parameter q = 1 [1/s]
A' = -p*A
B' = p*A - q*B
C' = q*B
A(0) = N
B(0) = 0
C(0) = 0
";
    let (p, q) = (0.3, 1.7);
    let e = |t: f64| (libm::exp(-p * t), libm::exp(-q * t));
    let of_b = |t: f64| p / (q - p) * (e(t).0 - e(t).1);
    let of_c = |t: f64| 1.0 - (q * e(t).0 - p * e(t).1) / (q - p);
    let exchanged = |name: &str, names: &[&str], values: &dyn Fn(f64) -> f64| {
        let outcome = fit(chain, name, names, &data(60, 10.0, 2e-3, values), Method::DormandPrince);
        of_lack(&outcome, Lack::Exchange).iter().map(|one| one.names.clone()).collect::<Vec<_>>()
    };
    let pair = [["p".to_owned(), "q".to_owned()].to_vec()];
    assert_eq!(exchanged("C", &["p", "q"], &of_c), pair);
    assert_eq!(exchanged("B", &["N", "p", "q"], &of_b), pair);
    // With a known value at the start, B breaks the symmetry.
    assert!(exchanged("B", &["p", "q"], &of_b).is_empty());
    // So does an oscillation.
    let swing = |t: f64| 0.05 * libm::exp(-0.4 * t) * libm::cos(9.0 * t);
    let outcome = fit(DAMPED_COSINE, "y", &DAMPED_COSINE_NAMES, &data(100, 5.0, 1e-3, swing), Method::DormandPrince);
    assert_eq!(outcome.undetermined, []);
}

/// While a fit is refined, its sum of squares never grows, except by the higher accuracy of the integration.
#[test]
fn a_fit_never_ends_above_the_best_that_it_had() {
    let sum = "parameter a = 1\nparameter b = 2\nparameter p = 3 [1/s]\nparameter q = 0.1 [1/s]\ny = a*exp(-p*t) + b*exp(-q*t)";
    let motion = "parameter k = 50 [1/s^2]\nparameter r = 0.3 [1/s]\nparameter m = 0.1\nparameter x_0 = 1\nx'' = -k*x - r*x' - m*x'*abs(x')\nx(0) = x_0\nx'(0) = 0 [1/s]\ny = x";
    let fall = "parameter h = 1 [m]\nparameter e = 0.7 in 0..1\nx'' = -9.8 [m/s^2]\nx(0) = h\nx'(0) = 0 [m/s]\nwhen x < 0 [m] { x' = -e*x' }\ny = x";
    let decay = |t: f64| libm::exp(-0.5 * t) + 2.0 * libm::exp(-2.0 * t);
    let swing = |t: f64| libm::exp(-0.3 * t) * libm::cos(8.0 * t);
    let bounce = |t: f64| {
        // From 1.3 m, with 0.8 of the velocity after each impact.
        let (mut start, mut velocity) = ((2.0 * 1.3 / 9.8_f64).sqrt(), (2.0 * 1.3 * 9.8_f64).sqrt());
        if t < start {
            return 1.3 - 4.9 * t * t;
        }
        loop {
            velocity *= 0.8;
            let end = start + 2.0 * velocity / 9.8;
            if t < end {
                return velocity * (t - start) - 4.9 * (t - start) * (t - start);
            }
            start = end;
        }
    };
    type Case<'a> = (&'a str, &'a [&'a str], &'a dyn Fn(f64) -> f64);
    let cases: [Case; 3] =
        [(sum, &["a", "b", "p", "q"], &decay), (motion, &["k", "r", "m", "x_0"], &swing), (fall, &["h", "e"], &bounce)];
    for (text, names, curve) in cases {
        let model = model(text);
        let (times, values) = data(60, 2.0, 0.02, curve);
        let mut fit =
            Fit::new(&model, task(&model, record(vec![observation(&model, "y", 0, &times, &values)]), names)).unwrap();
        let mut most = 0.0;
        loop {
            let finished = fit.advance();
            let left = 1.0 - fit.explained();
            assert!(most == 0.0 || left <= (1.0 - most) * (1.0 + 1e-5), "{text}: {left} {most}");
            most = fit.explained();
            if finished {
                break;
            }
        }
        assert!(most > 0.5, "{text}: {most}");
    }
}
