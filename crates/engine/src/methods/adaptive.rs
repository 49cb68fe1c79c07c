//! Step size control of the methods with an error estimate.

mod ahead;
mod control;

use self::control::{growth, shrinkage};
use super::dormand_prince::{DormandPrince, dense_value};
use super::equations::Equations;
use super::last_step::LastStep;
use super::rosenbrock::Rosenbrock;
use crate::Setup;
use crate::events::crossing::Crossing;
use crate::events::surfaces::Surfaces;
use program::Model;

pub(crate) use ahead::Place;
pub use ahead::{dormand_prince_growth, dormand_prince_shrinkage};

/// An embedded pair of methods; the difference of both results estimates the error.
#[derive(Clone, Debug)]
pub(crate) enum Pair {
    DormandPrince(DormandPrince),
    Rosenbrock(Rosenbrock),
}

/// Settings of the step control.
#[derive(Clone, Debug, PartialEq)]
pub struct StepControl {
    /// Tolerance per step relative to the magnitude of each state.
    pub tolerance: f64,
    /// Lower bound of that magnitude, one value per state, SI units.
    pub floors: Vec<f64>,
    /// Lower bound of that magnitude as a fraction of the peak of the state.
    pub below_peak: f64,
    /// Upper bound of the step, SI units.
    pub longest: f64,
    /// Size proposed for the first step, SI units.
    pub first: f64,
    /// Error assumed for the step before the first one.
    pub first_error: f64,
}

/// Reason why no step was possible.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Stalled {
    /// The state is not finite even after the smallest step.
    NotFinite,
    /// The error is too large even for the smallest step.
    TooSmall,
}

/// An adaptive method, its last step and the continuous solution over that.
#[derive(Clone, Debug)]
pub(crate) struct Adaptive {
    pair: Pair,
    tolerance: f64,
    /// Lower bound of the magnitude to which the tolerance is relative, one value per state, SI units.
    floors: Vec<f64>,
    /// Lower bound of the same magnitude as a fraction of the peak of each state.
    below_peak: f64,
    /// Upper bound of the step, in SI units: a short pulse must not be skipped while the system rests.
    longest: f64,
    last: LastStep,
    attempt: Vec<f64>,
    error: Vec<f64>,
}

impl Adaptive {
    /// Maximum number of rows per step.
    const ROWS: f64 = 10.0;
    /// Default of [`Adaptive::below_peak`].
    const BELOW_PEAK: f64 = 1e-3;
    /// Magnitude, as a fraction of the display unit of a state, below which it counts as zero but for rounding. The author
    /// chose the unit, which indicates the size.
    const BELOW_UNIT: f64 = 1e-9;
    /// First step in rows; the controller finds the right size within a few attempts.
    const FIRST_STEP: f64 = 0.01;
    /// Error assumed for the step before the first one.
    const FIRST_ERROR: f64 = 1e-4;
    /// Steps shorter than this leave the state unchanged; the reciprocal of the step is still finite.
    const AT_ONCE: f64 = 1e-300;

    pub fn new(pair: Pair, model: &Model, setup: &Setup) -> Self {
        let zeros = vec![0.0; model.states.len()];
        Self {
            pair,
            tolerance: setup.tolerance,
            floors: model.states.iter().map(|state| Self::BELOW_UNIT * state.unit.factor.abs()).collect(),
            below_peak: Self::BELOW_PEAK,
            longest: Self::ROWS * setup.step,
            last: LastStep {
                start: 0.0,
                size: 0.0,
                end: 0.0,
                from: zeros.clone(),
                to: zeros.clone(),
                dense: std::array::from_fn(|_| zeros.clone()),
                proposed: Self::FIRST_STEP * setup.step,
                error: Self::FIRST_ERROR,
                peaks: zeros.clone(),
            },
            attempt: zeros.clone(),
            error: zeros,
        }
    }

    /// The settings of a run with rows `step` apart.
    pub fn control(&self, step: f64) -> StepControl {
        StepControl {
            tolerance: self.tolerance,
            floors: self.floors.clone(),
            below_peak: self.below_peak,
            longest: self.longest,
            first: Self::FIRST_STEP * step,
            first_error: Self::FIRST_ERROR,
        }
    }

    /// The last step.
    pub fn last(&self) -> &LastStep {
        &self.last
    }

    /// Resets the controller for a new run with rows `step` apart.
    pub fn renew(&mut self, step: f64) {
        self.last.proposed = Self::FIRST_STEP * step;
        self.last.error = Self::FIRST_ERROR;
        self.last.peaks.fill(0.0);
    }

    /// Sets the tolerance per step, relative to the peak of each state.
    pub fn allow_of_peak(&mut self, tolerance: f64) {
        self.tolerance = tolerance;
        self.below_peak = 1.0;
    }

    /// Restarts at `time` with `state`, after a jump of the state or the parameters.
    pub fn restart(&mut self, time: f64, state: &[f64]) {
        self.last.start = time;
        self.last.size = 0.0;
        self.last.end = time;
        self.last.from.copy_from_slice(state);
        self.last.to.copy_from_slice(state);
        self.note_peaks();
        self.forget();
    }

    /// Continues after a step that was the last one before.
    pub fn go_on_after(&mut self, step: &LastStep) {
        self.last.clone_from(step);
        // The rates at its end are recomputed from the same numbers.
        self.forget();
    }

    /// Approximate number of operations for the linear systems of the stiff method after `evaluations` of the equations:
    /// one factorization per step and one solution per stage.
    pub fn work_of_systems(&self, evaluations: u64) -> u64 {
        match &self.pair {
            Pair::DormandPrince(_) => 0,
            Pair::Rosenbrock(pair) => evaluations * pair.work_of_stage(),
        }
    }

    /// Start of the last step, SI units.
    pub fn start(&self) -> f64 {
        self.last.start
    }

    /// End of the last step, SI units.
    pub fn end(&self) -> f64 {
        self.last.end
    }

    /// State at the end of the last step: SI, one value per state.
    pub fn end_state(&self) -> &[f64] {
        &self.last.to
    }

    /// Makes the next step. Proportional-integral controller (Hairer & Wanner, Solving Ordinary Differential Equations II,
    /// section IV.2) with the constants of their code DOPRI5: safety factor 0.9, at most five times smaller or ten times
    /// larger, and not larger right after a rejection.
    ///
    /// The stiff method does not step over `row`: if a stiff component follows a forcing, as in the problem of Prothero and
    /// Robinson, its dense output is less accurate than its steps by orders of magnitude.
    pub fn extend(&mut self, equations: &mut Equations, row: f64) -> Result<(), Stalled> {
        if self.take_step(equations) {
            return Ok(());
        }
        let time = self.last.end;
        let order = match self.pair {
            Pair::DormandPrince(_) => 5.0,
            Pair::Rosenbrock(_) => 4.0,
        };
        let wanted = self.last.proposed.min(self.longest);
        let lands = matches!(self.pair, Pair::Rosenbrock(_)) && time + 1.001 * wanted >= row;
        let mut size = if lands { row - time } else { wanted };
        let mut rejected = false;
        loop {
            let smallest = 16.0 * f64::EPSILON * time.abs().max(f64::MIN_POSITIVE / f64::EPSILON);
            step(&mut self.pair, equations, time, size, &self.last.to, &mut self.attempt, &mut self.error);
            let error = self.error_norm();
            if error <= 1.0 {
                let growth = growth(order, self.last.error, error).clamp(0.2, if rejected { 1.0 } else { 10.0 });
                self.last.error = error.max(1e-4);
                let on_row = lands && !rejected;
                self.accept(equations, time, size, if on_row { row } else { time + size });
                // A step cut short to reach a row is no reason to reduce the proposed size.
                self.last.proposed = if on_row { wanted.max(size * growth) } else { size * growth };
                return Ok(());
            }
            if size <= smallest {
                let finite = self.attempt.iter().all(|value| value.is_finite());
                return Err(if finite { Stalled::TooSmall } else { Stalled::NotFinite });
            }
            let shrinkage = shrinkage(order, error);
            // The comparison also covers NaN.
            size *= if shrinkage > 0.2 { shrinkage } else { 0.2 };
            size = size.max(smallest);
            rejected = true;
        }
    }

    /// Continuous solution over the last step, `since_start` after its start (SI units): one value per state.
    pub fn dense(&self, since_start: f64, out: &mut [f64]) {
        dense_value(&self.last.dense, since_start / self.last.size, out);
    }

    /// State `since` after the start of the last step (SI units), computed by a shorter step from the same start. The next
    /// step must begin there.
    pub fn shorter(&mut self, equations: &mut Equations, since: f64, out: &mut [f64]) {
        self.forget();
        self.repeat(equations, since, out);
    }

    /// [`Adaptive::shorter`] without resetting the method, for repeated calls from the same start. The dense output replaces a
    /// step with a stage at which the equations have no value.
    fn repeat(&mut self, equations: &mut Equations, since: f64, out: &mut [f64]) {
        if since < Self::AT_ONCE {
            out.copy_from_slice(&self.last.from);
        } else {
            step(&mut self.pair, equations, self.last.start, since, &self.last.from, out, &mut self.error);
            if !out.iter().all(|value| value.is_finite()) {
                self.dense(since, out);
            }
        }
    }

    /// Locates a change found between `low` and `high`, relative to the start of the last step. States come from shorter
    /// steps from the same start. If the dense output and these steps disagree on whether the change happens, which errors
    /// within the tolerance can cause, the dense output decides.
    pub fn locate(
        &mut self,
        equations: &mut Equations,
        surfaces: &mut Surfaces,
        (low, high): (f64, f64),
        expected: Option<Crossing>,
    ) -> Crossing {
        self.forget();
        let start = self.last.start;
        let mut state = vec![0.0; self.last.from.len()];
        self.repeat(equations, low, &mut state);
        let early = low > 0.0 && surfaces.crossed(start + low, &state);
        self.repeat(equations, high, &mut state);
        if surfaces.crossed(start + high, &state) && !early {
            return surfaces.locate(start, (low, high), expected, |since, out| self.repeat(equations, since, out));
        }
        self.dense(high, &mut state);
        surfaces.crossed(start + high, &state);
        surfaces.locate(start, (low, high), expected, |since, out| self.dense(since, out))
    }

    /// Result of the last attempted step: SI, one value per state.
    pub fn attempt(&self) -> &[f64] {
        &self.attempt
    }

    /// Discards the rates or derivatives stored for the start of the step.
    fn forget(&mut self) {
        match &mut self.pair {
            Pair::DormandPrince(pair) => pair.reset(),
            Pair::Rosenbrock(pair) => pair.reset(),
        }
    }

    fn accept(&mut self, equations: &Equations, time: f64, size: f64, end: f64) {
        let last = &mut self.last;
        std::mem::swap(&mut last.from, &mut last.to);
        last.to.copy_from_slice(&self.attempt);
        last.start = time;
        last.size = size;
        last.end = end;
        match &mut self.pair {
            Pair::DormandPrince(pair) => {
                if !equations.dense_compiled(&last.from, &mut last.dense) {
                    pair.dense(size, &last.from, &last.to, &mut last.dense);
                }
                pair.accept();
            }
            Pair::Rosenbrock(pair) => {
                pair.dense(&last.from, &last.to, &mut last.dense);
                pair.reset();
            }
        }
        self.note_peaks();
    }

    fn note_peaks(&mut self) {
        for (peak, value) in self.last.peaks.iter_mut().zip(&self.last.to) {
            if value.abs() > *peak {
                *peak = value.abs();
            }
        }
    }

    /// Error in units of the allowed error: root mean square over the states.
    fn error_norm(&mut self) -> f64 {
        let allowed = (self.tolerance, self.below_peak);
        square_errors(&mut self.error, [&self.last.to, &self.attempt, &self.last.peaks, &self.floors], allowed);
        let sum = self.error.iter().fold(0.0, |sum, square| sum + square);
        (sum / self.error.len().max(1) as f64).sqrt()
    }
}

/// The greater one of two numbers that are not NaN, in one instruction.
#[inline(always)]
fn greater(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

/// Replaces each error by its square in units of the allowed error, several states at once: `tolerance` times the magnitude of the
/// state before and after the step, or times its least magnitude; NaN for a state that is not finite. SI units, one value per state.
// Not inlined: the compiler then knows that `errors` overlaps with nothing that is read.
#[inline(never)]
fn square_errors(errors: &mut [f64], numbers: [&[f64]; 4], (tolerance, below_peak): (f64, f64)) {
    let [before, after, peaks, floors] = numbers.map(|numbers| &numbers[..errors.len()]);
    for (k, error) in errors.iter_mut().enumerate() {
        let size = greater(before[k].abs(), after[k].abs());
        let scale = tolerance * greater(greater(size, below_peak * peaks[k]), floors[k]);
        let ratio = *error / scale;
        // A value that is not finite must not be hidden by a comparison.
        *error = if after[k].is_finite() { ratio * ratio } else { f64::NAN };
    }
}

fn step(
    pair: &mut Pair,
    equations: &mut Equations,
    time: f64,
    size: f64,
    from: &[f64],
    to: &mut [f64],
    error: &mut [f64],
) {
    match pair {
        Pair::DormandPrince(pair) => pair.step(equations, time, size, from, to, error),
        Pair::Rosenbrock(pair) => pair.step(equations, time, size, from, to, error),
    }
}
