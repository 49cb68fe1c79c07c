//! Windows of the Dormand-Prince method: steps with step control (`step.rs`), rows of the continuous solution, and the checks
//! that nothing happens between them (`checks.rs`). Each does the operations of the engine in the same order. Where an event
//! or switch could act the code returns, and the engine looks there itself.

use crate::checks::Checks;
use crate::control::Recorded;
use crate::sink::Sink;
use crate::step::Step;
use engine::{Listing, WindowListing};

/// Emits the loop over the intervals between rows and ends of steps.
pub(crate) fn intervals(listing: &Listing, window: &WindowListing, sink: &mut Sink) {
    let layout = window.layout;
    let recorded = Recorded::new(Step::load(listing, layout, sink), layout, sink);
    let (step, steps) = (&recorded.step, recorded.steps);
    let checks = Checks::load(window, sink);
    let [index, spacing, target, until, intervals] = std::array::from_fn(|_| sink.local());
    for (local, place) in [(index, layout.index()), (spacing, layout.spacing())] {
        sink.load(place);
        sink.set(local);
    }
    let next = sink.locals(layout.states);
    sink.begin_loop();
    sink.instructions().local_get(step.end).local_get(step.time).f64_le();
    sink.begin_if();
    recorded.make(sink);
    sink.end();
    sink.instructions().local_get(index).f64_const(1.0.into()).f64_add().local_get(spacing).f64_mul().local_set(target);
    sink.instructions().local_get(target).local_get(step.end).f64_min().local_set(until);
    step.state_at_end_or(sink, until, &next);
    checks.check(sink, step, until, &next);
    checks.pass(sink, None);
    for (&present, &next) in step.present.iter().zip(&next) {
        sink.get(next);
        sink.set(present);
    }
    sink.get(until);
    sink.set(step.time);
    sink.increase(intervals);
    sink.instructions().local_get(until).local_get(target).f64_eq();
    sink.begin_if();
    let row = layout.row(0);
    sink.store_in_row(row, steps);
    sink.store_in_row(row + 1, intervals);
    for (number, &value) in checks.values().iter().enumerate() {
        sink.store_in_row(row + 2 + number, value);
    }
    for (k, &state) in step.present.iter().enumerate() {
        sink.store_in_row(row + layout.row_states() + k, state);
    }
    sink.increase(index);
    sink.next_row(layout.row_len());
    sink.leave_if_all_made();
    // The rest of the room is for the steps to the next row.
    sink.get(steps);
    sink.constant(0.75 * layout.steps as f64);
    sink.instructions().f64_ge();
    sink.leave_if();
    sink.end();
    sink.end_loop();
    sink.store(layout.made(), steps);
}
