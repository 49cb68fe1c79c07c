//! Rounds of the Dormand-Prince method for runs side by side (`engine/compiled/adaptive_lanes.rs`): for each pair, first the intervals
//! within the last steps, then an attempt of the next ones. Both runs of a pair have a time and a step size of their own; a condition
//! for each of them says where a result is assigned.

use crate::body::Body;
use crate::checks::Checks;
use crate::sink::{Local, Sink};
use crate::step::Step;
use engine::{LANES, LanesLayout, LanesListing, Stepper, WindowLayout, WindowListing};

/// Emits the loop over rounds and pairs.
pub(crate) fn rounds(listing: &LanesListing, window: &WindowListing, sink: &mut Sink) {
    let layout = listing.layout;
    sink.repeat_for_pairs(LANES / 2, layout.places(), 0, |sink| {
        let [index, limit, stopped, active, begun] = std::array::from_fn(|_| sink.local());
        for (local, place) in [(index, window.layout.index()), (limit, layout.limit()), (stopped, layout.stopped())] {
            sink.load(place);
            sink.set(local);
        }
        sink.get(index);
        sink.get(limit);
        sink.less();
        sink.get(stopped);
        sink.constant(0.0);
        sink.equal();
        sink.both();
        sink.set(active);
        sink.get(active);
        sink.any();
        sink.begin_if();
        sink.get(active);
        sink.set(begun);
        let pair = Pair::load(listing, window, [index, limit, stopped, active], sink);
        pair.take_intervals(sink);
        sink.get(active);
        sink.any();
        sink.begin_if();
        pair.attempt(sink);
        sink.end();
        pair.store(sink);
        sink.get(begun);
        sink.get(active);
        sink.differs();
        sink.any();
        sink.begin_if();
        sink.pause();
        sink.end();
        sink.end();
    });
}

/// Local variables of a pair of runs.
struct Pair<'a> {
    layout: LanesLayout,
    window: WindowLayout,
    step: Step<'a>,
    checks: Option<Checks<'a>>,
    readings: Body<'a>,
    /// Values that are read.
    values: Vec<Local>,
    index: Local,
    spacing: Local,
    limit: Local,
    base: Local,
    stopped: Local,
    rejected: Local,
    since: Local,
    /// Condition that the run goes on.
    active: Local,
    /// State at the end of the interval.
    next: Vec<Local>,
}

impl<'a> Pair<'a> {
    fn load(
        listing: &'a LanesListing,
        window: &'a WindowListing,
        [index, limit, stopped, active]: [Local; 4],
        sink: &mut Sink,
    ) -> Self {
        let LanesListing { steps, readings, checked, layout } = listing;
        let states = window.layout.states;
        let step = Step::load(steps, window.layout, sink);
        let checks = checked.then(|| Checks::load(window, &step.order, sink));
        let readings = Body::of_formulas(readings, &step.order.index, layout.readings(), sink);
        let places = [window.layout.spacing(), layout.base(), layout.rejected(), layout.since()];
        let [spacing, base, rejected, since] = places.map(|place| {
            let local = sink.local();
            sink.load(place);
            sink.set(local);
            local
        });
        // A condition has all bits of a number.
        sink.get(rejected);
        sink.constant(0.0);
        sink.not_equal();
        sink.set(rejected);
        Self {
            layout: *layout,
            window: window.layout,
            step,
            checks,
            readings,
            values: sink.locals(layout.values),
            index,
            spacing,
            limit,
            base,
            stopped,
            rejected,
            since,
            active,
            next: sink.locals(states),
        }
    }

    /// Takes all intervals within the last steps: up to rows, and with checks also up to the ends of the steps.
    fn take_intervals(&self, sink: &mut Sink) {
        let Self { step, active, index, since, .. } = self;
        let [target, until, ready, on_row] = std::array::from_fn(|_| sink.local());
        sink.begin_block();
        let done = sink.label();
        sink.begin_repeat();
        let again = sink.label();
        sink.get(*index);
        sink.constant(1.0);
        sink.add();
        sink.get(self.spacing);
        sink.multiply();
        sink.set(target);
        sink.get(target);
        if self.checks.is_some() {
            sink.get(step.end);
            sink.minimum();
        }
        sink.set(until);
        // With checks an interval begins before the end of the step; without them it ends there at the latest.
        sink.get(if self.checks.is_some() { step.time } else { target });
        sink.get(step.end);
        if self.checks.is_some() {
            sink.less()
        } else {
            sink.less_or_equal()
        }
        sink.get(*active);
        sink.both();
        sink.set(ready);
        sink.get(ready);
        sink.any();
        sink.instructions().i32_eqz();
        sink.branch_if(done);
        step.state_at_end_or(sink, until, &self.next);
        if let Some(checks) = &self.checks {
            self.check(sink, checks, until, ready);
        }
        for (&present, &next) in step.present.iter().zip(&self.next) {
            sink.get(next);
            sink.assign(present, Some(ready));
        }
        sink.get(until);
        sink.assign(step.time, Some(ready));
        sink.get(until);
        sink.get(target);
        sink.equal();
        sink.get(ready);
        sink.both();
        sink.set(on_row);
        if self.checks.is_some() {
            self.count_step(sink, ready);
        }
        sink.constant(0.0);
        sink.assign(*since, Some(on_row));
        self.take_row(sink, until, on_row);
        sink.branch(again);
        sink.end();
        sink.end();
    }

    /// Checks an interval. `ready`: condition that the run has one, which becomes false where a check fails; the run stops there.
    fn check(&self, sink: &mut Sink, checks: &Checks, until: Local, ready: Local) {
        sink.constant(0.0);
        sink.set(checks.failed);
        checks.check(sink, &self.step, until, &self.next);
        sink.get(checks.failed);
        sink.get(ready);
        sink.both();
        sink.set(checks.failed);
        self.stop(sink, checks.failed, 1.0);
        sink.get(ready);
        sink.get(checks.failed);
        sink.unless();
        sink.set(ready);
        checks.pass(sink, Some(ready));
    }

    /// Stops the run where a condition holds.
    fn stop(&self, sink: &mut Sink, condition: Local, reason: f64) {
        sink.constant(reason);
        sink.assign(self.stopped, Some(condition));
        sink.get(self.active);
        sink.get(condition);
        sink.unless();
        sink.set(self.active);
    }

    /// Counts a step since the last row.
    fn count_step(&self, sink: &mut Sink, condition: Local) {
        sink.get(self.since);
        sink.constant(1.0);
        sink.add();
        sink.assign(self.since, Some(condition));
    }

    /// Takes a row at `time` where a condition holds.
    fn take_row(&self, sink: &mut Sink, time: Local, on_row: Local) {
        let Self { index, layout, .. } = self;
        sink.get(on_row);
        sink.any();
        sink.begin_if();
        if layout.values > 0 {
            let row = sink.local();
            sink.get(*index);
            sink.get(self.base);
            sink.subtract();
            sink.set(row);
            self.readings.evaluate_at(sink, time, &self.next, &self.values);
            for run in [0, 1] {
                sink.holds_of(on_row, run);
                sink.begin_if();
                sink.store_run_in_row(run, layout.row(0), (row, layout.values), &self.values);
                sink.end();
            }
        }
        sink.get(*index);
        sink.constant(1.0);
        sink.add();
        sink.assign(*index, Some(on_row));
        sink.get(*index);
        sink.get(self.limit);
        sink.less();
        sink.get(self.active);
        sink.both();
        sink.set(self.active);
        sink.end();
    }

    /// Attempts the next steps.
    fn attempt(&self, sink: &mut Sink) {
        let Self { step, active, rejected, .. } = self;
        let [most, accepted, failed, stalled] = std::array::from_fn(|_| sink.local());
        sink.get(step.size);
        sink.get(step.proposed);
        sink.get(step.longest);
        sink.minimum();
        sink.get(*rejected);
        sink.choose();
        sink.assign(step.size, Some(*active));
        sink.constant(1.0);
        sink.constant(10.0);
        sink.get(*rejected);
        sink.choose();
        sink.set(most);
        step.attempt(sink);
        step.find_error(sink);
        sink.get(step.found);
        sink.constant(1.0);
        sink.less_or_equal();
        sink.get(*active);
        sink.both();
        sink.set(accepted);
        sink.get(*active);
        sink.get(accepted);
        sink.unless();
        sink.set(failed);
        step.find_growth(sink, most);
        step.accept(sink, Some(accepted));
        if self.checks.is_none() {
            self.count_step(sink, accepted);
        }
        sink.get(self.since);
        sink.constant(Stepper::MANY_STEPS as f64);
        sink.greater();
        sink.get(*active);
        sink.both();
        sink.set(stalled);
        sink.get(failed);
        sink.any();
        sink.begin_if();
        step.shrink(sink, Some(failed), |sink| {
            sink.get(failed);
            sink.both();
            sink.get(stalled);
            sink.either();
            sink.set(stalled);
        });
        sink.end();
        sink.get(failed);
        sink.assign(*rejected, Some(*active));
        self.stop(sink, stalled, 2.0);
    }

    /// Stores all that determines how the runs continue.
    fn store(&self, sink: &mut Sink) {
        let Self { layout, window, step, .. } = self;
        let record = window.record(0);
        for (place, local) in step.clock().into_iter().enumerate() {
            sink.store(record + place, local);
        }
        for k in 0..window.states {
            let dense =
                step.dense.iter().enumerate().map(|(degree, list)| (record + window.dense(degree) + k, list[k]));
            let own = [
                (window.present() + k, step.present[k]),
                (record + window.to() + k, step.to[k]),
                (record + window.peaks() + k, step.peaks[k]),
                (record + window.rates() + k, step.rates[0][k]),
            ];
            own.into_iter().chain(dense).for_each(|(place, local)| sink.store(place, local));
        }
        if let Some(checks) = &self.checks {
            for (number, &armed) in checks.armed.iter().enumerate() {
                sink.store(window.armed() + number, armed);
            }
            for (number, &value) in checks.values().iter().enumerate() {
                sink.store(window.values() + number, value);
            }
        }
        sink.get(self.rejected);
        sink.truth();
        sink.set(self.rejected);
        let rest = [
            (window.time(), step.time),
            (window.index(), self.index),
            (layout.stopped(), self.stopped),
            (layout.rejected(), self.rejected),
            (layout.since(), self.since),
        ];
        rest.into_iter().for_each(|(place, local)| sink.store(place, local));
    }
}
