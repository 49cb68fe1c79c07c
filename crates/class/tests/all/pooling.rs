//! Pooled values: published meta-analyses, coverage of the intervals over synthetic classes, outliers and refusals.

use analysis::virtual_record::Chance;
use class::pooling::{Measured, Pooled, Reason, pool};
use units::Language;

fn measured(values: &[f64], errors: &[f64]) -> Vec<Measured> {
    values.iter().zip(errors).map(|(value, error)| Measured { value: *value, error: *error }).collect()
}

/// Pooled value, its standard error, interval, tau² and interval of tau².
fn numbers(pooled: &Pooled) -> [f64; 7] {
    let square = |value: f64| value * value;
    let (low, high) = pooled.tau_interval;
    [pooled.value, pooled.error, pooled.interval.0, pooled.interval.1, square(pooled.tau), square(low), square(high)]
}

/// Log risk ratios of 13 trials of the BCG vaccine (Colditz et al., JAMA 271 (1994) 698): cases and others, vaccinated and
/// not.
fn vaccine() -> Vec<Measured> {
    let trials = [
        [4, 119, 11, 128],
        [6, 300, 29, 274],
        [3, 228, 11, 209],
        [62, 13_536, 248, 12_619],
        [33, 5_036, 47, 5_761],
        [180, 1_361, 372, 1_079],
        [8, 2_537, 10, 619],
        [505, 87_886, 499, 87_892],
        [29, 7_470, 45, 7_232],
        [17, 1_699, 65, 1_600],
        [186, 50_448, 141, 27_197],
        [5, 2_493, 3, 2_338],
        [27, 16_886, 29, 17_825],
    ];
    let effect = |trial: [u32; 4]| {
        let [a, b, c, d] = trial.map(f64::from);
        let variance = 1.0 / a - 1.0 / (a + b) + 1.0 / c - 1.0 / (c + d);
        Measured { value: libm::log(a * (c + d) / ((a + b) * c)), error: variance.sqrt() }
    };
    trials.map(effect).to_vec()
}

/// Effects of teachers' expectations in 19 experiments (Raudenbush, J. Educ. Psychol. 76 (1984) 85), values and variances.
fn teachers() -> Vec<Measured> {
    let values = [
        0.03, 0.12, -0.14, 1.18, 0.26, -0.06, -0.02, -0.32, 0.27, 0.80, 0.54, 0.18, -0.02, 0.23, -0.18, -0.06, 0.30,
        0.07, -0.07,
    ];
    let variances: [f64; 19] = [
        0.0156, 0.0216, 0.0279, 0.1391, 0.1362, 0.0106, 0.0106, 0.0484, 0.0269, 0.0630, 0.0912, 0.0497, 0.0835, 0.0841,
        0.0253, 0.0279, 0.0193, 0.0088, 0.0303,
    ];
    measured(&values, &variances.map(f64::sqrt))
}

/// Effects of coaching in eight schools (Rubin, J. Educ. Stat. 6 (1981) 377).
fn schools() -> Vec<Measured> {
    measured(&[28.0, 8.0, -3.0, 7.0, -1.0, 1.0, 18.0, 12.0], &[15.0, 10.0, 16.0, 11.0, 9.0, 11.0, 10.0, 18.0])
}

/// Expected numbers from the definitions with SciPy's root finder and quantiles. The interval of tau² of the vaccine is also
/// that of Viechtbauer (2007), 0.1197 to 1.1115; the mean of the schools that of Rubin, 7.7.
#[test]
fn published_meta_analyses_are_met_to_four_digits() {
    let cases: [(Vec<Measured>, [f64; 7]); 3] = [
        (vaccine(), [-0.714_968, 0.180_892, -1.109_098, -0.320_838, 0.318_068, 0.119_718, 1.111_479]),
        (teachers(), [0.103_957, 0.068_208, -0.039_344, 0.247_257, 0.051_773, 0.005_861_5, 0.197_701]),
        (schools(), [7.685_617, 3.339_073, -0.210_035, 15.581_269, 0.0, 0.0, 270.367_2]),
    ];
    for (results, expected) in cases {
        let found = numbers(&pool(&results).unwrap().all);
        for (found, expected) in found.iter().zip(expected) {
            assert!((found - expected).abs() <= 5e-5 * expected.abs(), "{found} {expected}");
        }
    }
}

/// A kind of class: number of groups, stated error as a part of the true one, scatter between groups in errors, and the
/// probability of a result that is off by ten errors.
struct Kind {
    groups: u32,
    stated: f64,
    tau: f64,
    off: f64,
}

/// Share of 1,000 classes in per cent whose interval holds the true value: weighted mean, random effects, random effects
/// without outliers; and share of results marked that are not off.
fn coverage(kind: &Kind, seed: u64) -> [f64; 4] {
    let mut chance = Chance::new(seed);
    let (mut held, mut marked, mut good) = ([0_u32; 3], 0, 0);
    for _ in 0..1000 {
        let mut is_off = Vec::new();
        let group = |_| {
            let error = 0.5 + chance.uniform();
            let (one, other) = chance.normals();
            let off = chance.uniform() < kind.off;
            is_off.push(off);
            let value = error * one + kind.tau * other + if off { 10.0 * error } else { 0.0 };
            Measured { value, error: kind.stated * error }
        };
        let results: Vec<Measured> = (0..kind.groups).map(group).collect();
        let pooled = pool(&results).unwrap();
        let holds = |(low, high): (f64, f64)| u32::from(low <= 0.0 && 0.0 <= high);
        let weights: f64 = results.iter().map(|one| 1.0 / (one.error * one.error)).sum();
        let mean = results.iter().map(|one| one.value / (one.error * one.error)).sum::<f64>() / weights;
        let reach = 1.959_964 / weights.sqrt();
        held[0] += holds((mean - reach, mean + reach));
        held[1] += holds(pooled.all.interval);
        held[2] += holds(pooled.without.as_ref().unwrap_or(&pooled.all).interval);
        marked += pooled.outliers.iter().filter(|one| !is_off[one.index]).count();
        good += is_off.iter().filter(|off| !**off).count();
    }
    let [weighted, random, without] = held.map(|held| f64::from(held) / 10.0);
    [weighted, random, without, 100.0 * marked as f64 / good as f64]
}

#[test]
fn intervals_hold_in_95_of_100_classes_where_the_weighted_mean_does_not() {
    let kind = |groups, stated, tau, off| Kind { groups, stated, tau, off };
    // Share in per cent of the weighted mean, bounds of random effects, and of random effects without outliers.
    let cases = [
        ("honest errors", kind(40, 1.0, 0.0, 0.0), 92.0..98.0, 93.0..99.5, 93.0..99.5),
        ("errors too small", kind(40, 0.5, 0.0, 0.0), 60.0..76.0, 92.0..99.5, 90.0..99.5),
        ("groups differ", kind(40, 1.0, 2.0, 0.0), 20.0..60.0, 92.0..98.0, 92.0..98.0),
        ("one in ten off", kind(40, 1.0, 0.0, 0.1), 0.0..30.0, 40.0..85.0, 92.0..99.0),
        ("groups differ, one in ten off", kind(40, 1.0, 2.0, 0.1), 0.0..40.0, 40.0..85.0, 80.0..98.0),
        ("groups differ, 8 groups", kind(8, 1.0, 2.0, 0.0), 25.0..65.0, 91.0..98.0, 89.0..99.0),
    ];
    for (place, (name, kind, weighted, random, without)) in cases.into_iter().enumerate() {
        let found = coverage(&kind, 29 + place as u64);
        println!(
            "{name}: weighted mean {:.1} %, random effects {:.1} %, without outliers {:.1} %; false marks {:.2} %",
            found[0], found[1], found[2], found[3]
        );
        assert!(
            weighted.contains(&found[0]) && random.contains(&found[1]) && without.contains(&found[2]),
            "{name}: {found:?}"
        );
        assert!(found[3] < 2.0, "{name}: {found:?}");
    }
}

#[test]
fn outliers_are_marked_with_their_likely_reason_and_stay_in_the_list() {
    let honest = [9.79, 9.83, 9.81, 9.76, 9.84, 9.80];
    let cases = [
        (981.0, Some(Reason::Unit)),
        (0.98, Some(Reason::Unit)),
        (19.6, Some(Reason::Double)),
        (4.9, Some(Reason::Double)),
        (61.6, Some(Reason::Angular)),
        (-9.8, Some(Reason::Sign)),
        (13.1, None),
    ];
    for (value, reason) in cases {
        let values: Vec<f64> = honest.iter().copied().chain([value]).collect();
        let found = pool(&measured(&values, &[0.03; 7])).unwrap();
        assert_eq!(
            (found.outliers.len(), found.outliers[0].index, found.outliers[0].reason),
            (1, 6, reason),
            "{value}"
        );
        let without = found.without.unwrap();
        assert_eq!((found.all.count, without.count), (7, 6));
        assert!((without.value - 9.805).abs() < 0.01, "{without:?}");
        let said = without.scatter_text(Language::English, |value| format!("{value:.2} m/s²"));
        assert!(said.starts_with("The groups agree within their errors."), "{said}");
        let said = found.all.scatter_text(Language::Spanish, |value| format!("{value:.2} m/s²"));
        assert!(said.starts_with("Los grupos difieren"), "{said}");
    }
}

#[test]
fn results_that_cannot_be_pooled_are_refused_with_the_reason() {
    let cases: [(&[f64], &[f64], &str); 9] = [
        (&[], &[], "two groups at least"),
        (&[1.0], &[1.0], "two groups at least"),
        (&[1.0, f64::NAN], &[1.0, 1.0], "result 2 is not a number"),
        (&[1.0, 2.0], &[0.0, 1.0], "result 1 has no standard error"),
        (&[1.0, 2.0], &[1.0, -1.0], "result 2 has no standard error"),
        (&[1.0, 2.0], &[f64::INFINITY, 1.0], "result 1 has no standard error"),
        (&[1.0, 2.0], &[1.0, 1e-170], "result 2 or its error is too large or too small"),
        (&[1e200, 2.0], &[1.0, 1.0], "result 1 or its error is too large or too small"),
        (&[1.0, 1e60], &[1.0, 1.0], "result 2 or its error is too large or too small"),
    ];
    for (values, errors, expected) in cases {
        let refused = pool(&measured(values, errors)).unwrap_err();
        assert!(refused.english.contains(expected), "{refused:?}");
    }
}

/// Equal results, and results many orders of magnitude apart.
#[test]
fn extreme_results_give_finite_numbers() {
    for values in [vec![2.0_f64; 5], vec![1e-12, 1e12, 3.0, -1e9], vec![1e-99, 9e99], vec![0.0, 0.0]] {
        let errors: Vec<f64> = values.iter().map(|value| value.abs().max(1e-99)).collect();
        let found = pool(&measured(&values, &errors)).unwrap().all;
        assert!(numbers(&found).iter().all(|number| number.is_finite()), "{values:?}: {found:?}");
    }
}
