//! Tied parameters: a fit with `b = 2*a` is the fit of the model in which `b` is defined so.

use crate::support::Noise;
use crate::support::fitting::{fitted, model, observation, parameter, record, task};
use analysis::fit::{Estimate, Fit, FitError, Outcome, Record, Task, TiedParameter};
use program::{Compiled, Model};

/// Two decays, with the rate of the second left open.
const DECAYS: &str = "
parameter A = 1 [m]
parameter B = 0.5 [m]
parameter a = 0.7 [1/s]
parameter b = 2 [1/s]
half = ln(2)/b
y = A*exp(-a*t) + B*exp(-b*t)
";
/// Tied parameters, each with its expressions.
type Ties = &'static [(&'static str, &'static [&'static str])];

/// A swinging column whose length has a factor.
const COLUMN: &str = "
parameter L = 0.2 [m] in 0.01..10
parameter f = 1
parameter y_0 = 0.04 [m]
parameter v_0 = 0 [m/s]
LINE
x'' + (0.4 [1/s])*x' + 2*(9.8 [m/s^2])/LENGTH*x = 0
x(0) = y_0
x'(0) = v_0
y = x
";

/// The parameter called `name` with its values.
fn tie(model: &mut Model, name: &str, values: &[&str]) -> TiedParameter {
    let compile = |text: &&str| -> Compiled {
        let (expression, _, found) = model::parse_expression(text, 0..text.len());
        assert!(found.is_empty(), "{text}: {found:?}");
        model::Compiler::new(model).compile(&expression, None).expect(text)
    };
    let values = values.iter().map(compile).collect();
    TiedParameter { parameter: parameter(model, name), values }
}

/// Columns of length `L` m, with noise.
fn column(model: &Model, length: f64, seed: u64) -> Record {
    let mut noise = Noise::new(seed);
    let times: Vec<f64> = (0..120).map(|row| f64::from(row) / 30.0).collect();
    let omega = libm::sqrt(2.0 * 9.8 / length - 0.04);
    let values: Vec<f64> = times
        .iter()
        .map(|time| 0.05 * libm::exp(-0.2 * time) * libm::cos(omega * time) + 5e-4 * noise.normal())
        .collect();
    record(vec![observation(model, "y", 0, &times, &values)])
}

fn assert_same(tied: &Outcome, defined: &Outcome, names: &[&str]) {
    assert!((tied.chi2 / defined.chi2 - 1.0).abs() < 1e-6, "{} {}", tied.chi2, defined.chi2);
    assert_eq!(tied.dof, defined.dof);
    for name in names {
        let of = |outcome: &Outcome| -> Vec<Estimate> {
            let all = outcome.parameters.iter().chain(&outcome.derived);
            all.filter(|one| one.name == *name).cloned().collect()
        };
        let (tied, defined) = (of(tied), of(defined));
        assert!(!tied.is_empty() && tied.len() == defined.len(), "{name}: {tied:?} {defined:?}");
        for (tied, defined) in tied.iter().zip(&defined) {
            let (error, expected) = (tied.stderr_hac.expect(name), defined.stderr_hac.expect(name));
            assert!((tied.value - defined.value).abs() < 1e-3 * expected, "{name}: {tied:?} {defined:?}");
            assert!((error / expected - 1.0).abs() < 1e-3, "{name}: {error} {expected}");
        }
    }
}

#[test]
fn a_parameter_can_be_an_expression_of_others() {
    let mut noise = Noise::new(3);
    let times: Vec<f64> = (0..80).map(|row| f64::from(row) / 20.0).collect();
    let decay = |time: &f64| 1.2 * libm::exp(-0.5 * time) + 0.6 * libm::exp(-1.5 * time);
    let values: Vec<f64> = times.iter().map(|time| decay(time) + 2e-3 * noise.normal()).collect();
    let mut open = model(DECAYS);
    let observed = |model: &Model| record(vec![observation(model, "y", 0, &times, &values)]);
    let tied = vec![tie(&mut open, "b", &["3*a"]), tie(&mut open, "B", &["A*(b/a)/6"])];
    let task_of_tied = Task { tied, ..task(&open, observed(&open), &["A", "a"]) };
    let outcome = fitted(&open, task_of_tied);
    let text = DECAYS.replace("parameter B = 0.5 [m]", "B = A*(b/a)/6").replace("parameter b = 2 [1/s]", "b = 3*a");
    let defined = model(&text);
    assert_same(
        &outcome,
        &fitted(&defined, task(&defined, observed(&defined), &["A", "a"])),
        &["A", "a", "b", "B", "half"],
    );
    // Settings are those of the model without ties.
    let [a, b] = ["a", "b"].map(|name| outcome.settings[0][parameter(&open, name)]);
    assert!((b / a - 3.0).abs() < 1e-12 && outcome.settings[0].len() == open.parameters.len());
}

#[test]
fn a_parameter_can_be_another_expression_in_each_record() {
    let mut open = model(&COLUMN.replace("LENGTH", "L").replace("LINE", "parameter K = 0.2 [m]"));
    let tied = vec![tie(&mut open, "L", &["K", "2*K", "3*K"])];
    let records =
        |model: &Model| [0.21, 0.42, 0.63].iter().zip(1..).map(|(&length, seed)| column(model, length, seed)).collect();
    let mut shared = task(&open, Record::default(), &["K", "y_0", "v_0"]);
    shared.varied[0].shared = true;
    let outcome = fitted(&open, Task { tied, records: records(&open), ..shared });
    let defined = model(&COLUMN.replace("LENGTH", "l").replace("LINE", "l = f*L"));
    let mut shared = task(&defined, Record::default(), &["L", "y_0", "v_0"]);
    shared.varied[0].shared = true;
    let mut task = Task { records: records(&defined), ..shared };
    for (record, factor) in task.records.iter_mut().zip([1.0, 2.0, 3.0]) {
        record.fixed.push((parameter(&defined, "f"), factor));
    }
    let expected = fitted(&defined, task);
    assert_same(&outcome, &expected, &["y_0", "v_0"]);
    let lengths = |outcome: &Outcome, name: &str| -> Vec<(Option<usize>, f64)> {
        outcome.derived.iter().filter(|one| one.name == name).map(|one| (one.record, one.value)).collect()
    };
    let (found, known) = (lengths(&outcome, "L"), lengths(&expected, "l"));
    assert_eq!(found.iter().map(|(record, _)| *record).collect::<Vec<_>>(), [Some(0), Some(1), Some(2)]);
    for ((_, found), (_, known)) in found.iter().zip(&known) {
        assert!((found / known - 1.0).abs() < 1e-6, "{found} {known}");
    }
    assert!((found[0].1 - 0.21).abs() < 2e-3, "{found:?}");
}

#[test]
fn ties_that_make_no_sense_are_refused() {
    let times = [0.0, 0.5, 1.0, 1.5];
    let mut open = model(DECAYS);
    let place = |name: &str| parameter(&model(DECAYS), name);
    let cases: [(Ties, FitError); 6] = [
        (&[("b", &["2*b"])], FitError::TiedInCircle(place("b"))),
        (&[("b", &["2*B/A*a"]), ("B", &["A*b/a"])], FitError::TiedInCircle(place("B"))),
        (&[("a", &["2*b"])], FitError::VariedTwice(1)),
        (&[("b", &["1/t"])], FitError::BadTie(place("b"))),
        (&[("b", &["a", "2*a"])], FitError::BadTie(place("b"))),
        (&[("b", &["a"]), ("b", &["2*a"])], FitError::BadTie(place("b"))),
    ];
    for (ties, expected) in cases {
        let tied = ties.iter().map(|(name, values)| tie(&mut open, name, values)).collect();
        let observed = record(vec![observation(&open, "y", 0, &times, &[1.0, 0.7, 0.5, 0.4])]);
        let task = Task { tied, ..task(&open, observed, &["A", "a"]) };
        assert_eq!(Fit::new(&open, task).err(), Some(expected), "{ties:?}");
    }
}
