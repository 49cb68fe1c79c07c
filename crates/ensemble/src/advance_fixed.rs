//! The loop over the rows of a fixed-step method.

use crate::alone::{Alone, Taking};
use crate::checks::Interval;
use crate::ensemble::{Ensemble, Method};
use crate::grid::{Block, Grid, WIDTH};
use crate::intervals::Intervals;
use crate::leaving::Take;
use engine::Reached;

/// Number of steps of a fixed-step method after which states are examined, if nothing is read or checked in between.
const UNSEEN: u64 = 64;

impl Ensemble {
    /// Makes all steps of a fixed-step method.
    pub(crate) fn advance_fixed(&mut self, alone: &mut Alone, take: Take) {
        let Self { method: Method::Fixed(fixed), checks, rates, lanes, .. } = self else { return };
        match checks {
            Some(checks) => checks.begin(rates, &lanes.parameters, &lanes.initial),
            None => rates.prepare(&lanes.parameters, &lanes.initial),
        }
        fixed.begin(rates, &lanes.initial);
        let mut intervals = std::mem::take(&mut self.intervals);
        intervals.begin(&lanes.initial);
        let (step, all, taken) = (self.grid.step, self.grid.all, self.grid.taken);
        let reads = !self.readings.is_empty();
        let checked = self.checks.is_some();
        self.attempts = all;
        for index in 0..all {
            if !self.lanes.running.contains(&true) {
                break;
            }
            let Self { method: Method::Fixed(fixed), rates, .. } = self else { return };
            if checked {
                intervals.present.clone_from(&fixed.states);
            }
            fixed.step(self.width, rates, self.grid.at(index), step);
            let next = index + 1;
            let mut on_row = self.lanes.running.clone();
            if checked {
                self.check_fixed(alone, (index, &mut on_row), &mut intervals, take);
            } else if reads || next % UNSEEN == 0 || next == taken || next == all {
                self.repeat_fixed(alone, if reads { index } else { 0 }, take);
                on_row.copy_from_slice(&self.lanes.running);
            }
            if next <= taken && (reads || next == taken) {
                self.take_fixed(next, &on_row, take);
            }
            for lane in (0..on_row.len()).filter(|&lane| checked && next == all && on_row[lane]) {
                self.finish(alone, lane, &intervals, take);
            }
        }
        self.intervals = intervals;
    }

    /// Reads the row of these lanes at the present states.
    fn take_fixed(&mut self, row: u64, on_row: &[bool], take: Take) {
        let Self { method: Method::Fixed(fixed), .. } = self else { return };
        let states = std::mem::take(&mut fixed.states);
        let time = self.grid.at(row);
        let mut times = Grid::new(1, states.blocks());
        times.fill(0, time);
        self.read(&times, &states, on_row, take);
        if row == self.grid.taken {
            (0..on_row.len()).filter(|&lane| on_row[lane]).for_each(|lane| self.lanes.keep(lane, time, &states));
        }
        let Self { method: Method::Fixed(fixed), .. } = self else { return };
        fixed.states = states;
    }

    /// Checks the steps from the row `index` to the next one. Lanes in which something could happen leave and are then no longer
    /// `on_row`.
    fn check_fixed(
        &mut self,
        alone: &mut Alone,
        (index, on_row): (u64, &mut [bool]),
        intervals: &mut Intervals,
        take: Take,
    ) {
        let Self { method: Method::Fixed(fixed), checks: Some(checks), lanes, grid, .. } = self else { return };
        let Intervals { from, to, present, next, ready, failed } = intervals;
        from.fill(0, grid.at(index));
        to.fill(0, grid.at(index + 1));
        next.clone_from(&fixed.states);
        for (block, ready) in ready.iter_mut().enumerate() {
            *ready = Block::each(|lane| {
                let place = block * WIDTH + lane;
                f64::from(u8::from(on_row[place] && !fixed.is_wrong(place)))
            });
        }
        checks.check(self.width, None, &Interval { from, to, present, next, ready }, failed);
        for (lane, on_row) in on_row.iter_mut().enumerate().filter(|(_, on_row)| **on_row) {
            lanes.index[lane] = index;
            *on_row = intervals.passed(lane);
        }
        for (lane, on_row) in on_row.iter().enumerate() {
            if self.lanes.running[lane] && !on_row {
                self.leave(alone, lane, intervals, Some(self.grid.at(index)), take);
            }
        }
        intervals.accept();
        self.refresh(intervals);
    }

    /// Repeats the runs whose states are not finite, alone; their rows up to that of index `read` have been read.
    fn repeat_fixed(&mut self, alone: &mut Alone, read: u64, take: Take) {
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
                match alone.go_on([&parameters, &initial], Some(&at), 1, taking) {
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
}
