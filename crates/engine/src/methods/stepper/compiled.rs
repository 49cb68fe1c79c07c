//! Compiled steps of a stepper.

use super::{Solver, Stepper};
use crate::Method;
use crate::compiled::Compiled;
use crate::compiled::listing::{Interpreted, Listing};
use std::rc::Rc;

impl Stepper {
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
        self.equations.listing(self.method, pairs)
    }

    /// Makes all later steps with `code`, which was compiled from the [`Stepper::listing`] of this stepper or of one with
    /// the same model and method. Bits and work stay the same.
    pub fn use_compiled(&mut self, code: Rc<dyn Compiled>) {
        self.equations.use_compiled(code, self.method);
    }
}
