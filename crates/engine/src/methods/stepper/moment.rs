//! Moments of a stepper: saving and restoring its state.

use super::{RowWork, Solver, Stepper};
use crate::methods::last_step::LastStep;
use crate::{AfterJump, Press};

/// Everything that determines how a stepper continues, besides its model and setup.
#[derive(Clone, Debug)]
pub(crate) struct Moment {
    time: f64,
    state: Vec<f64>,
    parameters: Vec<f64>,
    armed: Vec<bool>,
    presses: usize,
    last_step: Option<LastStep>,
}

impl Moment {
    /// Memory, in bytes.
    pub fn bytes(&self) -> usize {
        let numbers = size_of::<f64>() * (self.state.len() + self.parameters.len());
        numbers + self.armed.len() + size_of::<Self>() + self.last_step.as_ref().map_or(0, LastStep::bytes)
    }
}

impl Stepper {
    /// Begins a new run at 0 with other parameters and another initial state (SI units), as a new stepper would.
    pub fn begin(&mut self, parameters: Vec<f64>, initial: &[f64]) {
        self.initial.copy_from_slice(initial);
        self.catch_up();
        if let Solver::Adaptive(adaptive) = &mut self.solver {
            adaptive.renew(self.step);
        }
        self.resume(0.0, initial, parameters, None);
    }

    /// Continues from another moment (SI). `after` has the additional data if the state has just jumped.
    pub(crate) fn resume(&mut self, time: f64, state: &[f64], parameters: Vec<f64>, after: Option<&AfterJump>) {
        self.stand_at(time, state, parameters, after.map(|after| after.presses));
        self.restart();
        match after {
            Some(after) => {
                self.surfaces.events.set_armed(&after.armed);
                self.on_grid = after.on_grid;
            }
            None => self.surfaces.events.arm(time, &self.state),
        }
    }

    /// Replaces the presses; those that have acted must be the first ones of the list.
    pub(crate) fn set_presses(&mut self, presses: &[Press]) {
        self.catch_up();
        self.presses.replace(presses);
    }

    /// Time of the next press, SI units.
    pub(crate) fn next_press(&self) -> Option<f64> {
        self.presses.next()
    }

    /// The current moment, to continue from here later with the same bits.
    pub(crate) fn moment(&self) -> Moment {
        Moment {
            time: self.time,
            state: self.state.clone(),
            parameters: self.parameters.clone(),
            armed: self.surfaces.events.armed().to_vec(),
            presses: self.presses.acted(),
            last_step: match &self.solver {
                Solver::Adaptive(adaptive) => Some(adaptive.step_reached(&self.equations)),
                Solver::Fixed(_) => None,
            },
        }
    }

    /// Continues from a saved moment with the same bits.
    pub(crate) fn go_on_from(&mut self, moment: &Moment) {
        self.stand_at(moment.time, &moment.state, moment.parameters.clone(), Some(moment.presses));
        self.surfaces.events.set_armed(&moment.armed);
        if let (Solver::Adaptive(adaptive), Some(step)) = (&mut self.solver, &moment.last_step) {
            adaptive.go_on_after(step);
        }
    }

    pub(super) fn stand_at(&mut self, time: f64, state: &[f64], parameters: Vec<f64>, presses: Option<usize>) {
        self.catch_up();
        self.time = time;
        self.presses.stand_at(time, presses);
        self.state.copy_from_slice(state);
        self.parameters = parameters;
        self.stopped = None;
        self.row = RowWork::default();
        self.surfaces.go_back_to(time);
        self.find_grid();
        self.prepare();
    }

    /// Finds the last grid point at or before the current time.
    pub(super) fn find_grid(&mut self) {
        self.index = grid_index(self.time, self.step);
        self.on_grid = self.index as f64 * self.step == self.time;
    }
}

/// Index of the last grid point at or before `time`; `time` and `step` in the same unit.
pub(crate) fn grid_index(time: f64, step: f64) -> u64 {
    let mut index = (time / step) as u64;
    while index > 0 && index as f64 * step > time {
        index -= 1;
    }
    while (index + 1) as f64 * step <= time {
        index += 1;
    }
    index
}
