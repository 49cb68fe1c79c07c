//! Compiled steps of a stepper.

use super::{Solver, Stepper};
use crate::Method;
use crate::compiled::Compiled;
use crate::compiled::listing::{Interpreted, Listing};
use std::rc::Rc;

impl Stepper {
    /// Moves to the next grid point, at the moment `target` (SI), if compiled code of a fixed-step method has computed its state in
    /// advance, which it does only where nothing can happen on the way. The first of these rows is taken by [`Stepper::takes_row`], so
    /// that no steps and events are counted since the row before.
    #[inline(always)]
    pub(super) fn takes_known_row(&mut self, target: f64) -> bool {
        // Rows are discarded where something could happen before them.
        if !self.equations.take_row(self.index, &mut self.state) {
            return false;
        }
        self.time = target;
        self.index += 1;
        true
    }

    /// Moves to the next grid point, at the moment `target` (SI), if nothing can happen on the way and its state is computed already or
    /// can be at once: within the last step of an adaptive method, by a step of a fixed-step method, or by compiled code that makes
    /// several steps. False if not, if the state is not finite there, or if compiled code needs more than about `work` floating-point
    /// operations.
    // Not inlined: `advance_within` is compiled with each of its callers.
    #[inline(never)]
    pub(super) fn takes_row(&mut self, target: f64, work: u64) -> bool {
        if !self.on_grid || !self.is_undisturbed() {
            return false;
        }
        match &mut self.solver {
            Solver::Adaptive(_) if self.equations.window.is_some() => {
                if !self.takes_row_ahead(work) {
                    return false;
                }
            }
            _ if !self.surfaces.is_smooth() => return false,
            Solver::Fixed(method) if self.equations.is_compiled() => {
                self.equations.begin_rows(method.stages(), self.index, self.step, &self.state);
                return self.takes_known_row(target);
            }
            Solver::Fixed(method) => {
                let evaluations = self.equations.evaluations;
                method.step(&mut self.equations, self.time, self.step, &self.state, &mut self.next);
                if !self.next.iter().all(|value| value.is_finite()) {
                    // The step is made again, for its error.
                    self.equations.evaluations = evaluations;
                    return false;
                }
                std::mem::swap(&mut self.state, &mut self.next);
            }
            Solver::Adaptive(method) if target < method.end() => {
                method.dense(target - method.start(), &mut self.state);
            }
            Solver::Adaptive(_) => return false,
        }
        self.time = target;
        self.index += 1;
        true
    }

    /// Moves to the moment `time` (SI) within the last step of an adaptive method. False if it is not there, or if something can happen
    /// on the way.
    pub(super) fn moves_within_step(&mut self, time: f64) -> bool {
        let Solver::Adaptive(method) = &self.solver else { return false };
        let within = self.time < time && time < method.end();
        if !within || !self.is_undisturbed() || !self.surfaces.is_smooth() {
            return false;
        }
        method.dense(time - method.start(), &mut self.state);
        self.time = time;
        true
    }

    /// True for a run with a continuous independent variable that has not stopped and in which no press is to come.
    #[inline(always)]
    fn is_undisturbed(&self) -> bool {
        self.stopped.is_none() && !self.counts && self.presses.next().is_none()
    }

    /// The steps of this stepper for a compiler.
    ///
    /// # Errors
    /// The reason why they can only be interpreted.
    pub fn listing(&self) -> Result<Listing, Interpreted> {
        if self.counts {
            return Err(Interpreted::Counting);
        }
        let pairs = match &self.solver {
            Solver::Fixed(fixed) => fixed.pairs(self.equations.order()),
            Solver::Adaptive(_) if self.method == Method::Rosenbrock => return Err(Interpreted::Method(self.method)),
            Solver::Adaptive(_) => Vec::new(),
        };
        let mut listing = self.equations.listing(self.method, pairs)?;
        if self.method == Method::DormandPrince {
            listing.window = Some(self.surfaces.window(self.equations.size(), &mut listing.interpolations).0);
        }
        Ok(listing)
    }

    /// Makes all later steps with `code`, which was compiled from the [`Stepper::listing`] of this stepper or of one with
    /// the same model and method. Bits and work stay the same.
    pub fn use_compiled(&mut self, code: Rc<dyn Compiled>) {
        if self.method == Method::DormandPrince {
            let (listing, checks) = self.surfaces.window(self.equations.size(), &mut Vec::new());
            self.catch_up();
            self.equations.use_window(code, listing.layout, checks);
            self.load_checks();
        } else {
            self.equations.use_compiled(code);
        }
    }
}
