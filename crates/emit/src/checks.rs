//! Checks that nothing happens in an interval: no timed switch changes, no compared values allow an event or switch between
//! the ends, and all conditions and switches are the same at the end. Where one fails the code leaves the window; of runs side by side, each is marked.

use crate::arithmetic::Where;
use crate::body::Body;
use crate::function::Function;
use crate::sink::{Local, Sink, Values};
use crate::states::States;
use crate::step::Step;
use engine::{CHECKS, WindowListing};
use std::ops::Range;

/// Formulas of the checks, with local variables for their values.
pub(crate) struct Checks<'a> {
    conditions: Body<'a>,
    switches: Body<'a>,
    timed: Body<'a>,
    compared: Body<'a>,
    slopes: Body<'a>,
    /// Required truth of each condition: 0 if it is armed.
    pub armed: Vec<Local>,
    truths: Vec<Local>,
    /// Condition that a check has failed, in code for pairs.
    pub failed: Local,
    held: Vec<Local>,
    found: Vec<Local>,
    /// Timed switches at both ends.
    times: [Vec<Local>; 2],
    /// Compared values, then their rates of change, at both ends.
    ends: [Vec<Local>; 2],
    /// Compared values at the moments of [`CHECKS`].
    between: [Vec<Local>; 2],
    probe: Vec<Local>,
    /// States on which compared values depend.
    probed: Vec<Range<usize>>,
}

impl<'a> Checks<'a> {
    pub fn load(window: &'a WindowListing, order: &States, sink: &mut Sink) -> Self {
        let layout = window.layout;
        let mut number = 0;
        let [conditions, switches, timed, compared, slopes] = window.formulas.each_ref().map(|formulas| {
            number += 1;
            Body::of_formulas(formulas, &order.index, layout.formula(number - 1), sink)
        });
        let mut list = |place: usize, count: usize| -> Vec<Local> {
            let locals = sink.locals(count);
            for (number, &local) in locals.iter().enumerate() {
                sink.load(place + number);
                sink.set(local);
            }
            locals
        };
        let armed = list(layout.armed(), layout.events);
        let held = list(layout.held(), layout.switches);
        let low = list(layout.values(), 2 * layout.compared);
        let timed_count = window.formulas[2].roots.len();
        let probed = order.all_that(|k| compared.reads(k));
        Self {
            conditions,
            switches,
            timed,
            compared,
            slopes,
            armed,
            truths: sink.locals(layout.events),
            failed: sink.local(),
            held,
            found: sink.locals(layout.switches),
            times: std::array::from_fn(|_| sink.locals(timed_count)),
            ends: [low, sink.locals(2 * layout.compared)],
            between: std::array::from_fn(|_| sink.locals(layout.compared)),
            probe: sink.list(if layout.compared > 0 { layout.states } else { 0 }),
            probed,
        }
    }

    /// Compared values and their rates of change at the end of the last interval.
    pub fn values(&self) -> &[Local] {
        &self.ends[0]
    }

    /// Checks the interval from the time that `step` has reached to `until` with the state `next`.
    pub fn check(&self, sink: &mut Sink, step: &Step, until: Local, next: &[Local]) {
        let [before, after] = &self.times;
        self.timed.evaluate_at(sink, step.time, &step.present, before);
        self.timed.evaluate_at(sink, until, &step.present, after);
        for (&before, &after) in before.iter().zip(after) {
            sink.get(before);
            sink.get(after);
            sink.not_equal();
            self.reject(sink);
        }
        self.search(sink, step, until, next);
        self.conditions.evaluate_at(sink, until, next, &self.truths);
        for (&armed, &truth) in self.armed.iter().zip(&self.truths) {
            for value in [armed, truth] {
                sink.get(value);
                sink.constant(0.0);
                sink.not_equal();
            }
            match sink.values() {
                // One of both is true: armed and false, or disarmed and still true.
                Values::Numbers => drop(sink.instructions().i32_eq()),
                // Runs side by side arm events whose conditions have become false.
                Values::Pairs => sink.both(),
            }
            self.reject(sink);
        }
        self.switches.evaluate_at(sink, until, next, &self.found);
        for (&held, &found) in self.held.iter().zip(&self.found) {
            sink.get(held);
            sink.get(found);
            sink.not_equal();
            self.reject(sink);
        }
    }

    /// Pops the condition that a check fails, where the code leaves; runs side by side that fail are marked.
    fn reject(&self, sink: &mut Sink) {
        match sink.values() {
            Values::Numbers => sink.leave_if(),
            Values::Pairs => {
                sink.get(self.failed);
                sink.either();
                sink.set(self.failed);
            }
        }
    }

    /// Goes on to the next interval after the one that was checked.
    pub fn pass(&self, sink: &mut Sink, condition: Where) {
        let [low, high] = &self.ends;
        for (&low, &high) in low.iter().zip(high) {
            sink.get(high);
            sink.assign(low, condition);
        }
        if sink.values() == Values::Pairs {
            for (&armed, &truth) in self.armed.iter().zip(&self.truths) {
                sink.get(truth);
                sink.constant(0.0);
                sink.equal();
                sink.truth();
                sink.assign(armed, condition);
            }
        }
    }

    /// Leaves if compared values change their signs more than once, or must be searched in parts of the interval.
    fn search(&self, sink: &mut Sink, step: &Step, until: Local, next: &[Local]) {
        let [low, high] = &self.ends;
        if low.is_empty() {
            return;
        }
        let [size, moment] = std::array::from_fn(|_| sink.local());
        let slopes: [Local; 2] = std::array::from_fn(|_| sink.local());
        self.slopes.evaluate_at(sink, until, next, high);
        sink.get(until);
        sink.get(step.time);
        sink.subtract();
        sink.set(size);
        for (part, values) in CHECKS.into_iter().zip(&self.between) {
            sink.get(step.time);
            sink.constant(part);
            sink.get(size);
            sink.multiply();
            sink.add();
            sink.set(moment);
            step.state_at(sink, moment, &self.probe, &self.probed);
            self.compared.evaluate_at(sink, moment, &self.probe, values);
        }
        let count = low.len() / 2;
        let [first, second] = &self.between;
        sink.constant(0.0);
        for number in 0..count {
            for (&slope, end) in slopes.iter().zip([low, high]) {
                sink.get(size);
                sink.get(end[count + number]);
                sink.multiply();
                sink.set(slope);
            }
            let [leaving, arriving] = slopes;
            let operands = [low[number], high[number], leaving, arriving, first[number], second[number]];
            sink.call_at(Function::SignChanges, &operands);
            sink.add();
        }
        // Between two changes of sign there would be a moment to look at; the comparison also covers NaN.
        sink.constant(1.0);
        sink.less_or_equal();
        sink.negate_condition();
        self.reject(sink);
    }
}
