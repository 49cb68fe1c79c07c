//! Blocks, loops and conditions, and what loops over steps, rows and runs count.

use super::{BLOCK, COUNT, FINITE, Label, Local, MADE, PAIR, PAUSED, RECORD, ROW, Sink, Values};
use wasm_encoder::{BlockType, MemArg};

/// Block around the loop of [`Sink::begin_loop`].
const LOOP: Label = 1;

impl Sink<'_> {
    /// Goes on to the next record, `length` numbers further.
    pub fn next_record(&mut self, length: usize) {
        self.instructions().local_get(RECORD).i32_const(8 * length as i32).i32_add().local_set(RECORD);
    }

    /// Counts a row, and goes on to the next one, `length` numbers further.
    pub fn next_row(&mut self, length: usize) {
        self.instructions().local_get(ROW).i32_const(8 * length as i32).i32_add().local_set(ROW);
        self.instructions().local_get(MADE).i32_const(1).i32_add().local_set(MADE);
    }

    /// Adds 1 to a local variable.
    pub fn increase(&mut self, local: Local) {
        self.get(local);
        self.constant(1.0);
        self.add();
        self.set(local);
    }

    /// Pushes the number of steps or rows to make.
    pub fn count(&mut self) {
        self.instructions().local_get(COUNT);
    }

    pub fn begin_block(&mut self) {
        self.depth += 1;
        self.instructions().block(BlockType::Empty);
    }

    pub fn begin_repeat(&mut self) {
        self.depth += 1;
        self.instructions().loop_(BlockType::Empty);
    }

    /// Begins the instructions for the case that the number on the stack is not 0.
    pub fn begin_if(&mut self) {
        self.depth += 1;
        self.instructions().if_(BlockType::Empty);
    }

    /// Begins the instructions for the other case.
    pub fn otherwise(&mut self) {
        self.instructions().else_();
    }

    /// Ends the innermost block, loop or condition.
    pub fn end(&mut self) {
        self.depth -= 1;
        self.instructions().end();
    }

    /// The innermost block, loop or condition.
    pub fn label(&self) -> Label {
        self.depth
    }

    /// Goes to the end of a block or condition, or to the begin of a loop.
    pub fn branch(&mut self, label: Label) {
        let outwards = self.depth - label;
        self.instructions().br(outwards);
    }

    /// [`Sink::branch`] if the number on the stack is not 0.
    pub fn branch_if(&mut self, label: Label) {
        let outwards = self.depth - label;
        self.instructions().br_if(outwards);
    }

    /// Begins the loop that only [`Sink::leave`] and its like end.
    pub fn begin_loop(&mut self) {
        self.begin_block();
        self.begin_repeat();
    }

    pub fn end_loop(&mut self) {
        self.branch(LOOP + 1);
        self.end();
        self.end();
    }

    /// Leaves the loop.
    pub fn leave(&mut self) {
        self.branch(LOOP);
    }

    /// Leaves the loop if the number on the stack is not 0.
    pub fn leave_if(&mut self) {
        self.branch_if(LOOP);
    }

    /// Leaves the loop if all rows are made.
    pub fn leave_if_all_made(&mut self) {
        self.instructions().local_get(MADE).local_get(COUNT).i32_ge_u();
        self.leave_if();
    }

    /// Repeats `step` until the given number of steps is made or a state is not finite; `states` are the states after the
    /// step, one row apart in the block.
    pub fn repeat(&mut self, states: &[Local], step: impl FnOnce(&mut Self)) {
        self.begin_repeat();
        let again = self.label();
        step(self);
        self.instructions().i32_const(1).local_set(FINITE);
        let not_finite = self.in_block().then(|| self.local_pair());
        if let Some(not_finite) = not_finite {
            self.instructions().v128_const(0);
            self.set(not_finite);
        }
        self.each_in(0..states.len(), |sink, k| {
            // x - x is 0 for finite numbers only.
            sink.get(states[k]);
            sink.get(states[k]);
            sink.subtract();
            match not_finite.filter(|_| sink.values == Values::Pairs) {
                None => {
                    sink.constant(0.0);
                    sink.equal();
                    sink.instructions().local_get(FINITE).i32_and().local_set(FINITE);
                }
                Some(not_finite) => {
                    sink.get(not_finite);
                    sink.either();
                    sink.set(not_finite);
                }
            }
        });
        if let Some(not_finite) = not_finite {
            self.get(not_finite);
            self.instructions().v128_any_true().i32_eqz();
            self.instructions().local_get(FINITE).i32_and().local_set(FINITE);
        }
        self.instructions().local_get(FINITE);
        self.begin_if();
        self.next_row(states.len());
        self.instructions().local_get(MADE).local_get(COUNT).i32_lt_u();
        self.branch_if(again);
        self.end();
        self.end();
    }

    /// Repeats `step` for each pair of `pairs`, whose numbers follow one another, and this until the given number of steps is made.
    /// `numbers`: number of places of a pair; `row`: number of places in a row.
    pub fn repeat_for_pairs(&mut self, pairs: usize, numbers: usize, row: usize, step: impl FnOnce(&mut Self)) {
        let size = self.size;
        let bytes = |numbers: usize| (size * numbers) as i32;
        self.depth += 2;
        self.instructions().loop_(BlockType::Empty).i32_const(0).local_set(PAIR).loop_(BlockType::Empty);
        step(self);
        self.instructions().local_get(BLOCK).i32_const(bytes(numbers)).i32_add().local_set(BLOCK);
        self.instructions().local_get(PAIR).i32_const(1).i32_add().local_tee(PAIR);
        self.instructions().i32_const(pairs as i32).i32_lt_u().br_if(0).end();
        self.instructions().local_get(BLOCK).i32_const(bytes(pairs * numbers)).i32_sub().local_set(BLOCK);
        self.instructions().local_get(ROW).i32_const(bytes(row)).i32_add().local_set(ROW);
        self.instructions().local_get(MADE).i32_const(1).i32_add().local_tee(MADE);
        self.instructions().local_get(COUNT).i32_lt_u().local_get(PAUSED).i32_eqz().i32_and().br_if(0).end();
        self.depth -= 2;
    }

    /// Pushes the condition that a comparison of pairs, which it pops, holds of any run.
    pub fn any(&mut self) {
        self.instructions().v128_any_true();
    }

    /// Ends [`Sink::repeat_for_pairs`] after the last pair.
    pub fn pause(&mut self) {
        self.instructions().i32_const(1).local_set(PAUSED);
    }

    /// Stores the values of one run of a pair from `place` on, counted in a row. `row`: number of the row in the first values of the
    /// block, for each run; `length`: number of places in a row.
    pub fn store_run_in_row(&mut self, run: u8, place: usize, (row, length): (Local, usize), values: &[Local]) {
        let bytes = (self.size * length) as i32;
        self.get(row);
        self.instructions().f64x2_extract_lane(run).i32_trunc_sat_f64_u();
        self.instructions().i32_const(bytes).i32_mul().local_get(BLOCK).i32_add().local_set(ROW);
        for (number, &value) in values.iter().enumerate() {
            let address = MemArg { offset: (self.size * (place + number) + 8 * usize::from(run)) as u64, ..self.at(0) };
            self.instructions().local_get(ROW);
            self.get(value);
            self.instructions().v128_store64_lane(address, run);
        }
    }

    /// Pushes the condition that a comparison holds of a run of a pair.
    pub fn holds_of(&mut self, condition: Local, run: u8) {
        self.get(condition);
        self.instructions().i32x4_extract_lane(2 * run);
    }
}
