//! The loop over steps and rows of the Dormand-Prince method.

use crate::alone::Alone;
use crate::checks::Interval;
use crate::ensemble::{Ensemble, Method};
use crate::grid::WIDTH;
use crate::intervals::Intervals;
use crate::leaving::Take;
use engine::Stepper;

impl Ensemble {
    /// Makes all steps of the Dormand-Prince method.
    pub(crate) fn advance_adaptive(&mut self, alone: &mut Alone, take: Take) {
        let Self { method: Method::Adaptive(steps), checks, rates, lanes, .. } = self else { return };
        match checks {
            Some(checks) => checks.begin(rates, &lanes.parameters, &lanes.initial),
            None => rates.prepare(&lanes.parameters, &lanes.initial),
        }
        steps.begin(&lanes.initial);
        let checked = checks.is_some();
        let mut intervals = std::mem::take(&mut self.intervals);
        intervals.begin(&lanes.initial);
        let unread = self.readings.is_empty() && !checked;
        let (mut active, mut stalled) = (vec![false; lanes.running.len()], vec![false; lanes.running.len()]);
        while self.lanes.running.contains(&true) {
            // The last step of a lane that has come back at a row can reach beyond that row: it makes no step before its intervals
            // are passed.
            active.copy_from_slice(&self.lanes.running);
            for (lane, active) in active.iter_mut().enumerate() {
                if *active && self.lanes.steps[lane] >= Stepper::MANY_STEPS {
                    *active = false;
                    self.leave(alone, lane, &mut intervals, None, take);
                }
            }
            self.refresh(&intervals);
            let Self { method: Method::Adaptive(steps), rates, .. } = self else { return };
            stalled.fill(false);
            self.attempts += 1;
            steps.attempt(self.width, rates, &active, &mut stalled);
            for (lane, &stalled) in stalled.iter().enumerate() {
                if self.lanes.running[lane] && stalled {
                    self.leave(alone, lane, &mut intervals, None, take);
                }
            }
            if unread {
                self.skip_rows();
            } else {
                self.advance_rows(alone, &mut intervals, checked, take);
            }
        }
        self.intervals = intervals;
    }

    /// Counts the rows within the last steps, of which only the last one is wanted.
    fn skip_rows(&mut self) {
        let Self { method: Method::Adaptive(steps), lanes, grid, .. } = self else { return };
        for lane in 0..lanes.running.len() {
            if !lanes.running[lane] || !steps.is_accepted(lane) {
                continue;
            }
            lanes.steps[lane] += 1;
            let end = steps.end(lane);
            let reached = grid.reached(lanes.index[lane], end);
            if reached == lanes.index[lane] {
                continue;
            }
            if (lanes.index[lane] + 1..=reached).contains(&grid.taken) {
                let time = grid.at(grid.taken);
                lanes.last_time.set(0, lane, time);
                (0..steps.to.rows()).for_each(|state| lanes.last.set(state, lane, steps.state_at(lane, time, state)));
            }
            lanes.index[lane] = reached;
            lanes.steps[lane] = usize::from(end > grid.at(reached));
            if reached == grid.all {
                lanes.end(lane, Ok(()));
            }
        }
    }

    /// Advances over all intervals and rows within the last steps.
    fn advance_rows(&mut self, alone: &mut Alone, intervals: &mut Intervals, checked: bool, take: Take) {
        let Self { method: Method::Adaptive(steps), lanes, .. } = self else { return };
        if !checked {
            for lane in 0..lanes.running.len() {
                lanes.steps[lane] += usize::from(steps.is_accepted(lane));
            }
        }
        while self.begin_intervals(intervals, checked) {
            self.refresh(intervals);
            let Self { method: Method::Adaptive(steps), checks, .. } = self else { return };
            steps.states_at(self.width, intervals.to.row(0), &mut intervals.next);
            if let Some(checks) = checks {
                let Intervals { from, to, present, next, ready, failed } = &mut *intervals;
                checks.check(self.width, Some(steps), &Interval { from, to, present, next, ready }, failed);
            }
            self.end_intervals(alone, intervals, checked, take);
        }
    }

    /// Finds the interval of each lane: up to the next row, or with checks also up to the end of the step. False if there is none.
    fn begin_intervals(&self, intervals: &mut Intervals, checked: bool) -> bool {
        let Method::Adaptive(steps) = &self.method else { return false };
        let mut any = false;
        for (lane, &running) in self.lanes.running.iter().enumerate() {
            let (target, end) = (self.grid.at(self.lanes.index[lane] + 1), steps.end(lane));
            let to = if checked { target.min(end) } else { target };
            let ready = running && if checked { intervals.from.get(0, lane) < end } else { target <= end };
            intervals.to.set(0, lane, to);
            intervals.ready[lane / WIDTH].0[lane % WIDTH] = f64::from(u8::from(ready));
            any |= ready;
        }
        any
    }

    /// Takes over the ends of the intervals, and reads the rows there. Lanes whose checks fail leave.
    fn end_intervals(&mut self, alone: &mut Alone, intervals: &mut Intervals, checked: bool, take: Take) {
        let count = self.lanes.running.len();
        let on_row: Vec<bool> = (0..count)
            .map(|lane| {
                let passed = intervals.passed(lane) && self.lanes.index[lane] < self.grid.taken;
                passed && intervals.to.get(0, lane) == self.grid.at(self.lanes.index[lane] + 1)
            })
            .collect();
        if on_row.contains(&true) {
            self.read(&intervals.to, &intervals.next, &on_row, take);
        }
        if checked {
            intervals.accept();
        }
        for lane in 0..count {
            if intervals.ready[lane / WIDTH].0[lane % WIDTH] == 0.0 {
                continue;
            }
            if !intervals.passed(lane) {
                self.leave(alone, lane, intervals, Some(intervals.from.get(0, lane)), take);
                continue;
            }
            let Self { method: Method::Adaptive(steps), lanes, grid, .. } = &mut *self else { return };
            let to = intervals.to.get(0, lane);
            if to != grid.at(lanes.index[lane] + 1) {
                lanes.steps[lane] += 1;
                continue;
            }
            let end = steps.end(lane);
            lanes.index[lane] += 1;
            lanes.steps[lane] = usize::from(!checked && end > to);
            if lanes.index[lane] == grid.taken {
                self.lanes.keep(lane, to, &intervals.next);
            }
            if self.lanes.index[lane] == self.grid.all {
                self.finish(alone, lane, intervals, take);
            }
        }
    }
}
