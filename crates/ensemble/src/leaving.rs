//! Lanes that leave: they continue alone where something happens, and come back.

use crate::alone::{Alone, Taking};
use crate::ensemble::{Ensemble, Method};
use crate::intervals::Intervals;
use engine::{LastStep, Reached, RunError};

/// Receiver of rows: index of the run, time (SI units), what is read.
pub(crate) type Take<'a> = &'a mut dyn FnMut(usize, f64, &[f64]);

/// Time of leaving and coming back, in rows of a run alone.
const DETOUR: u64 = 8;
/// Number of times that a lane comes back in any case.
const RETURNS: u64 = 8;

impl Ensemble {
    /// Lets a lane continue alone to its next row, or to its end if it has left so often that this takes less time. `time` reached;
    /// `None`: at the end of its last step.
    pub(crate) fn leave(
        &mut self,
        alone: &mut Alone,
        lane: usize,
        intervals: &mut Intervals,
        time: Option<f64>,
        take: Take,
    ) {
        let Self { method, checks, rates, lanes, grid, .. } = self;
        let begun = lanes.begun(lane);
        let last = last_step(method, lane);
        let (time, state) = match &last {
            Some(last) if time.is_none() => (last.end, last.to.clone()),
            _ => (intervals.from.get(0, lane), intervals.present.list(lane)),
        };
        let armed = checks.as_ref().map(|checks| checks.armed(lane)).unwrap_or_default();
        let steps = lanes.steps[lane];
        let reached = Reached { time, state: &state, armed: &armed, last: last.as_ref(), steps };
        // Before its first row nothing has been read, and the run begins again: on a corner, the first steps can be so short
        // that a run continued after one of them finds another crossing.
        let reached = (lanes.index[lane] > 0).then_some(&reached);
        lanes.left[lane] += 1;
        let left = lanes.left[lane];
        let stays = left > RETURNS && left * DETOUR > lanes.index[lane];
        let rows = if stays { grid.all - lanes.index[lane] } else { 1 };
        let mut row = lanes.last_row(lane);
        let mut take_row = |time: f64, values: &[f64]| take(lane, time, values);
        let taking = Taking { until: grid.last, last: &mut row, take: &mut take_row };
        let outcome = alone.go_on([&begun[0], &begun[1]], reached, rows, taking);
        lanes.set_last_row(lane, &row);
        let stepper = match outcome {
            Ok(Some(stepper)) => stepper,
            Ok(None) => return lanes.end(lane, Ok(())),
            Err(error) => return lanes.end(lane, Err(error)),
        };
        lanes.index[lane] += rows;
        lanes.steps[lane] = 0;
        let reached = stepper.reached();
        intervals.from.set(0, lane, reached.time);
        intervals.present.set_lane(lane, reached.state);
        match (method, reached.last) {
            (Method::Fixed(fixed), _) => fixed.load(rates, lane, reached.state),
            (Method::Adaptive(steps), Some(last)) => steps.load(lane, last),
            (Method::Adaptive(_), None) => {}
        }
        if let Some(checks) = checks {
            checks.load(lane, reached.armed, stepper.held());
        }
        if lanes.index[lane] == grid.all {
            self.finish(alone, lane, intervals, take);
        }
    }

    /// Brings the checks of all lanes that have left up to date.
    pub(crate) fn refresh(&mut self, intervals: &Intervals) {
        if let Some(checks) = &mut self.checks {
            checks.refresh(&mut self.rates, (&intervals.from, &intervals.present), &self.lanes.initial);
        }
    }

    /// Ends a lane that has reached its last row.
    pub(crate) fn finish(&mut self, alone: &mut Alone, lane: usize, intervals: &Intervals, take: Take) {
        let Self { method, checks, lanes, grid, .. } = self;
        let time = grid.at(grid.all);
        let Some(checks) = checks.as_ref().filter(|_| time <= grid.last) else { return lanes.end(lane, Ok(())) };
        let [parameters, initial] = lanes.begun(lane);
        let last = last_step(method, lane);
        let (state, armed) = (intervals.present.list(lane), checks.armed(lane));
        let reached = Reached { time, state: &state, armed: &armed, last: last.as_ref(), steps: 0 };
        let mut take = |time: f64, values: &[f64]| take(lane, time, values);
        let mut row = lanes.last_row(lane);
        let taking = Taking { until: grid.last, last: &mut row, take: &mut take };
        let result: Result<(), RunError> = alone.finish([&parameters, &initial], &reached, grid.until, taking);
        lanes.set_last_row(lane, &row);
        lanes.end(lane, result);
    }
}

/// The last step of a lane; `None` for a fixed-step method.
fn last_step(method: &Method, lane: usize) -> Option<LastStep> {
    match method {
        Method::Fixed(_) => None,
        Method::Adaptive(steps) => Some(steps.last(lane)),
    }
}
