//! The loops over steps and rows.

use crate::alone::{Alone, Taking};
use crate::checks::Interval;
use crate::ensemble::{Ensemble, Method};
use crate::grid::{Grid, WIDTH};
use crate::intervals::Intervals;
use engine::{Reached, RunError, Stepper};

/// Receiver of rows: index of the run, time (SI units), what is read.
type Take<'a> = &'a mut dyn FnMut(usize, f64, &[f64]);

/// Number of steps of a fixed-step method after which states are examined, if nothing is read in between.
const UNSEEN: u64 = 64;

impl Ensemble {
    /// Makes all steps of a fixed-step method.
    pub(crate) fn advance_fixed(&mut self, alone: &mut Alone, take: Take) {
        let Self { method: Method::Fixed(fixed), rates, lanes, .. } = self else { return };
        rates.prepare(&lanes.parameters, &lanes.initial);
        fixed.begin(rates, &lanes.initial);
        let blocks = lanes.blocks;
        let mut times = Grid::new(1, blocks);
        let (step, all, taken) = (self.grid.step, self.grid.all, self.grid.taken);
        let reads = !self.readings.is_empty();
        self.attempts = all;
        for index in 0..all {
            let Self { method: Method::Fixed(fixed), rates, .. } = self else { return };
            fixed.step(self.width, rates, self.grid.at(index), step);
            let (next, time) = (index + 1, self.grid.at(index + 1));
            if reads || next % UNSEEN == 0 || next == taken || next == all {
                self.leave_fixed(alone, if reads { index } else { 0 }, take);
                if !self.lanes.running.contains(&true) {
                    return;
                }
            }
            if next <= taken && (reads || next == taken) {
                let Self { method: Method::Fixed(fixed), .. } = self else { return };
                let states = std::mem::take(&mut fixed.states);
                if reads {
                    let running = std::mem::take(&mut self.lanes.running);
                    times.fill(0, time);
                    self.read(&times, &states, &running, take);
                    self.lanes.running = running;
                }
                if next == taken {
                    (0..blocks * WIDTH).for_each(|lane| self.lanes.keep(lane, time, &states));
                }
                let Self { method: Method::Fixed(fixed), .. } = self else { return };
                fixed.states = states;
            }
        }
    }

    /// Repeats the runs whose states are not finite, alone; their rows up to that of index `read` have been read.
    fn leave_fixed(&mut self, alone: &mut Alone, read: u64, take: Take) {
        for lane in 0..self.lanes.running.len() {
            let Method::Fixed(fixed) = &self.method else { return };
            if !self.lanes.running[lane] || !fixed.is_wrong(lane) {
                continue;
            }
            let [parameters, initial] = self.lanes.begun(lane);
            let read = self.grid.at(read);
            let mut reached = (0.0, initial.clone());
            let mut result = Ok(());
            let mut row = self.lanes.last_row(lane);
            for _ in 0..self.grid.all {
                let last = &mut row;
                let mut take = |time: f64, values: &[f64]| {
                    if time > read {
                        take(lane, time, values)
                    }
                };
                let taking = Taking { until: self.grid.last, last, take: &mut take };
                let at = Reached { time: reached.0, state: &reached.1, armed: &[], last: None, steps: 0 };
                match alone.go_on([&parameters, &initial], Some(&at), taking) {
                    Ok(Some(stepper)) => reached = (stepper.time(), stepper.state().to_vec()),
                    Ok(None) => break,
                    Err(error) => {
                        result = Err(error);
                        break;
                    }
                }
            }
            self.lanes.set_last_row(lane, &row);
            self.lanes.end(lane, result);
        }
    }

    /// Makes all steps of the Dormand-Prince method.
    pub(crate) fn advance_adaptive(&mut self, alone: &mut Alone, take: Take) {
        let Self { method: Method::Adaptive(steps, checks), rates, lanes, .. } = self else { return };
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
            let Self { method: Method::Adaptive(steps, _), rates, .. } = self else { return };
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
        let Self { method: Method::Adaptive(steps, _), lanes, grid, .. } = self else { return };
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
        let Self { method: Method::Adaptive(steps, _), lanes, .. } = self else { return };
        if !checked {
            for lane in 0..lanes.running.len() {
                lanes.steps[lane] += usize::from(steps.is_accepted(lane));
            }
        }
        while self.begin_intervals(intervals, checked) {
            let Self { method: Method::Adaptive(steps, checks), .. } = self else { return };
            steps.states_at(self.width, intervals.to.row(0), &mut intervals.next);
            if let Some(checks) = checks {
                let Intervals { from, to, present, next, ready, failed } = &mut *intervals;
                checks.check(self.width, steps, &Interval { from, to, present, next, ready }, failed);
            }
            self.end_intervals(alone, intervals, checked, take);
        }
    }

    /// Finds the interval of each lane: up to the next row, or with checks also up to the end of the step. False if there is none.
    fn begin_intervals(&self, intervals: &mut Intervals, checked: bool) -> bool {
        let Method::Adaptive(steps, _) = &self.method else { return false };
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
            let Self { method: Method::Adaptive(steps, _), lanes, grid, .. } = &mut *self else { return };
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
                self.finish(alone, lane, intervals, checked, take);
            }
        }
    }

    /// Lets a lane continue alone to its next row. `time` reached; `None`: at the end of its last step.
    fn leave(&mut self, alone: &mut Alone, lane: usize, intervals: &mut Intervals, time: Option<f64>, take: Take) {
        let Self { method: Method::Adaptive(steps, checks), rates, lanes, grid, .. } = self else { return };
        let [parameters, initial] = lanes.begun(lane);
        let last = steps.last(lane);
        let state = if time.is_some() { intervals.present.list(lane) } else { last.to.clone() };
        let armed = checks.as_ref().map(|checks| checks.armed(lane)).unwrap_or_default();
        let (time, made) = (time.unwrap_or(last.end), lanes.steps[lane]);
        let reached = Reached { time, state: &state, armed: &armed, last: Some(&last), steps: made };
        // Before its first row nothing has been read, and the run begins again: on a corner, the first steps can be so short
        // that a run continued after one of them finds another crossing.
        let reached = (lanes.index[lane] > 0).then_some(&reached);
        let mut take = |time: f64, values: &[f64]| take(lane, time, values);
        let mut row = lanes.last_row(lane);
        let taking = Taking { until: grid.last, last: &mut row, take: &mut take };
        let outcome = alone.go_on([&parameters, &initial], reached, taking);
        lanes.set_last_row(lane, &row);
        let stepper = match outcome {
            Ok(Some(stepper)) => stepper,
            Ok(None) => return lanes.end(lane, Ok(())),
            Err(error) => return lanes.end(lane, Err(error)),
        };
        lanes.index[lane] += 1;
        lanes.steps[lane] = 0;
        let reached = stepper.reached();
        intervals.from.set(0, lane, reached.time);
        intervals.present.set_lane(lane, reached.state);
        if let Some(last) = reached.last {
            steps.load(lane, last);
        }
        if let Some(checks) = checks {
            let here = (&intervals.from, &intervals.present);
            checks.load(lane, rates, (reached.armed, stepper.held()), here, &lanes.initial);
        }
        if lanes.index[lane] == grid.all {
            let checked = checks.is_some();
            self.finish(alone, lane, intervals, checked, &mut |_, time, values| take(time, values));
        }
    }

    /// Ends a lane that has reached its last row.
    fn finish(&mut self, alone: &mut Alone, lane: usize, intervals: &Intervals, checked: bool, take: Take) {
        let Self { method: Method::Adaptive(steps, checks), lanes, grid, .. } = self else { return };
        let time = grid.at(grid.all);
        if !checked || time > grid.last {
            return lanes.end(lane, Ok(()));
        }
        let [parameters, initial] = lanes.begun(lane);
        let last = steps.last(lane);
        let state = intervals.present.list(lane);
        let armed = checks.as_ref().map(|checks| checks.armed(lane)).unwrap_or_default();
        let reached = Reached { time, state: &state, armed: &armed, last: Some(&last), steps: 0 };
        let mut take = |time: f64, values: &[f64]| take(lane, time, values);
        let mut row = lanes.last_row(lane);
        let taking = Taking { until: grid.last, last: &mut row, take: &mut take };
        let result: Result<(), RunError> = alone.finish([&parameters, &initial], &reached, grid.until, taking);
        lanes.set_last_row(lane, &row);
        lanes.end(lane, result);
    }
}
