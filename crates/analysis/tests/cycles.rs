//! Cycle by cycle: the truth lies within the stated errors as often as it should.

#![allow(clippy::expect_used, clippy::panic, reason = "a test that cannot go on has failed")]

mod support;

use analysis::cycles::{Cycle, Measured, cycles};
use support::{Noise, utube};

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

/// Frequency that grows by a tenth and damping that doubles: what a table of cycles is for.
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
    assert_eq!(cycles(&times, &line).map(|found| found.cycles.len()), None);
    assert_eq!(cycles(&times, &[1.0; 100]), None);
    assert_eq!(cycles(&[], &[]), None);
}

#[test]
fn a_measured_record_shows_its_cycles() {
    let Some(table) = utube("U3") else { return };
    let found = cycles(&table[0], &table[1]).expect("it oscillates");
    for cycle in found.cycles.iter().filter(|cycle| cycle.time.value < 5.0) {
        let frequency = cycle.angular_frequency;
        assert!((frequency.value - 9.61).abs() < 0.35 && frequency.error < 0.3, "{cycle:?}");
    }
    assert!(found.cycles.len() > 15);
}
