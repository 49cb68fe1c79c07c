//! Rows of the Dormand-Prince method that compiled code has computed in advance.

use super::{Solver, Stepper};
use crate::methods::adaptive::Place;

impl Stepper {
    /// Moves to the next grid point if its state is computed in advance or can be, and if nothing can happen on the way.
    /// False if not, or if the way needs more than about `work` floating-point operations.
    #[inline]
    pub(super) fn takes_row_ahead(&mut self, work: u64) -> bool {
        let known = self.equations.window.as_ref().is_some_and(|window| window.has_row(self.index));
        if !known && !self.begins_window() {
            return false;
        }
        let Some(window) = &mut self.equations.window else { return false };
        let taken = window.next_row();
        if taken.intervals > 1 && work < u64::MAX {
            let equations = self.equations.work_of(taken);
            if equations + taken.intervals * self.surfaces.work_of_interval() >= work {
                return false;
            }
        }
        let Some(window) = &mut self.equations.window else { return false };
        window.take_row(&mut self.state);
        self.equations.count(taken);
        self.surfaces.count(taken.intervals);
        true
    }

    /// Computes rows in advance. True if there is one.
    fn begins_window(&mut self) -> bool {
        self.catch_up();
        let (Solver::Adaptive(method), Some(window)) = (&mut self.solver, &self.equations.window) else { return false };
        if !window.checks() && !self.surfaces.is_smooth() {
            return false;
        }
        let Some(values) = self.surfaces.values_at(self.time, &self.state) else { return false };
        let place = Place {
            time: self.time,
            index: self.index,
            spacing: self.step,
            state: &self.state,
            armed: self.surfaces.events.armed(),
            held: self.surfaces.switches.held(),
            values,
        };
        method.begin_window(&mut self.equations, &place);
        self.equations.window.as_ref().is_some_and(|window| window.has_row(self.index))
    }

    /// Computes steps without rows in advance, if nothing can happen in them: for times that are not on the grid.
    pub(super) fn begin_steps(&mut self) {
        let (Solver::Adaptive(method), Some(window)) = (&mut self.solver, &self.equations.window) else { return };
        if method.end() > self.time || window.has_step() || !self.surfaces.is_smooth() {
            return;
        }
        let (time, index, spacing) = (self.time, self.index, f64::INFINITY);
        let place = Place { time, index, spacing, state: &self.state, armed: &[], held: &[], values: &[] };
        method.begin_window(&mut self.equations, &place);
    }

    /// Brings the method and the search for changes up to the row that was taken last, and discards the rows after it.
    pub(super) fn catch_up(&mut self) {
        self.equations.forget_rows();
        let Solver::Adaptive(method) = &mut self.solver else { return };
        if let Some(window) = self.equations.window.as_ref().filter(|window| window.is_ahead()) {
            self.surfaces.continue_at(self.time, &self.state, window.values());
            method.catch_up(&self.equations);
        }
        if let Some(window) = &mut self.equations.window {
            window.end();
        }
    }

    /// Takes over the registers of all that compiled code checks.
    pub(super) fn load_checks(&mut self) {
        if let Some(window) = self.equations.window.as_mut().filter(|window| window.checks()) {
            window.load_formulas(self.surfaces.registers());
        }
    }

    /// Discards the steps that were computed in advance.
    pub(super) fn forget_steps(&mut self) {
        if let Some(window) = &mut self.equations.window {
            window.forget();
        }
    }
}
