//! Step size control for the methods with an error estimate.

use super::dormand_prince::{DormandPrince, dense_value};
use super::equations::Equations;
use super::rosenbrock::Rosenbrock;
use crate::Setup;
use crate::events::crossing::Crossing;
use crate::events::surfaces::Surfaces;
use program::Model;

/// Two methods in one, whose difference is the error.
#[derive(Clone, Debug)]
pub(crate) enum Pair {
    DormandPrince(DormandPrince),
    Rosenbrock(Rosenbrock),
}

/// Why no step was possible.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Stalled {
    /// The state after even the smallest step is not finite.
    NotFinite,
    /// The error is too large even for the smallest step.
    TooSmall,
}

/// An adaptive method, with the last step it made and the continuous solution over it.
#[derive(Clone, Debug)]
pub(crate) struct Adaptive {
    pair: Pair,
    tolerance: f64,
    /// Errors below tolerance times this do not count, for each state.
    floors: Vec<f64>,
    /// A state is near zero below this part of its peak: the error allowed falls no further.
    below_peak: f64,
    /// No step is longer, lest a short push be leapt over while all is at rest.
    longest: f64,
    last: LastStep,
    attempt: Vec<f64>,
    error: Vec<f64>,
}

/// The last accepted step, and all else that decides the next one.
#[derive(Clone, Debug)]
pub(crate) struct LastStep {
    start: f64,
    size: f64,
    /// `start + size`, but exactly the row it was to reach.
    end: f64,
    from: Vec<f64>,
    to: Vec<f64>,
    /// The coefficients of the continuous solution.
    dense: [Vec<f64>; 5],
    /// The size proposed for the next step.
    proposed: f64,
    /// The error, for the controller.
    error: f64,
    /// The greatest magnitude each state has had.
    peaks: Vec<f64>,
}

impl LastStep {
    /// The memory it takes.
    pub fn bytes(&self) -> usize {
        size_of::<f64>() * 8 * self.to.len() + size_of::<Self>()
    }
}

impl Adaptive {
    /// A step spans at most so many rows.
    const ROWS: f64 = 10.0;
    /// [`Adaptive::below_peak`] of a run that is looked at.
    const BELOW_PEAK: f64 = 1e-3;
    /// A state is zero but for rounding below this part of its display unit, which is the author's idea of its size.
    const BELOW_UNIT: f64 = 1e-9;
    /// The first step in rows: the controller finds the right size within a few attempts.
    const FIRST_STEP: f64 = 0.01;
    /// The error that the step before the first is taken to have had.
    const FIRST_ERROR: f64 = 1e-4;
    /// Nothing moves in a shorter time, and its reciprocal is still a number.
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

    /// Forgets all runs made before; rows are `step` apart.
    pub fn renew(&mut self, step: f64) {
        self.last.proposed = Self::FIRST_STEP * step;
        self.last.error = Self::FIRST_ERROR;
        self.last.peaks.fill(0.0);
    }

    /// Allows this error in each step, relative to the peak of each state.
    pub fn allow_of_peak(&mut self, tolerance: f64) {
        self.tolerance = tolerance;
        self.below_peak = 1.0;
    }

    /// Begins again at `time` with `state`, after a jump of the state or the parameters.
    pub fn restart(&mut self, time: f64, state: &[f64]) {
        self.last.start = time;
        self.last.size = 0.0;
        self.last.end = time;
        self.last.from.copy_from_slice(state);
        self.last.to.copy_from_slice(state);
        self.note_peaks();
        self.forget();
    }

    /// The last step: what has to be known to go on with the same bits.
    pub fn last_step(&self) -> &LastStep {
        &self.last
    }

    /// Goes on after a step that was the last one before.
    pub fn go_on_after(&mut self, step: &LastStep) {
        self.last.clone_from(step);
        // The rates at its end are computed again, from the same numbers.
        self.forget();
    }

    /// About how many operations the linear systems of the stiff method took, after so many evaluations of the equations:
    /// a factorisation for each step and a solution for each stage.
    pub fn work_of_systems(&self, evaluations: u64) -> u64 {
        match &self.pair {
            Pair::DormandPrince(_) => 0,
            Pair::Rosenbrock(pair) => evaluations * pair.work_of_stage(),
        }
    }

    /// Where the last step started.
    pub fn start(&self) -> f64 {
        self.last.start
    }

    /// Where the last step ended.
    pub fn end(&self) -> f64 {
        self.last.end
    }

    /// The state at the end of the last step.
    pub fn end_state(&self) -> &[f64] {
        &self.last.to
    }

    /// Makes the next step. The controller is proportional-integral (Hairer & Wanner, Solving Ordinary Differential
    /// Equations II, section IV.2) with the constants of their code DOPRI5: safety 0.9, at most five times smaller or ten
    /// times larger, and not larger right after a rejection.
    ///
    /// The stiff method does not step over `row`: where a stiff part forces the solution, as in the problem of Prothero
    /// and Robinson, its dense output is less exact by orders than its steps.
    pub fn extend(&mut self, equations: &mut Equations, row: f64) -> Result<(), Stalled> {
        let time = self.last.end;
        let order = match self.pair {
            Pair::DormandPrince(_) => 5.0,
            Pair::Rosenbrock(_) => 4.0,
        };
        let integral = 0.04;
        let proportional = 1.0 / order - 0.75 * integral;
        let wanted = self.last.proposed.min(self.longest);
        let lands = matches!(self.pair, Pair::Rosenbrock(_)) && time + 1.001 * wanted >= row;
        let mut size = if lands { row - time } else { wanted };
        let mut rejected = false;
        loop {
            let smallest = 16.0 * f64::EPSILON * time.abs().max(f64::MIN_POSITIVE / f64::EPSILON);
            step(&mut self.pair, equations, time, size, &self.last.to, &mut self.attempt, &mut self.error);
            let error = self.error_norm();
            if error <= 1.0 {
                let growth = 0.9 * libm::pow(self.last.error, integral) / libm::pow(error.max(1e-10), proportional);
                let growth = growth.clamp(0.2, if rejected { 1.0 } else { 10.0 });
                self.last.error = error.max(1e-4);
                let on_row = lands && !rejected;
                self.accept(time, size, if on_row { row } else { time + size });
                // A step cut short by a row says nothing against the size that was wanted.
                self.last.proposed = if on_row { wanted.max(size * growth) } else { size * growth };
                return Ok(());
            }
            if size <= smallest {
                let finite = self.attempt.iter().all(|value| value.is_finite());
                return Err(if finite { Stalled::TooSmall } else { Stalled::NotFinite });
            }
            let shrinkage = 0.9 / libm::pow(error, proportional);
            // Also where the error is not a number.
            size *= if shrinkage > 0.2 { shrinkage } else { 0.2 };
            size = size.max(smallest);
            rejected = true;
        }
    }

    /// The state on the continuous solution over the last step, at `part` of the time since its start.
    pub fn dense(&self, since_start: f64, out: &mut [f64]) {
        dense_value(&self.last.dense, since_start / self.last.size, out);
    }

    /// The state so long after the start of the last step, by a shorter step from the same start. Another step begins there.
    pub fn shorter(&mut self, equations: &mut Equations, since: f64, out: &mut [f64]) {
        self.forget();
        self.repeat(equations, since, out);
    }

    /// The same, if what the method knows of another start is already forgotten.
    fn repeat(&mut self, equations: &mut Equations, since: f64, out: &mut [f64]) {
        if since < Self::AT_ONCE {
            out.copy_from_slice(&self.last.from);
        } else {
            step(&mut self.pair, equations, self.last.start, since, &self.last.from, out, &mut self.error);
        }
    }

    /// Where that lies which was found to happen between `low` and `high` after the start of the last step. A shorter step
    /// from the same start gives the state there; where the dense output and such a step disagree on whether it happens at
    /// all, which is a matter of errors within the tolerance, the dense output decides.
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

    /// The state that the last attempt led to.
    pub fn attempt(&self) -> &[f64] {
        &self.attempt
    }

    /// Forgets what is known of the state from which a step starts.
    fn forget(&mut self) {
        match &mut self.pair {
            Pair::DormandPrince(pair) => pair.reset(),
            Pair::Rosenbrock(pair) => pair.reset(),
        }
    }

    fn accept(&mut self, time: f64, size: f64, end: f64) {
        let last = &mut self.last;
        std::mem::swap(&mut last.from, &mut last.to);
        last.to.copy_from_slice(&self.attempt);
        last.start = time;
        last.size = size;
        last.end = end;
        match &mut self.pair {
            Pair::DormandPrince(pair) => {
                pair.dense(size, &last.from, &last.to, &mut last.dense);
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

    /// The error in units of what is allowed, the root of the mean square over the states.
    fn error_norm(&self) -> f64 {
        let mut sum = 0.0;
        for (k, error) in self.error.iter().enumerate() {
            let size = self.last.to[k].abs().max(self.attempt[k].abs());
            let scale = self.tolerance * size.max(self.below_peak * self.last.peaks[k]).max(self.floors[k]);
            let ratio = error / scale;
            // A value that is not finite must not hide behind `max`, which passes over NaN.
            sum += if self.attempt[k].is_finite() { ratio * ratio } else { f64::NAN };
        }
        (sum / self.error.len().max(1) as f64).sqrt()
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
