//! Judgement of residuals: outliers, verdicts, criteria.

use crate::support::Noise;
use crate::support::fitting::{
    DAMPED_COSINE, DAMPED_COSINE_NAMES, fitted, model, observation, parameter, record, task,
};
use analysis::fit::{Fit, Observation, Outcome, Varied, Verdict, rank};
use program::Model;
use units::Language;

const LINE: &str = "parameter a = 2 [m]\nparameter s = -0.3 [m/s]\ny = a + s*t";
const SIGMA: f64 = 5e-4;

fn swing(time: f64) -> f64 {
    0.05 * libm::exp(-0.4 * time) * libm::cos(9.6 * time + 0.5) + 0.002
}

fn frames(count: u32) -> Vec<f64> {
    (0..count).map(|row| f64::from(row) / 30.0).collect()
}

/// Values with noise whose neighbours have the correlation `rho`.
fn noisy(times: &[f64], noise: &mut Noise, rho: f64, truth: impl Fn(f64) -> f64) -> Vec<f64> {
    let mut scatter = noise.normal();
    let value = |time: &f64| {
        scatter = rho * scatter + (1.0 - rho * rho).sqrt() * noise.normal();
        truth(*time) + SIGMA * scatter
    };
    times.iter().map(value).collect()
}

fn fit(model: &Model, names: &[&str], times: &[f64], values: &[f64]) -> Outcome {
    fitted(model, task(model, record(vec![observation(model, "y", 0, times, values)]), names))
}

/// The rows of the outliers.
fn rows(outcome: &Outcome) -> Vec<usize> {
    outcome.outliers.iter().map(|one| one.row).collect()
}

#[test]
fn one_value_that_is_off_is_named_and_changes_no_verdict() {
    let swing_model = model(DAMPED_COSINE);
    let line = model(LINE);
    let truth = |time: f64| 2.0 - 0.3 * time;
    let mut noise = Noise::new(4_711);
    for (model, names, count) in [
        (&swing_model, &DAMPED_COSINE_NAMES[..], 200),
        (&swing_model, &DAMPED_COSINE_NAMES, 60),
        (&line, &["a", "s"], 100),
    ] {
        let times = frames(count);
        for size in [20.0, 100.0] {
            let (mut alone, mut random) = (0, 0);
            for number in 0..100 {
                let straight = names.len() == 2;
                let mut values =
                    noisy(&times, &mut noise, 0.0, |time| if straight { truth(time) } else { swing(time) });
                let clean = fit(model, names, &times, &values);
                let row = number * 7_919 % times.len();
                let sign = if number % 2 == 0 { 1.0 } else { -1.0 };
                values[row] += sign * size * SIGMA;
                let outcome = fit(model, names, &times, &values);
                let named = outcome.outliers.iter().find(|one| one.row == row);
                let sigmas = sign * named.unwrap().sigmas;
                assert!((0.5 * size..2.0 * size).contains(&sigmas), "{count} {size} {number}: {sigmas}");
                // By chance one clean record in two hundred has an outlier or another verdict.
                alone += i32::from(outcome.outliers.len() == 1);
                random += i32::from(outcome.verdict() == Verdict::Compatible);
                assert!((outcome.autocorrelation - clean.autocorrelation).abs() < 0.12, "{count} {size} {number}");
            }
            println!("{count} rows, {size} sigma: named alone in {alone}, random in {random} of 100");
            assert!(alone >= 98 && random >= 98, "{count} {size}: {alone} {random}");
        }
    }
}

#[test]
fn a_clean_record_has_no_outliers() {
    let model = model(DAMPED_COSINE);
    let mut noise = Noise::new(12);
    for (count, rho) in [(60, 0.0), (60, 0.8), (200, 0.0), (200, 0.8)] {
        let times = frames(count);
        let named = (0..300).filter(|_| {
            let values = noisy(&times, &mut noise, rho, swing);
            !fit(&model, &DAMPED_COSINE_NAMES, &times, &values).outliers.is_empty()
        });
        let named = named.count();
        assert!(named < 3, "{count} {rho}: {named} of 300");
    }
}

/// Two outliers side by side, and one at the end, where a single value has the greatest influence.
#[test]
fn several_outliers_are_named() {
    let model = model(DAMPED_COSINE);
    let times = frames(200);
    let mut noise = Noise::new(77);
    for rho in [0.0, 0.8] {
        let mut values = noisy(&times, &mut noise, rho, swing);
        for (row, off) in [(0, 40.0), (50, -30.0), (51, 60.0), (120, 25.0), (199, -40.0)] {
            values[row] += off * SIGMA;
        }
        assert_eq!(rows(&fit(&model, &DAMPED_COSINE_NAMES, &times, &values)), [0, 50, 51, 120, 199], "{rho}");
    }
}

/// A wrong theory leaves large residuals where the motion is large: these are not outliers.
#[test]
fn what_a_theory_misses_is_no_outlier() {
    let model = model(DAMPED_COSINE);
    let times = frames(200);
    let mut noise = Noise::new(5);
    for _ in 0..20 {
        let values =
            noisy(&times, &mut noise, 0.0, |time| swing(time) + 0.01 * libm::exp(-1.5 * time) * libm::cos(25.0 * time));
        let outcome = fit(&model, &DAMPED_COSINE_NAMES, &times, &values);
        assert_eq!((rows(&outcome), outcome.verdict()), (Vec::new(), Verdict::Structured));
    }
}

#[test]
fn exact_fits_come_first_and_are_as_good_as_each_other() {
    let line = model(LINE);
    let parabola = model("parameter a = 2 [m]\nparameter s = -0.3 [m/s]\nparameter b = 0 [m/s^2]\ny = a + s*t + b*t^2");
    let other = model("parameter p = 1 [m]\nparameter q = 1 [m/s]\ny = p + q*(t - 1 [s])");
    let constant = model("parameter a = 2 [m]\ny = a + 0*t*1[m/s]");
    let times = frames(100);
    let values: Vec<f64> = times.iter().map(|time| 2.5 + 0.5 * time).collect();
    let outcomes = [
        fit(&constant, &["a"], &times, &values),
        fit(&parabola, &["a", "s", "b"], &times, &values),
        fit(&line, &["a", "s"], &times, &values),
        fit(&other, &["p", "q"], &times, &values),
    ];
    assert_eq!(outcomes.each_ref().map(|one| one.exact), [false, true, true, true]);
    assert_eq!(outcomes[2].verdict(), Verdict::Exact);
    for outcome in &outcomes {
        assert!(outcome.aicc.unwrap().is_finite() && outcome.bic.is_finite());
    }
    let ranked = rank(&outcomes.each_ref());
    // The two lines are one theory; the parabola has one number more.
    assert_eq!(ranked.iter().map(|one| one.index).collect::<Vec<_>>(), [2, 3, 1, 0]);
    assert_eq!((ranked[0].difference, ranked[1].difference), (0.0, 0.0));
    assert!((ranked[0].weight - ranked[1].weight).abs() < 1e-12 && ranked.iter().all(|one| one.weight.is_finite()));
    assert!((1.0..5.0).contains(&ranked[2].difference) && ranked[3].difference > 1_000.0, "{ranked:?}");
    // A record without any change is fitted exactly, too.
    let still = fit(&constant, &["a"], &times, &vec![0.0; times.len()]);
    assert!(still.exact && still.aicc.unwrap().is_finite() && still.outliers.is_empty());
    // An outlier among rounding errors is found, too.
    let mut values = values;
    values[30] += 1.0;
    assert_eq!(rows(&fit(&line, &["a", "s"], &times, &values)), [30]);
}

/// The verdict covers all measured values: structure in a second column, or in a second record, counts.
#[test]
fn verdicts_are_of_all_columns_and_records() {
    let model = model("parameter a = 1 [m]\nparameter b = 1 [m/s]\ny = a + 0*t*1[m/s]\nv = b + 0*t*1[m/s^2]");
    let mut noise = Noise::new(21);
    let (few, many) = (frames(30), frames(1_000));
    for _ in 0..20 {
        let random = |times: &[f64], noise: &mut Noise| noisy(times, noise, 0.0, |_| 1.0);
        let structured = noisy(&many, &mut noise, 0.5, |_| 1.0);
        let (short, long) = (random(&few, &mut noise), random(&many, &mut noise));
        let columns = |long: &[f64]| {
            let columns = vec![observation(&model, "y", 0, &few, &short), observation(&model, "v", 0, &many, long)];
            fitted(&model, task(&model, record(columns), &["a", "b"]))
        };
        let [two, bad] = [&long, &structured].map(|long| columns(long));
        assert_eq!((two.judged, bad.judged), (1_030, 1_030));
        assert_eq!(bad.verdict(), Verdict::Missed);
        // The same values in two records.
        let records = |long: &[f64]| {
            let one = |times: &[f64], values: &[f64]| record(vec![observation(&model, "y", 0, times, values)]);
            let mut task = task(&model, one(&few, &short), &["a"]);
            task.records.push(one(&many, long));
            fitted(&model, task)
        };
        let [apart, bad] = [&long, &structured].map(|long| records(long));
        assert_eq!(bad.verdict(), Verdict::Missed);
        // They leave the same residuals, so the verdict is the same.
        assert_eq!(apart.verdict(), two.verdict());
        assert!((apart.autocorrelation - two.autocorrelation).abs() < 1e-9);
    }
}

/// Straight line by the formulas of textbooks: AICc = deviance + 2k + 2k(k + 1)/(n - k - 1) and BIC = deviance + k ln n (Burnham &
/// Anderson, Model Selection, 2002, sections 2.4 and 6.4), with n ln(sum/n) as the deviance of errors that are estimated, whose variance
/// is one more number, and with chi^2 for errors that are given.
#[test]
fn criteria_and_intervals_of_a_line_are_those_of_textbooks() {
    let line = model(LINE);
    let times = frames(30);
    let values = noisy(&times, &mut Noise::new(5), 0.0, |time| 2.0 - 0.3 * time);
    let mean = |values: &[f64]| values.iter().sum::<f64>() / 30.0;
    let (mean_time, mean_value) = (mean(&times), mean(&values));
    let square: f64 = times.iter().map(|time| (time - mean_time) * (time - mean_time)).sum();
    let rows = || times.iter().zip(&values).map(|(time, value)| (time - mean_time, value - mean_value));
    let slope = rows().map(|(time, value)| time * value).sum::<f64>() / square;
    let sum: f64 = rows().map(|(time, value)| (value - slope * time) * (value - slope * time)).sum();
    let observed = observation(&line, "y", 0, &times, &values);
    let given = Observation { errors: Some(vec![SIGMA; 30]), ..observed.clone() };
    let estimated = 30.0 * libm::log(sum / 30.0);
    for (observed, k, deviance) in [(observed, 3.0, estimated), (given, 2.0, sum / (SIGMA * SIGMA))] {
        let outcome = fitted(&line, task(&line, record(vec![observed]), &["a", "s"]));
        let aicc = deviance + 2.0 * k + 2.0 * k * (k + 1.0) / (30.0 - k - 1.0);
        let bic = deviance + k * libm::log(30.0);
        assert!((outcome.aicc.unwrap() - aicc).abs() < 1e-6, "{:?} {aicc}", outcome.aicc);
        assert!((outcome.bic - bic).abs() < 1e-6, "{} {bic}", outcome.bic);
        let r2 = 1.0 - sum / rows().map(|(_, value)| value * value).sum::<f64>();
        assert!((outcome.r2 - r2).abs() < 1e-9 && (outcome.observations[0].r2 - r2).abs() < 1e-9, "{}", outcome.r2);
        assert!((outcome.observations[0].rmse / (sum / 30.0).sqrt() - 1.0).abs() < 1e-9);
        let correlation = -mean_time / (times.iter().map(|time| time * time).sum::<f64>() / 30.0).sqrt();
        for (found, expected) in outcome.correlation.iter().zip([1.0, correlation, correlation, 1.0]) {
            assert!((found - expected).abs() < 1e-9, "{:?}", outcome.correlation);
        }
        let found = outcome.estimate("s").unwrap();
        let (low, high) = found.interval().unwrap();
        // Student's t of 28 degrees of freedom, and of fewer because the correlation of the errors is not known.
        assert!((2.0484..2.15).contains(&found.coverage_factor()), "{}", found.coverage_factor());
        let reach = found.coverage_factor() * found.stderr_hac.unwrap();
        assert!((low - (slope - reach)).abs() < 1e-9 && (high - (slope + reach)).abs() < 1e-9, "{low} {high}");
    }
}

/// A number stopped by its range does not count in AICc nor as a determined number.
#[test]
fn a_number_at_its_bound_is_not_counted() {
    let line = model("parameter a = 1 [m]\nparameter s = 0 [m/s] in -1..0.2\ny = a + s*t");
    let times = frames(50);
    let values = noisy(&times, &mut Noise::new(10), 0.0, |time| 2.0 + 0.3 * time);
    let stopped = fit(&line, &["a", "s"], &times, &values);
    let mut held = task(&line, record(vec![observation(&line, "y", 0, &times, &values)]), &["a"]);
    held.parameters[parameter(&line, "s")] = 0.2;
    let held = fitted(&line, held);
    assert!(stopped.parameters[1].at_bound);
    assert_eq!((stopped.n - stopped.dof, held.n - held.dof), (1, 1));
    assert!((stopped.aicc.unwrap() - held.aicc.unwrap()).abs() < 1e-9);
    assert!((stopped.bic - held.bic).abs() < 1e-9);
}

/// Correlated residuals carry less information than as many independent ones, which reduces the weights of theories.
#[test]
fn weights_of_evidence_count_independent_values() {
    let line = model(LINE);
    let parabola = model("parameter a = 2 [m]\nparameter s = -0.3 [m/s]\nparameter b = 0 [m/s^2]\ny = a + s*t + b*t^2");
    let times = frames(300);
    let values = noisy(&times, &mut Noise::new(3), 0.9, |time| 2.0 - 0.3 * time);
    let outcomes = [fit(&line, &["a", "s"], &times, &values), fit(&parabola, &["a", "s", "b"], &times, &values)];
    let ranked = rank(&outcomes.each_ref());
    let best = &outcomes[ranked[0].index];
    let worth = best.independent / 300.0;
    assert!((0.01..0.15).contains(&worth), "{worth}");
    let aicc = |place: usize| outcomes[ranked[place].index].aicc.unwrap();
    let expected = worth * (aicc(1) - aicc(0));
    assert!((ranked[1].difference / expected - 1.0).abs() < 1e-9, "{ranked:?}");
    let evidence = libm::exp(-0.5 * ranked[1].difference);
    assert!((ranked[1].weight / ranked[0].weight / evidence - 1.0).abs() < 1e-9, "{ranked:?}");
}

/// Records with their own numbers are determined as well together as each alone: a number of another record has no score,
/// and must not count in the choice of lags.
#[test]
fn numbers_of_another_record_do_not_change_the_errors() {
    let model = model(DAMPED_COSINE);
    let (long, short) = (frames(300), frames(150));
    let mut noise = Noise::new(31);
    let one = record(vec![observation(&model, "y", 0, &long, &noisy(&long, &mut noise, 0.7, swing))]);
    let other = record(vec![observation(&model, "y", 0, &short, &noisy(&short, &mut noise, 0.2, swing))]);
    let alone = [&one, &other].map(|record| fitted(&model, task(&model, record.clone(), &DAMPED_COSINE_NAMES)));
    let mut both = task(&model, one, &DAMPED_COSINE_NAMES);
    both.records.push(other);
    both.varied = DAMPED_COSINE_NAMES.iter().map(|name| Varied::parameter(parameter(&model, name))).collect();
    let both = fitted(&model, both);
    for estimate in &both.parameters {
        let alone = alone[estimate.record.unwrap()].estimate(&estimate.name).unwrap();
        let ratio = estimate.stderr_hac.unwrap() / alone.stderr_hac.unwrap();
        assert!((ratio - 1.0).abs() < 1e-3, "{} {:?}: {ratio}", estimate.name, estimate.record);
    }
}

/// Residuals of one sign have no runs test, which does not mean too few values.
#[test]
fn residuals_of_one_sign_are_autocorrelated() {
    let model = model("parameter a = 0.5 [m] in 0..1\ny = a + 0*t*1[m/s]");
    let times = frames(300);
    let values = noisy(&times, &mut Noise::new(41), 0.0, |_| 1.02);
    let mut observed = observation(&model, "y", 0, &times, &values);
    observed.errors = Some(vec![2e-3; times.len()]);
    let outcome = fitted(&model, task(&model, record(vec![observed]), &["a"]));
    assert_eq!((outcome.runs, outcome.verdict()), (None, Verdict::Missed));
    let text = outcome.verdict_text(Language::English);
    assert!(text.contains("autocorrelated"), "{text}");
}

/// Oscillation whose frequency lies outside the range, and the same with a range that includes it.
#[test]
fn a_fit_that_misses_the_oscillation_says_so() {
    let times = frames(240);
    let values = noisy(&times, &mut Noise::new(45), 0.0, swing);
    for (range, verdict) in [("1..3", Verdict::Missed), ("1..15", Verdict::Compatible)] {
        let ranged = DAMPED_COSINE.replace("omega = 9.6 [1/s]", &["omega = 2 [1/s] in ", range].concat());
        let outcome = fit(&model(&ranged), &DAMPED_COSINE_NAMES, &times, &values);
        assert_eq!(outcome.verdict(), verdict, "{ranged}: {}", outcome.r2);
        assert_eq!(outcome.r2 < 0.5, verdict == Verdict::Missed);
    }
}

#[test]
fn neighbours_of_opposite_signs_are_not_random() {
    let model = model(LINE);
    let times = frames(300);
    let mut noise = Noise::new(42);
    for _ in 0..20 {
        let values = noisy(&times, &mut noise, -0.5, |time| 2.0 - 0.3 * time);
        let outcome = fit(&model, &["a", "s"], &times, &values);
        assert_eq!(outcome.verdict(), Verdict::Alternating, "{}", outcome.durbin_watson);
        assert!(outcome.verdict_text(catalogues::with(Language::Spanish)).contains("el mayor de los dos errores"));
    }
    // Many parameters for few values make neighbouring residuals negatively correlated.
    let swing_model = self::model(DAMPED_COSINE);
    let times = frames(30);
    let verdicts: Vec<Verdict> = (0..100)
        .map(|_| fit(&swing_model, &DAMPED_COSINE_NAMES, &times, &noisy(&times, &mut noise, 0.0, swing)).verdict())
        .collect();
    let random = verdicts.iter().filter(|verdict| **verdict == Verdict::Compatible).count();
    assert!(random >= 97, "{random} of 100: {verdicts:?}");
}

/// A record is short if it has few independent values: 40 with slow noise, but neither 400 of them nor 40 random ones.
#[test]
fn few_independent_values_are_a_short_record() {
    let line = model(LINE);
    let mut noise = Noise::new(45);
    for (count, rho, expected) in [(40, 0.9, true), (400, 0.7, false), (40, 0.0, false)] {
        let times = frames(count);
        let mut is_short =
            || fit(&line, &["a", "s"], &times, &noisy(&times, &mut noise, rho, |time| 2.0 - 0.3 * time)).is_short();
        let short = (0..20).filter(|_| is_short()).count();
        assert!(if expected { short >= 17 } else { short <= 3 }, "{count} {rho}: {short} of 20");
    }
}

/// Wrong given errors are part of the verdict, however few values there are.
#[test]
fn chi_square_judges_few_values_too() {
    let model = model(LINE);
    let times = frames(8);
    let values = noisy(&times, &mut Noise::new(43), 0.0, |time| 2.0 - 0.3 * time);
    let verdict = |error: f64| {
        let mut observed = observation(&model, "y", 0, &times, &values);
        observed.errors = Some(vec![error; times.len()]);
        fitted(&model, task(&model, record(vec![observed]), &["a", "s"])).verdict()
    };
    let found = [0.05, 1.0, 1e3].map(|of_sigma| verdict(of_sigma * SIGMA));
    assert_eq!(found, [Verdict::TooLarge, Verdict::Unknown, Verdict::Unknown]);
}

#[test]
fn a_curve_through_noise_explains_nothing() {
    let (swing_model, line) = (model(DAMPED_COSINE), model(LINE));
    let mut noise = Noise::new(44);
    for count in [60, 400] {
        let times = frames(count);
        for (model, names) in [(&swing_model, &DAMPED_COSINE_NAMES[..]), (&line, &["a", "s"])] {
            let mut verdict = || {
                let values = noisy(&times, &mut noise, 0.0, |_| 2e-3);
                let observed = record(vec![observation(model, "y", 0, &times, &values)]);
                // A search in pure noise may not converge.
                let mut fit = Fit::new(model, task(model, observed, names)).unwrap();
                fit.complete();
                fit.outcome().unwrap().verdict()
            };
            let nothing = (0..20).filter(|_| verdict() == Verdict::Nothing).count();
            assert!(nothing >= 18, "{count} {names:?}: {nothing} of 20");
        }
        // An amplitude as large as the noise is detected.
        let weak = |time: f64| SIGMA * libm::cos(9.6 * time + 0.5);
        let outcome = fit(&swing_model, &DAMPED_COSINE_NAMES, &times, &noisy(&times, &mut noise, 0.0, weak));
        assert_eq!(outcome.verdict(), Verdict::Compatible, "{count}: {}", outcome.r2);
    }
}
