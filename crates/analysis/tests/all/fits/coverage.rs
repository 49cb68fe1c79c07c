//! Coverage of the uncertainties: how often an interval contains the true value.

use crate::support::Noise;
use crate::support::fitting::{
    DAMPED_COSINE, DAMPED_COSINE_NAMES, fitted, model, observation, on_all_processors, parameter, record, task,
};
use analysis::fit::{Estimate, Fit, profile};
use program::Model;

const MOTION: &str = "
parameter k = 92 [s^-2]
parameter gamma = 0.4 [1/s]
parameter x_0 = 0.05 [m]
parameter v_0 = -0.2 [m/s]
parameter c = 0.002 [m]
x'' = -2*gamma*x' - k*x
x(0) = x_0
x'(0) = v_0
y = x + c
";

const LINE: &str = "
parameter c = 2 [m]
parameter s = -0.3 [m/s]
y = c + s*t
";

/// Coverage of one parameter, over many records with known truth.
struct Coverage {
    name: &'static str,
    /// Percentage of intervals from the textbook errors that contain the true value.
    textbook: f64,
    /// Percentage of intervals from the errors robust to autocorrelation.
    robust: f64,
    /// Percentage of the intervals of 95 % confidence.
    wide: f64,
    /// Percentage of records reported as short for their correlation.
    short: f64,
    /// Mean textbook error, as a part of the true scatter.
    ratio: f64,
}

/// Fits `records` records of `rows` values at 30 a second, with the noise of an autoregressive process of order one whose
/// correlation is `rho`.
fn coverage(text: &str, names: &[&'static str], (records, rows): (u32, u32), rho: f64) -> Vec<Coverage> {
    let model = model(text);
    let times: Vec<f64> = (0..rows).map(|row| f64::from(row) / 30.0).collect();
    let clean = curve(&model, &times);
    let truth: Vec<f64> = names.iter().map(|name| model.parameters[parameter(&model, name)].value).collect();
    let mut noise = Noise::new(2_025);
    let mut simulated = || {
        let mut scatter = noise.normal();
        let mut disturbed = |value: &f64| {
            scatter = rho * scatter + (1.0 - rho * rho).sqrt() * noise.normal();
            value + 5e-4 * scatter
        };
        clean.iter().map(&mut disturbed).collect::<Vec<f64>>()
    };
    let simulated: Vec<Vec<f64>> = (0..records).map(|_| simulated()).collect();
    // For each record and each of its estimates.
    let counts = on_all_processors(&simulated, |values| {
        let outcome = fitted(&model, task(&model, record(vec![observation(&model, "y", 0, &times, values)]), names));
        let counts = |(estimate, truth): (&Estimate, &f64)| {
            let off = estimate.value - truth;
            let [textbook, robust] = [estimate.stderr, estimate.stderr_hac].map(Option::unwrap);
            let (low, high) = estimate.interval().unwrap();
            [
                f64::from(off.abs() <= textbook),
                f64::from(off.abs() <= robust),
                textbook,
                off * off,
                f64::from((low..=high).contains(truth)),
                f64::from(outcome.is_short()),
            ]
        };
        outcome.parameters.iter().zip(&truth).map(counts).collect::<Vec<_>>()
    });
    let mut sums = vec![[0.0; 6]; names.len()];
    for of_record in &counts {
        for (sums, counts) in sums.iter_mut().zip(of_record) {
            sums.iter_mut().zip(counts).for_each(|(sum, count)| *sum += count);
        }
    }
    let mean = |sum: f64| sum / f64::from(records);
    let coverage = |(name, sums): (&&'static str, &[f64; 6])| Coverage {
        name,
        textbook: 100.0 * mean(sums[0]),
        robust: 100.0 * mean(sums[1]),
        ratio: mean(sums[2]) / mean(sums[3]).sqrt(),
        wide: 100.0 * mean(sums[4]),
        short: 100.0 * mean(sums[5]),
    };
    names.iter().zip(&sums).map(coverage).collect()
}

/// The curve at the model's own values.
fn curve(model: &Model, times: &[f64]) -> Vec<f64> {
    let mut task = task(model, record(vec![observation(model, "y", 0, times, times)]), &["c"]);
    let own = model.parameters[parameter(model, "c")].value;
    task.varied[0].bounds = Some((own.next_down(), own.next_up()));
    let mut fit = Fit::new(model, task).unwrap();
    fit.complete();
    fit.outcome().unwrap().observations[0].fitted.clone()
}

#[test]
fn two_of_three_intervals_contain_the_truth() {
    for one in coverage(DAMPED_COSINE, &DAMPED_COSINE_NAMES, (2_000, 200), 0.0) {
        let Coverage { name, textbook, robust, .. } = one;
        assert!((63.0..73.0).contains(&textbook) && (63.0..73.0).contains(&robust), "{name}: {textbook} {robust}");
    }
}

#[test]
fn and_so_they_do_for_an_equation_of_motion() {
    // Fewer records, with a wider tolerance: the standard deviation of the count is 3.8 per cent.
    for one in coverage(MOTION, &["k", "gamma", "x_0", "v_0", "c"], (150, 200), 0.0) {
        let Coverage { name, textbook, robust, .. } = one;
        assert!((58.0..78.0).contains(&textbook) && (58.0..78.0).contains(&robust), "{name}: {textbook} {robust}");
    }
}

/// Positively correlated noise hides in slow changes: the textbook error of the offset is three times too small, and that
/// of the oscillation, which is faster than the correlation time of the noise, nearly twice.
#[test]
fn errors_robust_to_autocorrelation_hold_where_the_textbook_fails() {
    for one in coverage(DAMPED_COSINE, &DAMPED_COSINE_NAMES, (800, 200), 0.8) {
        let Coverage { name, textbook, robust, ratio, .. } = one;
        let too_small = if name == "c" { 2.5..4.0 } else { 1.6..2.2 };
        assert!(too_small.contains(&(1.0 / ratio)), "{name}: {ratio}");
        assert!(textbook < 50.0 && (61.0..74.0).contains(&robust), "{name}: {textbook} {robust}");
    }
}

/// From short to long records, from independent errors to strongly correlated ones. With `--nocapture` it prints the table.
#[test]
fn intervals_contain_the_truth_for_correlated_errors_in_short_and_long_records() {
    println!(
        "{:7} {:>5} {:>4}  {:>15} {:>15} {:>15} {:>6}",
        "", "rows", "rho", "textbook 68 %", "68 %", "95 %", "short"
    );
    let cosine = ("cosine", DAMPED_COSINE, &DAMPED_COSINE_NAMES[..]);
    for model in [("line", LINE, &["c", "s"][..]), cosine] {
        for length in [(60, 600), (200, 600), (1_000, 250)] {
            for rho in [0.0, 0.5, 0.8] {
                covers(model, length, rho);
            }
        }
    }
}

/// Panics unless the intervals of a model's parameters contain the truth as often as they say, in records of this length, whose
/// errors have this autocorrelation. Prints a row of the table.
fn covers((title, text, names): (&str, &str, &[&'static str]), (rows, records): (u32, u32), rho: f64) {
    let found = coverage(text, names, (records, rows), rho);
    let range = |of: &dyn Fn(&Coverage) -> f64| {
        found.iter().map(of).fold((f64::MAX, 0.0), |(low, high): (f64, f64), one| (low.min(one), high.max(one)))
    };
    let (textbook, robust, wide) = (range(&|one| one.textbook), range(&|one| one.robust), range(&|one| one.wide));
    let text = |(low, high): (f64, f64)| format!("{low:.1} to {high:.1}");
    let short = found[0].short;
    // Chance alone has a standard deviation of 1.9 per cent, and of 2.9 in the longest records.
    let room = if rows == 1_000 { 3.0 } else { 0.0 };
    let within = |(low, high): (f64, f64), least: f64, most: f64| low >= least - room && high <= most + room;
    assert!(within(robust, 60.0, 75.0), "{title} {rows} {rho}: {}", text(robust));
    assert!(within(wide, 90.0, 99.0), "{title} {rows} {rho}: {}", text(wide));
    // A record short for its correlation is reported.
    match (rows, rho) {
        (60, 0.8) => assert!(short > 80.0, "{title}: {short}"),
        (_, 0.0) | (1_000, _) => assert!(short < 1.0, "{title} {rows} {rho}: {short}"),
        _ => {}
    }
    println!("{title:7} {rows:5} {rho:4}  {:>15} {:>15} {:>15} {short:6.1}", text(textbook), text(robust), text(wide));
}

#[test]
fn the_profile_of_a_straight_line_is_its_standard_error() {
    let line = model("parameter a = 1 [m]\nparameter b = 0 [m/s]\ny = a + b*t");
    let times: Vec<f64> = (0..30).map(f64::from).collect();
    let mut noise = Noise::new(7);
    let values: Vec<f64> = times.iter().map(|time| 2.0 - 0.1 * time + 0.3 * noise.normal()).collect();
    let mut fit = Fit::new(&line, task(&line, record(vec![observation(&line, "y", 0, &times, &values)]), &["a", "b"]));
    let fit = fit.as_mut().unwrap();
    fit.complete();
    let outcome = fit.outcome().unwrap();
    for (index, estimate) in outcome.parameters.iter().enumerate() {
        let stderr = estimate.stderr.unwrap();
        for (deviations, interval) in [1.0, 2.0].into_iter().zip(profile(fit, index, stderr, outcome.dof)) {
            for (end, side) in [(interval.low, -1.0), (interval.high, 1.0)] {
                let expected = estimate.value + side * deviations * stderr;
                assert!((end.unwrap() - expected).abs() < 2e-3 * stderr, "{}: {interval:?} {expected}", estimate.name);
            }
        }
    }
}

/// A growth measured hardly to its end: the limit may be far above, but not far below the estimate.
#[test]
fn profiles_of_a_bent_problem_are_lopsided_and_contain_the_truth() {
    let growth = model("parameter c = 1 [m]\nparameter r = 0.5 [1/s]\ny = c*(1 - exp(-r*t))");
    let times: Vec<f64> = (1..=24).map(|row| 0.125 * f64::from(row)).collect();
    let clean = curve(&growth, &times);
    let mut noise = Noise::new(11);
    let (records, mut inside, mut lopsided) = (400, [0.0; 2], 0);
    for _ in 0..records {
        let values: Vec<f64> = clean.iter().map(|value| value + 0.02 * noise.normal()).collect();
        let observation = observation(&growth, "y", 0, &times, &values);
        let mut fit = Fit::new(&growth, task(&growth, record(vec![observation]), &["c", "r"])).unwrap();
        fit.complete();
        let outcome = fit.outcome().unwrap();
        let estimate = &outcome.parameters[0];
        let intervals = profile(&mut fit, 0, estimate.stderr.unwrap(), outcome.dof);
        for (inside, interval) in inside.iter_mut().zip(intervals) {
            let contains = interval.low.is_none_or(|low| low <= 1.0) && interval.high.is_none_or(|high| high >= 1.0);
            *inside += 100.0 * f64::from(contains) / f64::from(records);
        }
        let [near, far] = [intervals[1].low, intervals[1].high]
            .map(|end| end.map_or(f64::INFINITY, |end| (end - estimate.value).abs()));
        lopsided += i32::from(far > 1.2 * near);
    }
    assert!((62.0..73.0).contains(&inside[0]) && (92.0..98.0).contains(&inside[1]), "{inside:?}");
    assert!(lopsided > records * 4 / 5, "{lopsided}");
}

/// Errors that grow with the distance from the middle: the variance of the slope is sum(x^4)/sum(x^2)^2, 9/5 of that for errors of one
/// size (H. White, Econometrica 48 (1980) 817).
#[test]
fn errors_of_uneven_size_are_in_the_standard_errors() {
    let line = model(LINE);
    let times: Vec<f64> = (0..101).map(|row| f64::from(row - 50) / 50.0).collect();
    let power = |power: f64| times.iter().map(|time| libm::pow(time.abs(), power)).sum::<f64>();
    let truth = 5e-4 * power(4.0).sqrt() / power(2.0);
    let mut noise = Noise::new(1_980);
    let (mut textbook, mut robust) = (0.0, 0.0);
    for _ in 0..300 {
        let value = |time: &f64| 2.0 - 0.3 * time + 5e-4 * time.abs() * noise.normal();
        let values: Vec<f64> = times.iter().map(value).collect();
        let observed = observation(&line, "y", 0, &times, &values);
        let outcome = fitted(&line, task(&line, record(vec![observed]), &["c", "s"]));
        let found = outcome.estimate("s").unwrap();
        textbook += found.stderr.unwrap() / truth / 300.0;
        robust += found.stderr_hac.unwrap() / truth / 300.0;
    }
    assert!((textbook - (5.0_f64 / 9.0).sqrt()).abs() < 0.02, "{textbook}");
    assert!((robust - 1.0).abs() < 0.05, "{robust}");
}
