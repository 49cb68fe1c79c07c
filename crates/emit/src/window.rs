//! Windows of the Dormand-Prince method: steps with step control (`step.rs`), rows of the continuous solution, and the checks
//! that nothing happens between them (`checks.rs`). Each does the operations of the engine in the same order. Where an event
//! or switch could act the code returns, and the engine looks there itself.

use crate::checks::Checks;
use crate::control::Recorded;
use crate::sink::Sink;
use crate::sink::rows::Origin;
use crate::step::Step;
use engine::{Listing, WindowListing};

/// Emits the loop over the intervals between rows and ends of steps.
pub(crate) fn intervals(listing: &Listing, window: &WindowListing, sink: &mut Sink) {
    let layout = window.layout;
    let recorded = Recorded::new(Step::load(listing, layout, sink), layout, sink);
    let (step, steps) = (&recorded.step, recorded.steps);
    let checks = Checks::load(window, &step.order, sink);
    let [index, spacing, target, until, intervals] = std::array::from_fn(|_| sink.local());
    for (local, place) in [(index, layout.index()), (spacing, layout.spacing())] {
        sink.load(place);
        sink.set(local);
    }
    let next = sink.list(layout.states);
    sink.begin_loop();
    sink.get(step.end);
    sink.get(step.time);
    sink.less_or_equal();
    sink.begin_if();
    recorded.make(sink);
    sink.end();
    sink.get(index);
    sink.constant(1.0);
    sink.add();
    sink.get(spacing);
    sink.multiply();
    sink.set(target);
    sink.get(target);
    sink.get(step.end);
    sink.minimum();
    sink.set(until);
    step.state_at_end_or(sink, until, &next);
    checks.check(sink, step, until, &next);
    checks.pass(sink, None);
    sink.each(&step.order.all, |sink, k| {
        sink.get(next[k]);
        sink.set(step.present[k]);
    });
    sink.get(until);
    sink.set(step.time);
    sink.increase(intervals);
    sink.get(until);
    sink.get(target);
    sink.equal();
    sink.begin_if();
    let row = layout.row(0);
    for (number, &value) in [steps, intervals].iter().chain(checks.values()).enumerate() {
        sink.address(Origin::Row);
        sink.store_at(row + number, value);
    }
    let states = (row + layout.row_states(), step.present.as_slice());
    sink.store_lists(&step.order.rows, &step.order.index, Origin::Row, &[states]);
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
