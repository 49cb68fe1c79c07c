//! Instructions of the function `run` in the making.

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
/// First local variable with a floating-point number.
const FIRST_LOCAL: u32 = 4;

/// Instructions of `run`, its local variables and the functions that it calls. Values are passed on the stack: methods
/// that compute push one value and pop their operands.
#[derive(Debug, Default)]
pub(crate) struct Sink {
    code: Vec<u8>,
    locals: u32,
    functions: Vec<Function>,
}

impl Sink {
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

    /// Calls an imported function.
    pub fn call(&mut self, function: Function) {
        let known = self.functions.iter().position(|&known| known == function);
        let number = known.unwrap_or_else(|| {
            self.functions.push(function);
            self.functions.len() - 1
        });
        self.instructions().call(number as u32);
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

    /// The function `run`, which returns the number of steps made, and the functions that it calls.
    pub fn finish(mut self) -> (wasm_encoder::Function, Vec<Function>) {
        self.instructions().local_get(MADE).end();
        let locals = [(FIRST_LOCAL - MADE, ValType::I32), (self.locals, ValType::F64)];
        let mut run = wasm_encoder::Function::new(locals);
        run.raw(self.code);
        (run, self.functions)
    }
}

/// Address of number `place`, relative to a base.
fn at(place: usize) -> MemArg {
    MemArg { offset: 8 * place as u64, align: 3, memory_index: 0 }
}
