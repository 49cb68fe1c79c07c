//! Instructions of the function `run` in the making.

use crate::calls::Calls;
use crate::function::Function;
use wasm_encoder::{BlockType, InstructionSink, MemArg, ValType};

/// Index of a local variable with a value: a floating-point number, or one for each of two runs.
pub(crate) type Local = u32;

/// Kind of the values of a function.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Values {
    /// Floating-point numbers.
    Numbers,
    /// Pairs of floating-point numbers, on which the same operations are done.
    Pairs,
}

/// Address of the block in bytes, a parameter of `run`; in code for pairs, of the numbers of the pair.
const BLOCK: u32 = 0;
/// Number of steps to make, a parameter of `run`.
const COUNT: u32 = 1;
/// Number of steps made.
const MADE: u32 = 2;
/// Address of the row of the step, relative to that of row 0 in the block.
const ROW: u32 = 3;
/// Address of the record of the last step, relative to that of record 0 in the block.
const RECORD: u32 = 4;
/// Number of pairs whose step is made.
const PAIR: u32 = 5;
/// 1 if a run of a pair has paused.
const PAUSED: u32 = 6;
/// First local variable with a value.
const FIRST_LOCAL: u32 = 7;

/// Number of blocks, loops and conditions around the instructions in one of these.
pub(crate) type Label = u32;

/// Block around the loop of [`Sink::begin_loop`].
const LOOP: Label = 1;

/// Instructions of `run`, its local variables and the functions that it calls. Values are passed on the stack: methods
/// that compute push one value and pop their operands.
#[derive(Debug)]
pub(crate) struct Sink<'a> {
    values: Values,
    code: Vec<u8>,
    locals: u32,
    calls: &'a Calls,
    depth: Label,
}

impl<'a> Sink<'a> {
    /// Begins the function.
    pub fn new(values: Values, calls: &'a Calls) -> Self {
        Self { values, code: Vec::new(), locals: 0, calls, depth: 0 }
    }

    /// Kind of its values.
    pub fn values(&self) -> Values {
        self.values
    }

    /// Instructions of the encoder.
    pub fn instructions(&mut self) -> InstructionSink<'_> {
        InstructionSink::new(&mut self.code)
    }

    /// A new local variable.
    pub fn local(&mut self) -> Local {
        self.locals += 1;
        FIRST_LOCAL + self.locals - 1
    }

    /// New local variables.
    pub fn locals(&mut self, count: usize) -> Vec<Local> {
        (0..count).map(|_| self.local()).collect()
    }

    pub fn get(&mut self, local: Local) {
        self.instructions().local_get(local);
    }

    pub fn set(&mut self, local: Local) {
        self.instructions().local_set(local);
    }

    pub fn constant(&mut self, value: f64) {
        match self.values {
            Values::Numbers => drop(self.instructions().f64_const(value.into())),
            Values::Pairs => {
                let bits = u128::from(value.to_bits());
                self.instructions().v128_const((bits | bits << 64) as i128);
            }
        }
    }

    /// Pushes number `place` of the block.
    pub fn load(&mut self, place: usize) {
        let address = self.at(place);
        match self.values {
            Values::Numbers => drop(self.instructions().local_get(BLOCK).f64_load(address)),
            Values::Pairs => drop(self.instructions().local_get(BLOCK).v128_load(address)),
        }
    }

    /// Stores a local variable as number `place` of the block.
    pub fn store(&mut self, place: usize, local: Local) {
        self.instructions().local_get(BLOCK);
        self.store_at(place, local);
    }

    /// Stores a local variable as number `place` of the block, counted in the row of the step.
    pub fn store_in_row(&mut self, place: usize, local: Local) {
        self.instructions().local_get(BLOCK).local_get(ROW).i32_add();
        self.store_at(place, local);
    }

    /// Stores a local variable as number `place` of the block, counted in the record of the last step.
    pub fn store_in_record(&mut self, place: usize, local: Local) {
        self.instructions().local_get(BLOCK).local_get(RECORD).i32_add();
        self.store_at(place, local);
    }

    /// Stores a local variable as number `place`, counted from the address on the stack.
    fn store_at(&mut self, place: usize, local: Local) {
        let address = self.at(place);
        match self.values {
            Values::Numbers => drop(self.instructions().local_get(local).f64_store(address)),
            Values::Pairs => drop(self.instructions().local_get(local).v128_store(address)),
        }
    }

    /// Address of number `place`, relative to a base.
    fn at(&self, place: usize) -> MemArg {
        // Pairs are aligned as numbers, too.
        MemArg { offset: (place * self.size()) as u64, align: 3, memory_index: 0 }
    }

    /// Size of a value in bytes.
    fn size(&self) -> usize {
        match self.values {
            Values::Numbers => 8,
            Values::Pairs => 16,
        }
    }

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
        self.instructions().local_get(local).f64_const(1.0.into()).f64_add().local_set(local);
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

    /// Pushes the value of a function at local variables.
    pub fn call_at(&mut self, function: Function, operands: &[Local]) {
        let number = self.calls.number(function);
        match self.values {
            Values::Numbers => {
                operands.iter().for_each(|&operand| self.get(operand));
                self.instructions().call(number);
            }
            Values::Pairs => {
                for lane in [0, 1] {
                    for &operand in operands {
                        self.instructions().local_get(operand).f64x2_extract_lane(lane);
                    }
                    self.instructions().call(number);
                    match lane {
                        0 => self.instructions().f64x2_splat(),
                        _ => self.instructions().f64x2_replace_lane(lane),
                    };
                }
            }
        }
    }

    /// Pushes the number of steps made.
    pub fn made(&mut self) {
        self.instructions().local_get(MADE).f64_convert_i32_u();
        if self.values == Values::Pairs {
            self.instructions().f64x2_splat();
        }
    }

    /// Repeats `step` until the given number of steps is made or a state is not finite; `states` are the states after the
    /// step, one row apart in the block.
    pub fn repeat(&mut self, states: &[Local], step: impl FnOnce(&mut Self)) {
        self.instructions().loop_(BlockType::Empty);
        step(self);
        // x - x is 0 for finite numbers only.
        self.instructions().i32_const(1);
        for &state in states {
            self.instructions().local_get(state).local_get(state).f64_sub().f64_const(0.0.into()).f64_eq().i32_and();
        }
        self.instructions().if_(BlockType::Empty);
        self.instructions().local_get(ROW).i32_const(8 * states.len() as i32).i32_add().local_set(ROW);
        self.instructions().local_get(MADE).i32_const(1).i32_add().local_tee(MADE);
        self.instructions().local_get(COUNT).i32_lt_u().br_if(1).end().end();
    }

    /// Repeats `step` for each pair of `pairs`, whose numbers follow one another, and this until the given number of steps is made.
    /// `numbers`: number of places of a pair; `row`: number of places in a row.
    pub fn repeat_for_pairs(&mut self, pairs: usize, numbers: usize, row: usize, step: impl FnOnce(&mut Self)) {
        let size = self.size();
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
        let bytes = (self.size() * length) as i32;
        self.instructions().local_get(row).f64x2_extract_lane(run).i32_trunc_sat_f64_u();
        self.instructions().i32_const(bytes).i32_mul().local_get(BLOCK).i32_add().local_set(ROW);
        for (number, &value) in values.iter().enumerate() {
            let address =
                MemArg { offset: (self.size() * (place + number) + 8 * usize::from(run)) as u64, ..self.at(0) };
            self.instructions().local_get(ROW).local_get(value).v128_store64_lane(address, run);
        }
    }

    /// Pushes the condition that a comparison holds of a run of a pair.
    pub fn holds_of(&mut self, condition: Local, run: u8) {
        self.instructions().local_get(condition).i32x4_extract_lane(2 * run);
    }

    /// The function `run`, which returns the number of steps or rows made.
    pub fn finish(mut self) -> wasm_encoder::Function {
        self.instructions().local_get(MADE).end();
        let value = match self.values {
            Values::Numbers => ValType::F64,
            Values::Pairs => ValType::V128,
        };
        let locals = [(FIRST_LOCAL - MADE, ValType::I32), (self.locals, value)];
        let mut run = wasm_encoder::Function::new(locals);
        run.raw(self.code);
        run
    }
}
