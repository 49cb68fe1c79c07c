//! Step control of a single run, with a record of each step.

use crate::sink::rows::Origin;
use crate::sink::{Local, Sink};
use crate::step::Step;
use engine::WindowLayout;

/// Steps that are recorded.
pub(crate) struct Recorded<'a> {
    pub step: Step<'a>,
    /// Number of steps made, and of their attempts.
    pub steps: Local,
    attempts: Local,
    layout: WindowLayout,
}

impl<'a> Recorded<'a> {
    pub fn new(step: Step<'a>, layout: WindowLayout, sink: &mut Sink) -> Self {
        let [attempts, steps] = std::array::from_fn(|_| sink.local());
        Self { step, steps, attempts, layout }
    }

    /// Makes a step from the end of the last one, or the single attempt of the size given.
    pub fn make(&self, sink: &mut Sink) {
        let Self { step, steps, attempts, layout } = self;
        let most = sink.local();
        sink.count();
        sink.begin_if();
        sink.get(*steps);
        sink.constant(layout.steps as f64);
        sink.instructions().f64_ge();
        sink.leave_if();
        sink.get(step.proposed);
        sink.get(step.longest);
        sink.minimum();
        sink.set(step.size);
        sink.end();
        sink.constant(10.0);
        sink.set(most);
        sink.begin_block();
        let accepted = sink.label();
        sink.begin_repeat();
        let again = sink.label();
        sink.increase(*attempts);
        step.attempt(sink);
        sink.count();
        sink.instructions().i32_eqz();
        sink.branch_if(accepted);
        step.find_error(sink);
        sink.get(step.found);
        sink.constant(1.0);
        sink.less_or_equal();
        sink.begin_if();
        step.find_growth(sink, most);
        sink.branch(accepted);
        sink.end();
        step.shrink(sink, None, |sink| sink.leave_if());
        sink.constant(1.0);
        sink.set(most);
        sink.branch(again);
        sink.end();
        sink.end();
        sink.increase(*steps);
        step.accept(sink, None);
        self.record(sink);
    }

    /// Stores the step as the next record. Leaves after a single attempt.
    fn record(&self, sink: &mut Sink) {
        let Self { step, attempts, layout, .. } = self;
        let record = layout.record(0);
        sink.next_record(layout.record_len());
        let (rows, index) = (&step.order.moving_rows, &step.order.index);
        let dense = step.dense.iter().enumerate().map(|(degree, list)| (layout.dense(degree), list));
        let others = [(layout.to(), &step.to), (layout.peaks(), &step.peaks), (layout.rates(), &step.rates[0])];
        let lists: Vec<_> = dense.chain(others).map(|(place, list)| (record + place, list.as_slice())).collect();
        sink.store_lists(rows, index, Origin::Record, &lists);
        for (place, local) in step.clock().into_iter().chain([*attempts]).enumerate() {
            sink.address(Origin::Record);
            sink.store_at(record + place, local);
        }
        sink.count();
        sink.instructions().i32_eqz();
        sink.begin_if();
        sink.store_lists(rows, index, Origin::Block, &[(layout.error(), &step.errors)]);
        sink.leave();
        sink.end();
    }
}
