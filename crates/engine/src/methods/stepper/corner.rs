//! Corners of the equations at which a held branch ends.
//!
//! A switch keeps its value during a step ([`program::Held`]), and a stage can lie beyond the corner, where that branch has no
//! value: `sqrt(max(h, 0))` is evaluated as `sqrt(h)`. The same happens where an event comes before the equations lose their
//! value. A step without a result is therefore shortened. Steps approach the corner by a constant factor each, with the order of
//! the method, until the rounding of the time or of the state is reached. The last step goes beyond with the rates at the present
//! state, which has a value, so that the switch changes or the event fires there.

use super::advance::Early;
use super::{Solver, Stepper};
use crate::events::follow;
use crate::{Cause, RunError};

impl Stepper {
    /// Fraction of a rate that counts as 0 after it.
    const AT_REST: f64 = 0.1;
    /// Least jump of a rate, relative to the rate at the last step before.
    const JUMP: f64 = 1e-3;
    /// Least change of a state by it in a step of the grid, relative to the state.
    const SHIFT: f64 = 1e-8;
    /// Maximum number of roundings by which a state is moved.
    const ROUNDINGS: usize = 4;
    /// Number of steps of an adaptive method in a row of the grid from which on a standstill is expected. Steps made outside of the stepper
    /// end there: the stepper goes on.
    pub const MANY_STEPS: usize = 1000;
    /// Number of short steps after which a standstill is expected.
    const OFTEN: usize = 64;
    /// Size of a step, as a fraction of that of the grid, with which a row takes too many steps.
    const TOO_SHORT: f64 = 1e-5;
    /// Maximum distance of a corner at which a step fails, in multiples of the shortest step.
    const NEAR: f64 = 1024.0;

    /// Makes a step of a fixed-step method of at most `size` towards `end` (both SI) after one of that size has failed.
    #[cold]
    pub(super) fn shortened(&mut self, mut size: f64, end: f64) -> Result<Option<Early>, RunError> {
        let cause = self.not_finite();
        let least = f64::EPSILON * end;
        while self.may_shorten() && size > least {
            size *= 0.5;
            if self.try_fixed(size) {
                self.row.shortened += 1;
                if self.row.shortened.is_multiple_of(Self::OFTEN) && self.is_too_short(size) {
                    break;
                }
                if let Some(early) = self.arrive(self.time + size, size, None) {
                    return Ok(early);
                }
            }
        }
        self.cross(size, end, true).ok_or_else(|| self.error(cause))
    }

    /// Goes from the present state, where no step of the method is short enough, beyond the corner nearby, by a step with the rates
    /// at the present state (Euler). Without a corner nearby, it makes the shortest step if it `may_creep`: a stage can be beyond a
    /// corner that the rates only point to after it. `shortest` and `end` are the size of that step and its latest end, SI units.
    /// Returns `None` if that cannot help.
    #[cold]
    pub(super) fn cross(&mut self, shortest: f64, end: f64, may_creep: bool) -> Option<Option<Early>> {
        if !self.may_shorten() {
            return None;
        }
        self.row.shortened += 1;
        let (time, from) = (self.time, &self.state);
        let mut rates = vec![0.0; from.len()];
        self.equations.rates(time, from, &mut rates);
        let straight = |since: f64, out: &mut [f64]| follow(out, from, &rates, since);
        let mut size = shortest;
        while size <= Self::NEAR * shortest {
            straight(size, &mut self.next);
            if !self.next.iter().all(|value| value.is_finite()) {
                return None;
            }
            if self.surfaces.crossed(time + size, &self.next) {
                let crossing = self.surfaces.locate(time, (0.0, size), None, straight);
                return Some(Some(Early::new(crossing, time, size, end.min(time + size))));
            }
            size *= 2.0;
        }
        if !may_creep {
            return None;
        }
        straight(shortest, &mut self.next);
        self.surfaces.crossed(time + shortest, &self.next);
        self.surfaces.events.pass();
        std::mem::swap(&mut self.state, &mut self.next);
        self.time = end.min(time + shortest);
        self.on_grid = false;
        self.restart();
        Some(None)
    }

    /// Goes beyond a corner nearby if an adaptive method makes many steps between two rows that hardly change the time, because longer
    /// ones have no value. `end` as for [`Stepper::cross`].
    pub(super) fn leave_standstill(&mut self, end: f64) -> Option<Option<Early>> {
        let Solver::Adaptive(method) = &self.solver else { return None };
        let (size, begins) = (method.last().size, method.end() <= self.time);
        let often = self.row.steps > Self::MANY_STEPS && self.row.steps.is_multiple_of(Self::OFTEN);
        if often && begins && size > 0.0 && self.is_too_short(size) { self.cross(size, end, false) } else { None }
    }

    /// True if steps of this size (SI) do not reach the next row within the limits: rounding keeps a state before its corner, so that
    /// steps no longer come nearer.
    fn is_too_short(&self, size: f64) -> bool {
        size < Self::TOO_SHORT * self.step
    }

    /// Moves the state before the crossing found last by roundings to where the rates are least, if one of them is nearly 0 there. A
    /// motion that comes to rest on a corner, as the levels of two tanks do, otherwise goes to and fro about it where no sum of
    /// rounded numbers is exactly there.
    #[cold]
    pub(super) fn rest_on_corner(&mut self) {
        let Self { equations, surfaces, time, next: state, .. } = self;
        let (mut rates, mut usual) = (vec![0.0; state.len()], vec![0.0; state.len()]);
        state.copy_from_slice(surfaces.before());
        equations.rates(*time, state, &mut usual);
        let speed = |rates: &[f64]| rates.iter().fold(0.0, |sum, rate| sum + rate.abs());
        let mut least = speed(&usual);
        for _ in 0..Self::ROUNDINGS {
            for place in 0..state.len() {
                let known = state[place];
                for moved in [known.next_down(), known.next_up()] {
                    let kept = std::mem::replace(&mut state[place], moved);
                    equations.rates(*time, state, &mut rates);
                    let found = speed(&rates);
                    if found < least { least = found } else { state[place] = kept }
                }
            }
        }
        equations.rates(*time, state, &mut rates);
        if rates.iter().zip(&usual).any(|(rate, usual)| rate.abs() < Self::AT_REST * usual.abs()) {
            self.state.copy_from_slice(&self.next);
        }
    }

    /// Rates at the present state and at the state before the switch found last, at the time `before` (SI), if a doubt of the search
    /// for jumps is to be judged by them; otherwise empty.
    #[cold]
    pub(super) fn rates_around(&mut self, before: f64) -> [Vec<f64>; 2] {
        let mut rates = [Vec::new(), Vec::new()];
        if self.surfaces.doubts_jump(self.time - self.step) {
            let places = [(self.time, self.state.as_slice()), (before, self.surfaces.before())];
            for (rates, (time, state)) in rates.iter_mut().zip(places) {
                rates.resize(state.len(), 0.0);
                self.equations.rates(time, state, rates);
            }
        }
        rates
    }

    /// Drops the doubt if the rates do not jump at the switch, as those of `sign(h)*sqrt(abs(h))` where h passes 0: the interpolant
    /// is wrong at such a corner, but a switch that is skipped there has no effect. `rates` as [`Stepper::rates_around`].
    #[cold]
    pub(super) fn drop_doubt(&mut self, began: f64, [usual, before]: &[Vec<f64>; 2]) {
        if before.is_empty() {
            return;
        }
        let mut behind = vec![0.0; before.len()];
        self.equations.rates(self.time, &self.state, &mut behind);
        let jumps = behind.iter().enumerate().any(|(place, behind)| {
            let jump = (before[place] - behind).abs();
            jump > Self::JUMP * usual[place].abs() && jump * self.step > Self::SHIFT * self.state[place].abs()
        });
        if !jumps {
            self.surfaces.drop_doubt(began - self.step);
        }
    }

    /// True if a change could end the step before the equations lose their value. The steps that are shortened in a row are limited.
    fn may_shorten(&self) -> bool {
        !self.surfaces.is_empty() && self.row.shortened <= Self::SWITCH_LIMIT
    }

    /// Cause of a failed step.
    #[cold]
    pub(super) fn not_finite(&self) -> Cause {
        let state = match &self.solver {
            Solver::Fixed(_) => &self.next,
            Solver::Adaptive(method) => method.attempt(),
        };
        super::advance::not_finite(state, self.equations.singular(), self.method)
    }
}
