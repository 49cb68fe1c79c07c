//! Cycles under drifts of first and second order, with friction of other orders, and with harmonics.

use crate::support::Noise;
use analysis::cycles::{Constancy, Cycles, Quantity, cycles};
use core::f64::consts::{PI, TAU};

const W: f64 = 9.6;

/// Share of cycles whose true value lies within one standard error, for period and damping, and number of records with a
/// change of damping.
#[derive(Debug, Default)]
struct Score {
    within: [u32; 2],
    cycles: u32,
    changes: u32,
    sinusoidal: u32,
}

impl Score {
    fn add(&mut self, found: &Cycles, damping: f64) {
        for cycle in found.cycles.iter().step_by(3) {
            self.cycles += 1;
            for (within, (truth, one)) in
                self.within.iter_mut().zip([(TAU / W, cycle.period), (damping, cycle.damping)])
            {
                *within += u32::from((one.value - truth).abs() <= one.error);
            }
        }
        self.changes += u32::from(changes(found));
        self.sinusoidal += u32::from(found.sinusoidal);
    }

    fn shares(&self) -> [f64; 2] {
        self.within.map(|within| 100.0 * f64::from(within) / f64::from(self.cycles.max(1)))
    }
}

fn changes(found: &Cycles) -> bool {
    matches!(Constancy::of(&found.cycles, Quantity::Damping), Some(Constancy::Changes { .. }))
}

fn scored(records: u32, frames: u32, damping: f64, noise: f64, level: [f64; 2], harmonics: [f64; 2]) -> Score {
    let (mut random, mut score) = (Noise::new(17), Score::default());
    for _ in 0..records {
        let phase = 2.0 * PI * random.uniform();
        let turn = 2.0 * PI * random.uniform();
        let value = |t: f64| {
            let angle = W * t + phase;
            let x = t / f64::from(frames) * 30.0;
            libm::exp(-damping * t)
                * (libm::cos(angle)
                    + harmonics[0] * libm::cos(2.0 * angle + turn)
                    + harmonics[1] * libm::cos(3.0 * angle + turn))
                + level[0] * x
                + level[1] * x * x
        };
        let times: Vec<f64> = (0..frames).map(|frame| f64::from(frame) / 30.0).collect();
        let values: Vec<f64> = times.iter().map(|t| value(*t) + noise * random.normal()).collect();
        score.add(&cycles(&times, &values).unwrap_or_else(|no| panic!("{no:?} {frames} {damping} {level:?}")), damping);
    }
    score
}

/// Levels at the end of the record by their linear and their quadratic part, in amplitudes.
const LEVELS: [[f64; 2]; 7] = [[0.0, 0.0], [-1.0, 0.0], [0.0, 0.5], [0.0, -1.0], [0.4, -0.8], [-1.0, 1.0], [0.0, 2.0]];
/// Friction: linear, dry and quadratic.
const FRICTIONS: [[f64; 3]; 4] = [[0.0, 2.0, 0.0], [0.0, 0.0, 0.3], [0.1, 1.0, 0.0], [0.1, 0.0, 0.2]];

/// Number of records of this friction about a level in which a change of damping is claimed.
fn claimed(records: u32, [linear, dry, quadratic]: [f64; 3], level: [f64; 2], noise: f64) -> u32 {
    let mut random = Noise::new(5);
    let (times, clean) = with_friction(240, linear, dry, quadratic);
    let claims = |_| {
        let value = |(t, value): (&f64, &f64)| {
            let x = t / 8.0;
            value + level[0] * x + level[1] * x * x + noise * random.normal()
        };
        let values: Vec<f64> = times.iter().zip(&clean).map(value).collect();
        u32::from(changes(&cycles(&times, &values).expect("it oscillates")))
    };
    (0..records).map(claims).sum()
}

#[test]
fn a_drift_is_no_change_of_damping() {
    let mut all = 0;
    for level in LEVELS {
        let score = scored(6, 240, 0.39, 0.01, level, [0.0; 2]);
        assert!(score.changes <= 1 && score.shares().iter().all(|share| *share > 50.0), "{level:?}: {score:?}");
        all += score.changes;
    }
    assert!(all <= 2, "{all} of {}", 6 * LEVELS.len());
}

#[test]
fn a_change_of_damping_is_found_about_a_drift() {
    for friction in FRICTIONS {
        for level in [[0.0, 0.0], [0.0, -0.5]] {
            assert_eq!(claimed(3, friction, level, 0.006), 3, "{friction:?} {level:?}");
        }
    }
}

/// A third harmonic is no noise: the errors are those of the noise.
#[test]
fn harmonics_do_not_widen_the_intervals() {
    for (harmonics, noise) in [([0.0, 0.03], 0.02), ([0.0, 0.01], 0.006)] {
        let score = scored(10, 240, 0.2, noise, [0.0; 2], harmonics);
        assert!(score.shares().iter().all(|share| (55.0..88.0).contains(share)), "{harmonics:?}: {score:?}");
    }
}

/// Prints the scores of many records.
#[test]
#[ignore = "takes a minute"]
fn many_records_with_drifts_and_harmonics() {
    for frames in [200, 240, 300] {
        for (damping, noise) in [(0.3, 0.006), (0.39, 0.01), (0.15, 0.02), (0.2, 0.003)] {
            for level in LEVELS {
                let score = scored(20, frames, damping, noise, level, [0.0; 2]);
                let [period, of_damping] = score.shares();
                println!(
                    "{frames} frames, {damping}, noise {noise}, level {level:?}: {period:.0} %, {of_damping:.0} %, changes {}",
                    score.changes
                );
            }
        }
    }
    for harmonics in [[0.0, 0.0], [0.0, 0.01], [0.0, 0.03], [0.0, 0.1], [0.03, 0.0], [0.1, 0.0], [0.05, 0.05]] {
        for noise in [0.002, 0.006, 0.02] {
            let score = scored(20, 240, 0.2, noise, [0.0; 2], harmonics);
            let [period, of_damping] = score.shares();
            println!("harmonics {harmonics:?}, noise {noise}: {period:.0} %, {of_damping:.0} %, {score:?}");
        }
    }
    for friction in FRICTIONS {
        for level in LEVELS {
            println!("friction {friction:?}, level {level:?}: changes {} of 20", claimed(20, friction, level, 0.006));
        }
    }
}

/// Solution of y'' + 2 linear y' + dry sign(y') + quadratic |y'| y' + W^2 y = 0 from 1, at 30 rows a second.
fn with_friction(rows: u32, linear: f64, dry: f64, quadratic: f64) -> (Vec<f64>, Vec<f64>) {
    let force = |v: f64| -2.0 * linear * v - dry * v.signum() - quadratic * v.abs() * v;
    let (mut y, mut v) = (1.0, 0.0);
    let (mut times, mut values) = (Vec::new(), Vec::new());
    let h = 1.0 / 30.0 / 200.0;
    for row in 0..rows {
        times.push(f64::from(row) / 30.0);
        values.push(y);
        for _ in 0..200 {
            // Half a step of the velocity, a step of the position, half a step of the velocity.
            v += 0.5 * h * (force(v) - W * W * y);
            y += h * v;
            v += 0.5 * h * (force(v) - W * W * y);
        }
    }
    (times, values)
}
