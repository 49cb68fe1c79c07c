//! Checks that nothing happens in an interval: no timed switch changes, no compared values allow an event or switch between
//! the ends, and all conditions and switches are the same at the end. Where one fails the code leaves the window.

use crate::body::Body;
use crate::function::Function;
use crate::sink::{Local, Sink};
use crate::step::Step;
use engine::{CHECKS, WindowListing};

/// Formulas of the checks, with local variables for their values.
pub(crate) struct Checks<'a> {
    conditions: Body<'a>,
    switches: Body<'a>,
    timed: Body<'a>,
    compared: Body<'a>,
    slopes: Body<'a>,
    /// Required truth of each condition: 0 if it is armed.
    armed: Vec<Local>,
    truths: Vec<Local>,
    held: Vec<Local>,
    found: Vec<Local>,
    /// Timed switches at both ends.
    times: [Vec<Local>; 2],
    /// Compared values, then their rates of change, at both ends.
    ends: [Vec<Local>; 2],
    /// Compared values at the moments of [`CHECKS`].
    between: [Vec<Local>; 2],
    probe: Vec<Local>,
}

impl<'a> Checks<'a> {
    pub fn load(window: &'a WindowListing, sink: &mut Sink) -> Self {
        let layout = window.layout;
        let mut number = 0;
        let [conditions, switches, timed, compared, slopes] = window.formulas.each_ref().map(|formulas| {
            number += 1;
            Body::of_formulas(formulas, layout.states, layout.formula(number - 1), sink)
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
        Self {
            conditions,
            switches,
            timed,
            compared,
            slopes,
            armed,
            truths: sink.locals(layout.events),
            held,
            found: sink.locals(layout.switches),
            times: std::array::from_fn(|_| sink.locals(timed_count)),
            ends: [low, sink.locals(2 * layout.compared)],
            between: std::array::from_fn(|_| sink.locals(layout.compared)),
            probe: sink.locals(if layout.compared > 0 { layout.states } else { 0 }),
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
            sink.instructions().local_get(before).local_get(after).f64_ne();
            sink.leave_if();
        }
        self.search(sink, step, until, next);
        self.conditions.evaluate_at(sink, until, next, &self.truths);
        for (&armed, &truth) in self.armed.iter().zip(&self.truths) {
            // One of both is true: armed and false, or disarmed and still true.
            sink.instructions().local_get(armed).f64_const(0.0.into()).f64_ne();
            sink.instructions().local_get(truth).f64_const(0.0.into()).f64_ne().i32_eq();
            sink.leave_if();
        }
        self.switches.evaluate_at(sink, until, next, &self.found);
        for (&held, &found) in self.held.iter().zip(&self.found) {
            sink.instructions().local_get(held).local_get(found).f64_ne();
            sink.leave_if();
        }
        let [low, high] = &self.ends;
        for (&low, &high) in low.iter().zip(high) {
            sink.get(high);
            sink.set(low);
        }
    }

    /// Leaves if compared values change their signs more than once, or must be searched in parts of the interval.
    fn search(&self, sink: &mut Sink, step: &Step, until: Local, next: &[Local]) {
        let [low, high] = &self.ends;
        if low.is_empty() {
            return;
        }
        let [size, moment] = std::array::from_fn(|_| sink.local());
        self.slopes.evaluate_at(sink, until, next, high);
        sink.instructions().local_get(until).local_get(step.time).f64_sub().local_set(size);
        for (part, values) in CHECKS.into_iter().zip(&self.between) {
            sink.get(step.time);
            sink.instructions().f64_const(part.into()).local_get(size).f64_mul().f64_add().local_set(moment);
            step.state_at(sink, moment, &self.probe);
            self.compared.evaluate_at(sink, moment, &self.probe, values);
        }
        let count = low.len() / 2;
        let [first, second] = &self.between;
        sink.constant(0.0);
        for number in 0..count {
            sink.get(low[number]);
            sink.get(high[number]);
            for end in [low, high] {
                sink.instructions().local_get(size).local_get(end[count + number]).f64_mul();
            }
            sink.get(first[number]);
            sink.get(second[number]);
            sink.call(Function::SignChanges);
            sink.add();
        }
        // Between two changes of sign there would be a moment to look at; the comparison also covers NaN.
        sink.instructions().f64_const(1.0.into()).f64_le().i32_eqz();
        sink.leave_if();
    }
}
