//! Steps of the Dormand-Prince method that compiled code has made in advance.

use super::control::{growth, shrinkage};
use super::{Adaptive, Pair};
use crate::compiled::window::Begin;
use crate::methods::equations::Equations;
use crate::methods::last_step::LastStep;

/// Where a window begins, apart from the method.
#[derive(Debug)]
pub(crate) struct Place<'a> {
    /// Time reached, SI units.
    pub time: f64,
    /// Index of the grid point before the next row.
    pub index: u64,
    /// Distance of the rows, SI units.
    pub spacing: f64,
    pub state: &'a [f64],
    pub armed: &'a [bool],
    pub held: &'a [f64],
    /// Compared values and their rates of change.
    pub values: &'a [f64],
}

impl Adaptive {
    /// Computes steps and rows in advance.
    pub fn begin_window(&mut self, equations: &mut Equations, place: &Place) {
        let Some(begin) = self.begin_at(equations, place) else { return };
        if let Some(window) = &mut equations.window {
            window.begin(&begin);
        }
    }

    /// All that determines steps and rows from here on; `None` for other methods than Dormand-Prince.
    pub fn begin_at<'a>(&'a mut self, equations: &mut Equations, place: &Place<'a>) -> Option<Begin<'a>> {
        let Pair::DormandPrince(pair) = &mut self.pair else { return None };
        let uncounted = pair.find_first(equations, self.last.end, &self.last.to);
        let Place { time, index, spacing, state, armed, held, values } = *place;
        Some(Begin {
            settings: [time, index as f64, spacing, self.longest, self.tolerance, self.below_peak],
            floors: &self.floors,
            state,
            armed,
            held,
            values,
            last: &self.last,
            rates: pair.first(),
            uncounted,
        })
    }

    /// Brings the last step up to the row that was taken last.
    pub fn catch_up(&mut self, equations: &Equations) {
        let (Pair::DormandPrince(pair), Some(window)) = (&mut self.pair, &equations.window) else { return };
        if window.bring(&mut self.last) {
            pair.set_first(window.rates());
        }
    }

    /// The last step, up to the row that was taken last.
    pub fn step_reached(&self, equations: &Equations) -> LastStep {
        let mut last = self.last.clone();
        if let Some(window) = equations.window.as_ref().filter(|window| window.is_ahead()) {
            window.bring(&mut last);
        }
        last
    }

    /// Takes the next step if it was computed in advance.
    pub(super) fn take_step(&mut self, equations: &mut Equations) -> bool {
        let (Pair::DormandPrince(pair), Some(window)) = (&mut self.pair, &mut equations.window) else { return false };
        let Some(taken) = window.take_step(&mut self.last) else { return false };
        pair.set_first(window.rates());
        equations.count(taken);
        true
    }
}

/// Factor by which the controller of the Dormand-Prince method lets a step grow, before it is bounded (see
/// [`WindowLayout`](crate::WindowLayout)). `before`: error of the step before; both in units of the allowed error.
#[inline(always)]
pub fn dormand_prince_growth(before: f64, error: f64) -> f64 {
    growth(5.0, before, error)
}

/// Factor by which it lets a step shrink after an error that is not allowed, before it is bounded.
#[inline(always)]
pub fn dormand_prince_shrinkage(error: f64) -> f64 {
    shrinkage(5.0, error)
}
