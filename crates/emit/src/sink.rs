//! Instructions of the function `run` in the making.

use crate::calls::Calls;
use crate::function::Function;
use wasm_encoder::{BlockType, InstructionSink, MemArg, ValType};

/// Index of a local variable with a floating-point number.
pub(crate) type Local = u32;

/// Address of the block in bytes, a parameter of `run`.
const BLOCK: u32 = 0;
/// Number of steps to make, a parameter of `run`.
const COUNT: u32 = 1;
/// Number of steps made.
const MADE: u32 = 2;
/// Address of the row of the step, relative to that of row 0 in the block.
const ROW: u32 = 3;
/// Address of the record of the last step, relative to that of record 0 in the block.
const RECORD: u32 = 4;
/// First local variable with a floating-point number.
const FIRST_LOCAL: u32 = 5;

/// Number of blocks, loops and conditions around the instructions in one of these.
pub(crate) type Label = u32;

/// Block around the loop of [`Sink::begin_loop`].
const LOOP: Label = 1;

/// Instructions of `run`, its local variables and the functions that it calls. Values are passed on the stack: methods
/// that compute push one value and pop their operands.
#[derive(Debug)]
pub(crate) struct Sink<'a> {
    code: Vec<u8>,
    locals: u32,
    calls: &'a Calls,
    depth: Label,
}

impl<'a> Sink<'a> {
    /// Begins the function.
    pub fn new(calls: &'a Calls) -> Self {
        Self { code: Vec::new(), locals: 0, calls, depth: 0 }
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
        self.instructions().f64_const(value.into());
    }

    pub fn add(&mut self) {
        self.instructions().f64_add();
    }

    pub fn multiply(&mut self) {
        self.instructions().f64_mul();
    }

    /// Pushes number `place` of the block.
    pub fn load(&mut self, place: usize) {
        self.instructions().local_get(BLOCK).f64_load(at(place));
    }

    /// Stores a local variable as number `place` of the block.
    pub fn store(&mut self, place: usize, local: Local) {
        self.instructions().local_get(BLOCK).local_get(local).f64_store(at(place));
    }

    /// Stores a local variable as number `place` of the block, counted in the row of the step.
    pub fn store_in_row(&mut self, place: usize, local: Local) {
        self.instructions().local_get(BLOCK).local_get(ROW).i32_add().local_get(local).f64_store(at(place));
    }

    /// Stores a local variable as number `place` of the block, counted in the record of the last step.
    pub fn store_in_record(&mut self, place: usize, local: Local) {
        self.instructions().local_get(BLOCK).local_get(RECORD).i32_add().local_get(local).f64_store(at(place));
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

    /// Calls a function.
    pub fn call(&mut self, function: Function) {
        let number = self.calls.number(function);
        self.instructions().call(number);
    }

    /// Pushes the number of steps made.
    pub fn made(&mut self) {
        self.instructions().local_get(MADE).f64_convert_i32_u();
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

    /// The function `run`, which returns the number of steps or rows made.
    pub fn finish(mut self) -> wasm_encoder::Function {
        self.instructions().local_get(MADE).end();
        let locals = [(FIRST_LOCAL - MADE, ValType::I32), (self.locals, ValType::F64)];
        let mut run = wasm_encoder::Function::new(locals);
        run.raw(self.code);
        run
    }
}

/// Address of number `place`, relative to a base.
fn at(place: usize) -> MemArg {
    MemArg { offset: 8 * place as u64, align: 3, memory_index: 0 }
}
