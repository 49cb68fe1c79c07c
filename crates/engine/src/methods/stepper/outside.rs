//! Runs whose steps are made outside of the stepper, which continues them where something happens.

use super::{Solver, Stepper};
use crate::compiled::listing::Preparation;
use crate::methods::adaptive::StepControl;
use crate::methods::last_step::LastStep;

/// A moment that a run has reached, with all that determines how it continues; SI units.
#[derive(Clone, Copy, Debug)]
pub struct Reached<'a> {
    /// The independent variable.
    pub time: f64,
    /// One value per state.
    pub state: &'a [f64],
    /// True for each event that can fire.
    pub armed: &'a [bool],
    /// Last step of an adaptive method.
    pub last: Option<&'a LastStep>,
    /// Number of steps since the last grid point.
    pub steps: usize,
}

impl Stepper {
    /// True if nothing can end a step early: the model has no events, no jumps and no changes at fixed times.
    pub fn is_smooth(&self) -> bool {
        self.surfaces.is_smooth()
    }

    /// Preparations of the operations of the [`Stepper::listing`]: of the rates, then each of the
    /// [`WindowListing::formulas`](crate::WindowListing). `None` if it solves linear systems.
    pub fn preparations(&self) -> Option<(Preparation, [Preparation; 5])> {
        let (rates, first) = (self.equations.preparation()?, self.equations.interpolations());
        Some((rates, self.surfaces.preparations(first)?))
    }

    /// Registers of the right-hand side.
    pub(crate) fn registers(&self) -> &[f64] {
        self.equations.registers()
    }

    /// Approximate number of floating-point operations of a step of a fixed-step method; 0 for other methods.
    pub(crate) fn work_of_step(&self) -> u64 {
        match &self.solver {
            Solver::Fixed(fixed) => self.equations.work_of_stages(fixed.stages()),
            Solver::Adaptive(_) => 0,
        }
    }

    /// Settings of the step control of an adaptive method.
    pub fn step_control(&self) -> Option<StepControl> {
        match &self.solver {
            Solver::Adaptive(adaptive) => Some(adaptive.control(self.step)),
            Solver::Fixed(_) => None,
        }
    }

    /// Approximate number of floating-point operations of an evaluation of the right-hand side.
    pub fn evaluation_work(&self) -> u64 {
        self.equations.work_of_stages(1)
    }

    /// Continues the run begun with [`Stepper::begin`] at a later moment, with the bits of a run that has come there by itself.
    pub fn continue_at(&mut self, reached: &Reached) {
        let parameters = std::mem::take(&mut self.parameters);
        self.stand_at(reached.time, reached.state, parameters, None);
        self.surfaces.events.set_armed(reached.armed);
        if let (Solver::Adaptive(adaptive), Some(step)) = (&mut self.solver, reached.last) {
            adaptive.go_on_after(step);
        }
        self.row.steps = reached.steps;
    }

    /// The moment reached.
    pub fn reached(&self) -> Reached<'_> {
        let last = match &self.solver {
            Solver::Adaptive(adaptive) => Some(adaptive.last()),
            Solver::Fixed(_) => None,
        };
        let armed = self.surfaces.events.armed();
        Reached { time: self.time, state: &self.state, armed, last, steps: self.row.steps }
    }

    /// Held values of the switches of the equations, which follow the parameters of the model in a [`Preparation`].
    pub fn held(&self) -> &[f64] {
        self.surfaces.switches.held()
    }
}
