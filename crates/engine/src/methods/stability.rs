//! Stability check of fixed-step methods.
//!
//! A fixed-step method with step h is stable for y' = λy only if hλ lies in its region of stability (Hairer & Wanner,
//! Solving Ordinary Differential Equations II, 2nd ed., section IV.2). Outside, decaying solutions grow from step to step.
//! The greatest |λ| of the linearized equations is estimated by power iteration with finite differences of the rates.

use super::equations::Equations;
use crate::Method;

/// Number of rows between two checks.
const ROWS: u32 = 256;
/// Number of rows until a suspicion is checked again: a collision shorter than a step is over by then.
const ROWS_TO_CONFIRM: u32 = 16;
/// Iterations that align the direction with the greatest |λ|.
const TURNS: u32 = 6;
/// Iterations over which |λ| is averaged: an even number, after which the direction of an oscillation repeats.
const AVERAGED: u32 = 16;
/// Perturbation for finite differences, relative to the size of the states: small enough for linearity, far above rounding.
const SHIFT: f64 = 1e-9;

/// Stability check of a run, made at regular intervals.
#[derive(Clone, Debug)]
pub(crate) struct Stability {
    /// Upper bound of h|λ| for stability.
    limit: f64,
    /// Number of rows until the next check.
    left: u32,
    /// Time from which on the step seems too long, until a second check confirms it; SI units.
    suspected: Option<f64>,
    /// Time from which on the step is too long, SI units.
    exceeded: Option<f64>,
    /// Direction of the perturbation; kept from check to check, which improves the estimate.
    direction: Vec<f64>,
    moved: Vec<f64>,
    sizes: Vec<f64>,
    rates: [Vec<f64>; 2],
}

impl Stability {
    /// The check for a method and `states` states; `None` for an adaptive method, which its error control keeps stable.
    pub fn new(method: Method, states: usize) -> Option<Self> {
        let zeros = || vec![0.0; states];
        Some(Self {
            limit: limit(method).filter(|_| states > 0)?,
            left: 0,
            suspected: None,
            exceeded: None,
            direction: zeros(),
            moved: zeros(),
            sizes: zeros(),
            rates: [zeros(), zeros()],
        })
    }

    /// Schedules a check of the next row, after a change of the parameters.
    pub fn look_soon(&mut self) {
        self.left = 0;
    }

    /// Checks a row on the grid if a check is due; `step` and `time` in SI units.
    pub fn look(&mut self, equations: &mut Equations, time: f64, step: f64, state: &[f64]) {
        if self.exceeded.is_some() {
            return;
        }
        if self.left > 0 {
            self.left -= 1;
            return;
        }
        // The evaluations of this check are not counted.
        let evaluations = equations.evaluations;
        let greatest = self.greatest_rate(equations, time, step, state);
        equations.evaluations = evaluations;
        let (too_long, before) = (step * greatest > self.limit, self.suspected);
        self.suspected = too_long.then(|| before.unwrap_or(time));
        self.exceeded = self.suspected.filter(|_| before.is_some());
        self.left = if too_long { ROWS_TO_CONFIRM } else { ROWS } - 1;
    }

    /// Estimate of the greatest |λ|, in 1 / SI unit of time; 0 if the estimate fails.
    fn greatest_rate(&mut self, equations: &mut Equations, time: f64, step: f64, state: &[f64]) -> f64 {
        let [here, there] = &mut self.rates;
        equations.rates(time, state, here);
        for (size, (value, rate)) in self.sizes.iter_mut().zip(state.iter().zip(&*here)) {
            *size = value.abs() + step * rate.abs();
        }
        // States that are 0 and stay 0 have no size of their own.
        let any = self.sizes.iter().fold(0.0_f64, |most, size| most.max(*size));
        let least = if any > 0.0 { 1e-9 * any } else { 1.0 };
        for (k, (direction, size)) in self.direction.iter_mut().zip(&mut self.sizes).enumerate() {
            if *size == 0.0 {
                *size = least;
            }
            if *direction == 0.0 {
                // Unequal components: not orthogonal to any eigenvector of a chain.
                *direction = *size * (1.0 + 0.1 * (k % 7) as f64);
            }
        }
        let mut growth = 0.0;
        for turn in 0..TURNS + AVERAGED {
            let length = length(&self.direction, &self.sizes);
            if !(length > 0.0 && length.is_finite()) {
                self.direction.fill(0.0);
                return 0.0;
            }
            if turn > TURNS {
                growth += libm::log(length);
            }
            for (direction, (moved, value)) in self.direction.iter_mut().zip(self.moved.iter_mut().zip(state)) {
                *direction /= length;
                *moved = value + SHIFT * *direction;
            }
            equations.rates(time, &self.moved, there);
            for (direction, (there, here)) in self.direction.iter_mut().zip(there.iter().zip(&*here)) {
                *direction = (there - here) / SHIFT;
            }
        }
        growth += libm::log(length(&self.direction, &self.sizes));
        let greatest = libm::exp(growth / f64::from(AVERAGED));
        if greatest.is_finite() { greatest } else { 0.0 }
    }

    /// Time from which on the step is too long, SI units; `None` if it is not.
    pub fn exceeded(&self) -> Option<f64> {
        self.exceeded
    }

    /// Drops a finding after `time`.
    pub fn go_back_to(&mut self, time: f64) {
        self.exceeded = self.exceeded.filter(|exceeded| *exceeded <= time);
        self.suspected = self.exceeded;
        self.left = 0;
    }
}

/// Norm of a direction, each component relative to the size of its state.
fn length(direction: &[f64], sizes: &[f64]) -> f64 {
    let sum = direction.iter().zip(sizes).fold(0.0, |sum, (part, size)| sum + (part / size) * (part / size));
    sum.sqrt()
}

/// Upper bound of h|λ|: the end of the region of stability on the negative real axis. For these methods it is not beyond
/// that on the imaginary axis where that is stable at all, so a greater h|λ| is unstable for both decay and oscillation.
fn limit(method: Method) -> Option<f64> {
    match method {
        Method::Euler | Method::EulerRichardson | Method::VelocityVerlet => Some(2.0),
        // Root of |1 + z + z²/2 + z³/6 + z⁴/24| = 1.
        Method::RungeKutta4 => Some(2.785_293_563_405_282),
        Method::DormandPrince | Method::Rosenbrock => None,
    }
}
