//! Checks of events and switches by compiled code, which computes rows in advance until one of them could change.

use super::surfaces::Surfaces;
use crate::Routine;
use crate::compiled::listing::{Preparation, WindowListing};
use crate::compiled::window_layout::WindowLayout;
use program::Interpolation;
use std::sync::Arc;

/// Maximum number of rows of a window.
const ROWS: usize = 64;
/// Numbers in the records of a window, about.
const NUMBERS: usize = 4096;
/// Minimum number of steps of a window, among which the work at its begin is divided.
const LEAST_STEPS: usize = 24;

impl Surfaces {
    /// Conditions that compiled code checks, in the order of [`WindowListing::formulas`]; `None` for one that does not exist.
    fn routines(&self) -> [Option<&Routine>; 5] {
        let [values, slopes] = self.looks.as_ref().map_or([None; 2], |looks| looks.routines().map(Some));
        [Some(self.events.conditions()), self.switches.truths(), self.timetable.even(), values, slopes]
    }

    /// Preparations of the formulas of [`Surfaces::window`], whose interpolations begin at the index `first`; `None` if it solves
    /// linear systems.
    pub fn preparations(&self, mut first: usize) -> Option<[Preparation; 5]> {
        let mut preparations: [Preparation; 5] = Default::default();
        for (preparation, routine) in preparations.iter_mut().zip(self.routines()) {
            let Some(routine) = routine else { continue };
            *preparation = routine.preparation(first)?;
            first += routine.interpolations().len();
        }
        Some(preparations)
    }

    /// Registers of the formulas.
    pub fn registers(&self) -> [&[f64]; 5] {
        self.routines().map(|routine| routine.map_or(&[][..], Routine::registers))
    }

    /// The window of a model with `states` states and `registers` registers of its right-hand side. Interpolations are
    /// appended to `interpolations`. False with a window without checks, if compiled code cannot make them.
    pub fn window(
        &self,
        (states, registers): (usize, usize),
        interpolations: &mut Vec<Arc<Interpolation>>,
    ) -> (WindowListing, bool) {
        let listed = self.routines().map(|routine| match routine {
            Some(routine) => routine.formulas(interpolations),
            None => Some(Default::default()),
        });
        let checks = self.timetable.even().is_some() && listed.iter().all(Option::is_some);
        let formulas = if checks { listed.map(Option::unwrap_or_default) } else { Default::default() };
        let steps = (NUMBERS / (8 * states).max(1)).clamp(LEAST_STEPS, 32);
        let layout = WindowLayout {
            registers,
            states,
            events: formulas[0].roots.len(),
            switches: formulas[1].roots.len(),
            compared: formulas[3].roots.len(),
            formulas: formulas.each_ref().map(|formulas| formulas.registers),
            steps,
            rows: ROWS,
        };
        (WindowListing { layout, formulas }, checks)
    }

    /// Compared values and their rates of change at `time` and `state` (SI); `None` if the last step did not end there.
    pub fn values_at(&self, time: f64, state: &[f64]) -> Option<&[f64]> {
        match &self.looks {
            Some(looks) => looks.values_at(time, state),
            None => Some(&[]),
        }
    }

    /// Computes the compared values and their rates of change at `time` and `state` (SI), for [`Surfaces::values_at`]
    /// where no step ended.
    pub fn find_values_at(&mut self, time: f64, state: &[f64]) {
        if let Some(looks) = &mut self.looks {
            looks.find_values_at(time, state);
        }
    }

    /// Continues after rows that compiled code has checked, the last one at `time` and `state` (SI) with these compared values
    /// and rates of change.
    pub fn continue_at(&mut self, time: f64, state: &[f64], values: &[f64]) {
        if let Some(looks) = &mut self.looks {
            looks.continue_at(time, state, values);
        }
    }

    /// Approximate number of floating-point operations of the checks of an interval.
    pub fn work_of_interval(&self) -> u64 {
        let [conditions, switches, timed, _, slopes] = self.routines().map(|routine| routine.map_or(0, Routine::work));
        conditions + switches + 2 * timed + 4 * slopes
    }

    /// Counts evaluations that compiled code has made.
    pub fn count(&mut self, intervals: u64) {
        self.timetable.count(intervals);
        if !self.is_empty() {
            self.events.count(intervals);
            self.switches.count(intervals);
            self.looks.iter_mut().for_each(|looks| looks.count(intervals));
        }
    }
}
