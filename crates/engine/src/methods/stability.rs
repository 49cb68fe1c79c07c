//! Whether the step of a fixed-step method is short enough for it to be stable.
//!
//! A method of fixed step h follows y' = λy only while hλ lies in its region of stability (Hairer & Wanner, Solving Ordinary
//! Differential Equations II, 2nd ed., section IV.2). Beyond, what should decay grows from step to step. The greatest |λ| of
//! the linearized equations is estimated by power iteration with differences of the rates of change.

use super::equations::Equations;
use crate::Method;

/// How many rows lie between two looks.
const ROWS: u32 = 256;
/// After how many rows one that was too long is looked at again: a collision of less than a step is over by then.
const ROWS_TO_CONFIRM: u32 = 16;
/// Iterations that turn the direction into that of the greatest |λ|.
const TURNS: u32 = 6;
/// Iterations over which |λ| is averaged: an even number, after which an oscillation points in its own direction again.
const AVERAGED: u32 = 16;
/// How far the states are moved, relative to their size: so little that the equations are linear there, and far more than rounding.
const SHIFT: f64 = 1e-9;

/// Looks at the equations now and then.
#[derive(Clone, Debug)]
pub(crate) struct Stability {
    /// The greatest h|λ|.
    limit: f64,
    /// How many rows there are until the next look.
    left: u32,
    /// From when on the step seems too long, until another look confirms it.
    suspected: Option<f64>,
    /// From when on the step has been too long.
    exceeded: Option<f64>,
    /// The direction in which the states are moved; kept from look to look, so that it becomes more exact.
    direction: Vec<f64>,
    moved: Vec<f64>,
    sizes: Vec<f64>,
    rates: [Vec<f64>; 2],
}

impl Stability {
    /// For a method and so many states; none for an adaptive method, whose control of errors sees to it.
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

    /// Has the next row looked at, since the parameters are others.
    pub fn look_soon(&mut self) {
        self.left = 0;
    }

    /// Looks at a row on the grid, if it is time.
    pub fn look(&mut self, equations: &mut Equations, time: f64, step: f64, state: &[f64]) {
        if self.exceeded.is_some() {
            return;
        }
        if self.left > 0 {
            self.left -= 1;
            return;
        }
        // These belong to no step.
        let evaluations = equations.evaluations;
        let greatest = self.greatest_rate(equations, time, step, state);
        equations.evaluations = evaluations;
        let (too_long, before) = (step * greatest > self.limit, self.suspected);
        self.suspected = too_long.then(|| before.unwrap_or(time));
        self.exceeded = self.suspected.filter(|_| before.is_some());
        self.left = if too_long { ROWS_TO_CONFIRM } else { ROWS } - 1;
    }

    /// The greatest |λ|, 1 / unit of time; 0 where it cannot be told.
    fn greatest_rate(&mut self, equations: &mut Equations, time: f64, step: f64, state: &[f64]) -> f64 {
        let [here, there] = &mut self.rates;
        equations.rates(time, state, here);
        for (size, (value, rate)) in self.sizes.iter_mut().zip(state.iter().zip(&*here)) {
            *size = value.abs() + step * rate.abs();
        }
        // What is 0 and stays there has no size of its own.
        let any = self.sizes.iter().fold(0.0_f64, |most, size| most.max(*size));
        let least = if any > 0.0 { 1e-9 * any } else { 1.0 };
        for (k, (direction, size)) in self.direction.iter_mut().zip(&mut self.sizes).enumerate() {
            if *size == 0.0 {
                *size = least;
            }
            if *direction == 0.0 {
                // Unequal parts: none of a chain's eigenvectors is orthogonal to them.
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

    /// From when on the step has been too long.
    pub fn exceeded(&self) -> Option<f64> {
        self.exceeded
    }

    /// Forgets what was found after `time`.
    pub fn go_back_to(&mut self, time: f64) {
        self.exceeded = self.exceeded.filter(|exceeded| *exceeded <= time);
        self.suspected = self.exceeded;
        self.left = 0;
    }
}

/// The length of a direction in which each state is measured by its size.
fn length(direction: &[f64], sizes: &[f64]) -> f64 {
    let sum = direction.iter().zip(sizes).fold(0.0, |sum, (part, size)| sum + (part / size) * (part / size));
    sum.sqrt()
}

/// How far the region of stability reaches along the negative real axis, which for these methods is no farther than along the
/// imaginary one where that is stable at all: h|λ| beyond it is unstable for what decays and for what oscillates.
fn limit(method: Method) -> Option<f64> {
    match method {
        Method::Euler | Method::EulerRichardson | Method::VelocityVerlet => Some(2.0),
        // The root of |1 + z + z²/2 + z³/6 + z⁴/24| = 1.
        Method::RungeKutta4 => Some(2.785_293_563_405_282),
        Method::DormandPrince | Method::Rosenbrock => None,
    }
}
