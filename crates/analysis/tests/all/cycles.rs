//! Cycles: coverage of the stated errors.

use crate::support::{Noise, utube};
use analysis::cycles::{Cycle, Measured, NoCycles, cycles};
use units::Language;

const W: f64 = 9.6;
const G: f64 = 0.39;
const A: f64 = 0.056;

fn truth(time: f64) -> f64 {
    A * libm::exp(-G * time) * libm::cos(W * time + 0.7) - 3e-3
}

#[test]
fn the_truth_lies_within_the_stated_errors_two_times_in_three() {
    let mut random = Noise::new(3);
    let times: Vec<f64> =
        (0..150).map(|frame| f64::from(frame) / 30.0).filter(|time| !(1.0..1.2).contains(time)).collect();
    let mut within = [0; 6];
    let mut count = 0;
    for _ in 0..400 {
        let values: Vec<f64> = times.iter().map(|time| truth(*time) + 3e-4 * random.normal()).collect();
        let found = cycles(&times, &values).expect("it oscillates");
        // Rows three apart are independent of each other.
        for cycle in found.cycles.iter().step_by(3) {
            count += 1;
            let period = core::f64::consts::TAU / W;
            let turning = W * cycle.time.value + 0.7 + libm::atan2(G, W);
            let time =
                cycle.time.value - (turning - (turning / core::f64::consts::PI).round() * core::f64::consts::PI) / W;
            let expected = [time, A * libm::exp(-G * cycle.time.value), period, G * period, W, G];
            let measured =
                [cycle.time, cycle.amplitude, cycle.period, cycle.decrement, cycle.angular_frequency, cycle.damping];
            for (number, (truth, found)) in within.iter_mut().zip(expected.iter().zip(measured)) {
                *number += usize::from((found.value - truth).abs() <= found.error);
            }
        }
    }
    for (name, within) in ["time", "amplitude", "period", "decrement", "frequency", "damping"].iter().zip(within) {
        let share = within as f64 / f64::from(count);
        assert!((0.63..0.73).contains(&share), "{name}: {share} of {count}");
    }
}

#[test]
fn without_noise_the_numbers_are_exact() {
    let times: Vec<f64> = (0..200).map(|frame| f64::from(frame) / 30.0).collect();
    let values: Vec<f64> = times.iter().map(|time| truth(*time)).collect();
    let found = cycles(&times, &values).expect("it oscillates");
    assert_eq!(found.cycles.len(), 18);
    assert_eq!(found.lost, None);
    let close = |measured: Measured, truth: f64| (measured.value / truth - 1.0).abs() < 1e-7;
    for (index, cycle) in found.cycles.iter().enumerate() {
        assert!(
            close(cycle.angular_frequency, W) && close(cycle.damping, G) && close(cycle.offset, -3e-3),
            "{cycle:?}"
        );
        assert!(close(cycle.amplitude, A * libm::exp(-G * cycle.time.value)), "{cycle:?}");
        assert_eq!(cycle.maximum, index % 2 == 0);
    }
}

/// Frequency that grows by a tenth and damping that doubles.
#[test]
fn strong_damping_is_right_however_dense_the_rows_are() {
    let mut counted = 0;
    for damping in [0.05, 0.25, 0.5, 1.0, 1.4] {
        for step in [0.01, 0.02, 0.03, 0.05] {
            for (unit, level, phase) in [(1e-3, 0.0, 0.0), (1e-9, 0.0, 0.0), (1e-3, 3.0, 1.0), (1e-9, -2.0, 2.5)] {
                let times: Vec<f64> = (0..(4.0 / step) as u32).map(|row| step * f64::from(row)).collect();
                let value = |t: &f64| level + 5.0 * libm::exp(-damping * t) * libm::cos(8.0 * t + phase);
                let values: Vec<f64> = times.iter().map(value).map(|value| (value / unit).round() * unit).collect();
                let found = cycles(&times, &values).expect("an oscillation");
                for cycle in &found.cycles {
                    let off = (cycle.decrement.value - damping * core::f64::consts::TAU / 8.0).abs();
                    let case = format!("{damping} {step} {unit} {level} {phase}: {cycle:?}");
                    assert!(off < 5.0 * cycle.decrement.error + 1e-4, "{case}");
                    let level_off = (cycle.offset.value - level).abs();
                    assert!(level_off < 5.0 * cycle.offset.error + 1e-3 * cycle.amplitude.value, "{case}");
                    counted += 1;
                }
            }
        }
    }
    assert!(counted > 400, "{counted}");
}

#[test]
fn a_change_during_the_record_is_seen() {
    let times: Vec<f64> = (0..400).map(|frame| f64::from(frame) / 30.0).collect();
    let phase = |t: f64| 9.0 * t + 0.5 * 0.9 / 13.3 * t * t;
    let values: Vec<f64> =
        times.iter().map(|t| libm::exp(-0.1 * t - 0.5 * 0.1 / 13.3 * t * t) * libm::cos(phase(*t))).collect();
    let found = cycles(&times, &values).expect("it oscillates").cycles;
    assert!(found.len() > 35, "{}", found.len());
    let local = |cycle: &Cycle| (9.0 + 0.9 / 13.3 * cycle.time.value, 0.1 + 0.1 / 13.3 * cycle.time.value);
    for cycle in &found[1..found.len() - 1] {
        let (frequency, damping) = local(cycle);
        assert!((cycle.angular_frequency.value - frequency).abs() < 0.01, "{cycle:?} {frequency}");
        assert!((cycle.damping.value - damping).abs() < 0.02, "{cycle:?} {damping}");
    }
}

#[test]
fn it_says_where_noise_hides_the_oscillation() {
    let mut random = Noise::new(5);
    let times: Vec<f64> = (0..900).map(|frame| f64::from(frame) / 30.0).collect();
    let values: Vec<f64> = times.iter().map(|time| truth(*time) + 3e-4 * random.normal()).collect();
    let found = cycles(&times, &values).expect("it oscillates");
    let last = found.cycles.last().expect("a cycle").time.value;
    let lost = found.lost.expect("noise wins");
    assert!((9.0..17.0).contains(&last) && lost > last && lost < last + 1.0, "{last} {lost}");
}

#[test]
fn no_oscillation_has_no_cycles() {
    let times: Vec<f64> = (0..100).map(f64::from).collect();
    let line: Vec<f64> = times.iter().map(|time| 2.0 * time).collect();
    assert_eq!(cycles(&times, &line).map(|found| found.cycles.len()), Err(NoCycles::Unclear));
    assert_eq!(cycles(&times, &[1.0; 100]), Err(NoCycles::Unclear));
    assert_eq!(cycles(&[], &[]), Err(NoCycles::Unclear));
}

#[test]
#[ignore = "needs the measured records in ../shared/data/utube"]
fn a_measured_record_shows_its_cycles() {
    let table = utube("U3");
    let found = cycles(&table[0], &table[1]).expect("it oscillates");
    for cycle in found.cycles.iter().filter(|cycle| cycle.time.value < 5.0) {
        let frequency = cycle.angular_frequency;
        assert!((frequency.value - 9.61).abs() < 0.35 && frequency.error < 0.3, "{cycle:?}");
    }
    assert!(found.cycles.len() > 15);
}

/// Values at 30 rows a second of a solution of x'' = f(x, x'), by small steps of the classical Runge-Kutta method.
fn solution(start: (f64, f64), rows: u32, acceleration: impl Fn(f64, f64) -> f64) -> (Vec<f64>, Vec<f64>) {
    let (mut x, mut v) = start;
    let (mut times, mut values) = (Vec::new(), Vec::new());
    let steps = 40;
    let h = 1.0 / 30.0 / f64::from(steps);
    for row in 0..rows {
        times.push(f64::from(row) / 30.0);
        values.push(x);
        for _ in 0..steps {
            let (a1, b1) = (v, acceleration(x, v));
            let (a2, b2) = (v + h / 2.0 * b1, acceleration(x + h / 2.0 * a1, v + h / 2.0 * b1));
            let (a3, b3) = (v + h / 2.0 * b2, acceleration(x + h / 2.0 * a2, v + h / 2.0 * b2));
            let (a4, b4) = (v + h * b3, acceleration(x + h * a3, v + h * b3));
            x += h / 6.0 * (a1 + 2.0 * a2 + 2.0 * a3 + a4);
            v += h / 6.0 * (b1 + 2.0 * b2 + 2.0 * b3 + b4);
        }
    }
    (times, values)
}

/// The period of a pendulum of 1 m, by the arithmetic-geometric mean.
fn pendulum_period(degrees: f64) -> f64 {
    let (mut a, mut b) = (1.0, libm::cos(degrees.to_radians() / 2.0));
    for _ in 0..20 {
        (a, b) = ((a + b) / 2.0, (a * b).sqrt());
    }
    core::f64::consts::TAU / 9.81_f64.sqrt() / a
}

/// The mean period of independent cycles, with its error.
fn period(cycles: &[Cycle]) -> Measured {
    let independent: Vec<Measured> = cycles.iter().step_by(3).map(|cycle| cycle.period).collect();
    let count = independent.len() as f64;
    let squares: f64 = independent.iter().map(|one| one.error * one.error).sum();
    Measured { value: independent.iter().map(|one| one.value).sum::<f64>() / count, error: squares.sqrt() / count }
}

#[test]
fn the_period_of_a_pendulum_is_right_however_far_it_swings() {
    assert!((pendulum_period(120.0) - 2.7541).abs() < 1e-3);
    let mut random = Noise::new(12);
    for degrees in [30.0, 90.0, 120.0, 170.0] {
        let truth = pendulum_period(degrees);
        let start = f64::to_radians(degrees);
        let (times, clean) = solution((start, 0.0), 600, |x, _| -9.81 * libm::sin(x));
        let found = cycles(&times, &clean).expect("it oscillates");
        assert!(!found.sinusoidal && found.cycles.len() > 4, "{degrees}: {}", found.cycles.len());
        for cycle in &found.cycles {
            let (off, error) = (cycle.period.value - truth, cycle.period.error);
            assert!(off.abs() <= 3.0 * error + 1e-7 && error < 1e-3, "{degrees}: {:?} {truth}", cycle.period);
            assert!((cycle.amplitude.value / start - 1.0).abs() < 1e-3, "{degrees}: {:?}", cycle.amplitude);
            assert!(
                cycle.decrement.value.abs() < 3.0 * cycle.decrement.error + 1e-4,
                "{degrees}: {:?}",
                cycle.decrement
            );
        }
        // With camera noise, the result does not depend on the method.
        let (mut inside, mut all) = (0, 0);
        for _ in 0..30 {
            let values: Vec<f64> = clean.iter().map(|value| value + 0.01 * start * random.normal()).collect();
            let found = cycles(&times, &values).expect("it oscillates");
            let mean = period(&found.cycles);
            inside += i32::from((mean.value - truth).abs() <= 2.0 * mean.error);
            all += 1;
        }
        assert!(inside * 100 >= all * 70, "{degrees}: {inside} of {all}");
    }
}

#[test]
fn the_period_of_any_shape_is_right() {
    // A relaxation oscillation (van der Pol's with mu = 5) and its period between crossings at small steps.
    let van_der_pol = |x: f64, v: f64| 5.0 * (1.0 - x * x) * v - x;
    let (times, values) = solution((2.0, 0.0), 3_000, van_der_pol);
    let found = cycles(&times, &values).expect("it oscillates");
    // B. van der Pol's oscillator at mu = 5 has the period 11.612 (M. Urabe, IRE Trans. CT-7 (1960) 382).
    let measured = period(&found.cycles);
    assert!(!found.sinusoidal && (measured.value - 11.612).abs() < 3.0 * measured.error + 1e-3, "{measured:?}");
    assert!(measured.error < 0.02, "{measured:?}");
    // A triangle, and a saw that rises slowly and falls quickly.
    for rise in [0.5, 0.8] {
        let triangle = |t: f64| {
            let phase = (t / 1.7).fract();
            if phase < rise { 2.0 * phase / rise - 1.0 } else { 1.0 - 2.0 * (phase - rise) / (1.0 - rise) }
        };
        let times: Vec<f64> = (0..600).map(|row| f64::from(row) / 30.0).collect();
        let values: Vec<f64> = times.iter().map(|time| triangle(*time)).collect();
        let found = cycles(&times, &values).expect("it oscillates");
        let measured = period(&found.cycles);
        assert!((measured.value - 1.7).abs() < 3.0 * measured.error + 1e-6, "{rise}: {measured:?}");
        assert!(measured.error < 5e-3, "{rise}: {measured:?}");
    }
}

#[test]
fn words_say_a_change_only_where_there_is_one() {
    use analysis::cycles::{Constancy, Quantity};
    let times: Vec<f64> = (0..200).map(|frame| f64::from(frame) / 30.0).collect();
    let values: Vec<f64> = times.iter().map(|time| truth(*time)).collect();
    let found = cycles(&times, &values).expect("it oscillates").cycles;
    let with = |periods: &[f64], error: f64| -> Vec<Cycle> {
        // Every third row is independent.
        let rows = periods.iter().flat_map(|value| [*value; 3]);
        rows.zip(found.iter().cycle())
            .map(|(value, cycle)| Cycle { period: Measured { value, error }, ..*cycle })
            .collect()
    };
    let said = |periods: &[f64], error: f64, digits: usize| {
        let written = |one: Measured| format!("{:.digits$} s", one.value);
        let constancy = Constancy::of(&with(periods, error), Quantity::Period).expect("errors are known");
        [Language::English, catalogues::with(Language::Spanish)]
            .map(|language| constancy.text(Quantity::Period, language, &written, &|value| format!("{value:.1}")))
    };
    let [english, spanish] = said(&[1.0, 1.01], 0.01, 2);
    assert!(english.ends_with("(chi-square 0.5 for 1 degree of freedom)."), "{english}");
    assert!(spanish.ends_with("(ji cuadrado 0.5 con 1 grado de libertad)."), "{spanish}");
    let [english, spanish] = said(&[1.0, 1.1, 0.9, 1.0, 0.9, 1.1, 1.0, 1.1, 0.9], 0.01, 2);
    assert!(english.contains("without a trend: 1.00 s on average"), "{english}");
    assert!(spanish.contains("sin tendencia: 1.00 s en promedio"), "{spanish}");
    let [english, _] = said(&[0.4912, 0.4911, 0.4909, 0.4907, 0.4906, 0.4905], 1e-5, 3);
    assert!(english.contains("0.491 s throughout") && !english.contains("first third"), "{english}");
    let [english, spanish] = said(&[0.4912, 0.4911, 0.4909, 0.4907, 0.4906, 0.4905], 1e-5, 4);
    assert!(english.contains("0.4911 s in the first third of the cycles, 0.4905 s in the last"), "{english}");
    assert!(spanish.contains("0.4911 s en el primer tercio de los ciclos, 0.4905 s en el último"), "{spanish}");
}

/// Damped cosine of the period 0.65 s in white noise that hides it before the end of the record: rows per second, seconds,
/// and noise. The method remains that of sinusoids, and the table ends where the oscillation is hidden.
#[test]
fn a_tail_of_noise_changes_nothing() {
    use analysis::cycles::{Constancy, Quantity};
    let (truth, damping) = (0.65, 0.3);
    let swing = |t: f64| 50.0 * libm::exp(-damping * t) * libm::cos(core::f64::consts::TAU * t / truth);
    for (rate, duration, noise, records) in [(100, 60, 0.5, 50), (5_000, 20, 0.5, 1), (10_000, 20, 1.0, 1)] {
        let (mut random, mut sinusoidal, mut same) = (Noise::new(8), 0, 0);
        for _ in 0..records {
            let times: Vec<f64> = (0..rate * duration).map(|row| f64::from(row) / f64::from(rate)).collect();
            let values: Vec<f64> = times.iter().map(|time| swing(*time) + noise * random.normal()).collect();
            let found = cycles(&times, &values).expect("it oscillates");
            let last = found.cycles.last().expect("a cycle").time.value;
            // Time at which the amplitude is a tenth of the noise.
            let hidden = libm::log(50.0 / (0.1 * noise)) / damping;
            assert!(found.cycles.len() >= 30 && last < hidden, "{rate}: {} until {last}", found.cycles.len());
            assert!(found.lost.is_some_and(|lost| lost > last) || duration == 20, "{rate}: {:?}", found.lost);
            assert!(found.cycles.is_sorted_by(|one, other| one.time.value < other.time.value), "{rate}");
            let measured = period(&found.cycles[..15]);
            assert!((measured.value - truth).abs() < 4.0 * measured.error, "{rate}: {measured:?}");
            let constancy = Constancy::of(&found.cycles, Quantity::AngularFrequency);
            sinusoidal += i32::from(found.sinusoidal);
            same += i32::from(matches!(constancy, Some(Constancy::Same { .. })));
        }
        println!("{rate} rows a second: sinusoidal {sinusoidal}, the same frequency {same} of {records}");
        assert!(sinusoidal * 100 >= 96 * records && same * 100 >= 88 * records, "{rate}: {sinusoidal} {same}");
    }
}

#[test]
fn noise_has_no_cycles() {
    let mut random = Noise::new(9);
    for count in [30, 100, 1_000, 6_000] {
        let times: Vec<f64> = (0..count).map(|row| f64::from(row) / 100.0).collect();
        // About a level, and about a slow drift.
        for drift in [0.0, 5.0] {
            let length = f64::from(count) / 100.0;
            let mut record = || times.iter().map(|t| drift * t / length + random.normal()).collect::<Vec<f64>>();
            let found = (0..20).filter(|_| cycles(&times, &record()).is_ok()).count();
            assert!(found <= 1, "{count} {drift}: {found}");
        }
    }
}
