//! Runs whose steps are made outside of the stepper, which continues them where something happens.

use super::{Solver, Stepper};
use crate::compiled::listing::{Preparation, WindowListing};
use crate::compiled::window_layout::WindowLayout;
use crate::methods::adaptive::{Place, StepControl};
use crate::methods::last_step::LastStep;
use crate::methods::tableau::STAGES;
use crate::{Method, Routine};
use program::Interpolation;
use std::sync::Arc;

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

    /// Conditions that could end a step early, whose interpolations are appended to `interpolations`: those of the
    /// [`Stepper::listing`] for a method that has them there. Without formulas if they cannot be checked by formulas.
    pub fn window(&self, interpolations: &mut Vec<Arc<Interpolation>>) -> WindowListing {
        self.surfaces.window(self.equations.size(), interpolations).0
    }

    /// Rates of the states, by which a fixed-step method interpolates within its steps where it looks for changes. They depend on the
    /// held values too. `None` if it does not look there.
    pub fn motion(&self) -> Option<&Routine> {
        let looks = self.surfaces.looks.as_ref()?;
        matches!(self.solver, Solver::Fixed(_)).then(|| looks.motion())
    }

    /// Preparations of the operations of the [`Stepper::listing`]: of the rates, then each of the
    /// [`WindowListing::formulas`](crate::WindowListing). `None` if it solves linear systems.
    pub fn preparations(&self) -> Option<(Preparation, [Preparation; 5])> {
        let (rates, first) = (self.equations.preparation()?, self.equations.interpolations());
        Some((rates, self.surfaces.preparations(first)?))
    }

    /// True if compiled code can make the steps of runs side by side: all that could happen in a step can be checked.
    pub(crate) fn can_be_beside(&self) -> bool {
        let checks = || self.surfaces.window(self.equations.size(), &mut Vec::new()).1;
        self.is_smooth() || (self.method == Method::DormandPrince && checks())
    }

    /// Writes all that determines how the run continues to the places of a window, for compiled code.
    pub(crate) fn write_to(&mut self, layout: &WindowLayout, mut put: impl FnMut(usize, &[f64])) {
        self.catch_up();
        put(0, self.equations.registers());
        for (number, registers) in self.surfaces.registers().into_iter().enumerate() {
            // Formulas that are not checked are not listed.
            put(layout.formula(number), registers.get(..layout.formulas[number]).unwrap_or_default());
        }
        let Solver::Adaptive(method) = &mut self.solver else { return };
        let (time, index, spacing, state) = (self.time, self.index, self.step, &self.state);
        self.surfaces.find_values_at(time, state);
        let values = self.surfaces.values_at(time, state).unwrap_or_default();
        let (armed, held) = (self.surfaces.events.armed(), self.surfaces.switches.held());
        let place = Place { time, index, spacing, state, armed, held, values };
        if let Some(begin) = method.begin_at(&mut self.equations, &place) {
            begin.write(layout, put);
        }
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

    /// Approximate number of floating-point operations of an attempt of a step by the Dormand-Prince method.
    pub(crate) fn work_of_attempt(&self) -> u64 {
        self.equations.work_of_stages(STAGES as u64 - 1)
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
