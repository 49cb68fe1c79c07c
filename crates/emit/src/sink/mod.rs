//! Instructions of the function `run` in the making.

mod flow;
pub(crate) mod lists;
pub(crate) mod rows;

use crate::calls::Calls;
use crate::function::Function;
use std::ops::Range;
use wasm_encoder::{InstructionSink, MemArg, ValType};

/// Where a value is kept: a floating-point number, or a pair of numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Local {
    /// A local variable: its index.
    Variable(u32),
    /// A number of the block: its place. In a loop over lists ([`Sink::each`]) that of the first element.
    Place(usize),
}

/// Kind of the values of a function.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Values {
    /// Floating-point numbers.
    Numbers,
    /// Pairs of floating-point numbers, on which the same operations are done: of two runs, or of two elements of lists.
    Pairs,
}

/// Address of the block in bytes, a parameter of `run`; in code for pairs of runs, of the numbers of the pair.
pub(crate) const BLOCK: u32 = 0;
/// Number of steps to make, a parameter of `run`.
pub(crate) const COUNT: u32 = 1;
/// Number of steps made.
pub(crate) const MADE: u32 = 2;
/// Address of the row of the step, relative to that of row 0 in the block.
pub(crate) const ROW: u32 = 3;
/// Address of the record of the last step, relative to that of record 0 in the block.
pub(crate) const RECORD: u32 = 4;
/// Number of pairs whose step is made.
pub(crate) const PAIR: u32 = 5;
/// 1 if a run of a pair has paused.
pub(crate) const PAUSED: u32 = 6;
/// Address of the block, increased by the offset of the elements of lists that a loop has reached.
pub(crate) const ELEMENT: u32 = 7;
/// 1 if all states are finite.
pub(crate) const FINITE: u32 = 8;
/// First local variable with a value.
const FIRST_LOCAL: u32 = 9;

/// Number of blocks, loops and conditions around the instructions in one of these.
pub(crate) type Label = u32;

/// Instructions of a function, its local variables and the functions that it calls. Values are passed on the stack: methods
/// that compute push one value and pop their operands.
#[derive(Debug)]
pub(crate) struct Sink<'a> {
    values: Values,
    code: Vec<u8>,
    /// Types of the local variables from [`FIRST_LOCAL`] on.
    types: Vec<ValType>,
    /// Number of those that are in use.
    used: usize,
    calls: &'a Calls,
    depth: Label,
    /// Size of a place of the block in bytes.
    size: usize,
    /// Place of the next list in the block; `None` if lists are local variables.
    lists: Option<usize>,
    /// Variable with the address from which the places of [`Local::Place`] are counted.
    base: u32,
    /// Constants of pairs, with the local variables that have their values from the begin of the function on.
    constants: Vec<(f64, Local)>,
    /// Functions without result that [`Sink::call_routines`] calls, with the address of the block.
    routines: Vec<wasm_encoder::Function>,
}

impl<'a> Sink<'a> {
    /// Begins a function. `lists`: first place of the block for lists, which are local variables otherwise.
    pub fn new(values: Values, calls: &'a Calls, lists: Option<usize>) -> Self {
        let size = match values {
            Values::Numbers => 8,
            Values::Pairs => 16,
        };
        let (code, types, constants, routines) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        Self { values, code, types, used: 0, calls, depth: 0, size, lists, base: BLOCK, constants, routines }
    }

    /// Kind of its values.
    pub fn values(&self) -> Values {
        self.values
    }

    /// Functions that it may call.
    pub fn calls(&self) -> &'a Calls {
        self.calls
    }

    /// Adds functions without result, and returns their numbers for [`Sink::call_routines`].
    pub fn add_routines(&mut self, routines: Vec<wasm_encoder::Function>) -> Range<usize> {
        let before = self.routines.len();
        self.routines.extend(routines);
        before..self.routines.len()
    }

    /// Removes and returns the functions that were added.
    pub fn take_routines(&mut self) -> Vec<wasm_encoder::Function> {
        std::mem::take(&mut self.routines)
    }

    /// Instructions of the encoder.
    pub fn instructions(&mut self) -> InstructionSink<'_> {
        InstructionSink::new(&mut self.code)
    }

    /// A new local variable.
    pub fn local(&mut self) -> Local {
        let kind = self.kind();
        let is_constant = |used: usize| {
            let local = Local::Variable(FIRST_LOCAL + used as u32);
            self.constants.iter().any(|constant| constant.1 == local)
        };
        while self.types.get(self.used).is_some_and(|known| *known != kind) || is_constant(self.used) {
            self.used += 1;
        }
        if self.used == self.types.len() {
            self.types.push(kind);
        }
        self.used += 1;
        Local::Variable(FIRST_LOCAL + self.used as u32 - 1)
    }

    /// A new local variable for a pair of elements.
    pub fn local_pair(&mut self) -> Local {
        let values = std::mem::replace(&mut self.values, Values::Pairs);
        let local = self.local();
        self.values = values;
        local
    }

    /// New local variables.
    pub fn locals(&mut self, count: usize) -> Vec<Local> {
        (0..count).map(|_| self.local()).collect()
    }

    /// Type of its values.
    fn kind(&self) -> ValType {
        match self.values {
            Values::Numbers => ValType::F64,
            Values::Pairs => ValType::V128,
        }
    }

    pub fn get(&mut self, local: Local) {
        match local {
            Local::Variable(index) => {
                self.instructions().local_get(index);
                if self.values == Values::Pairs && self.types[(index - FIRST_LOCAL) as usize] == ValType::F64 {
                    self.instructions().f64x2_splat();
                }
            }
            Local::Place(place) => self.load_from(self.base, place),
        }
    }

    pub fn set(&mut self, local: Local) {
        match local {
            Local::Variable(index) => drop(self.instructions().local_set(index)),
            Local::Place(place) => {
                let used = self.used;
                let value = self.local();
                self.used = used;
                self.set(value);
                let base = self.base;
                self.instructions().local_get(base);
                self.store_at(place, value);
            }
        }
    }

    pub fn constant(&mut self, value: f64) {
        match self.values {
            Values::Numbers => drop(self.instructions().f64_const(value.into())),
            Values::Pairs if self.in_block() => {
                let constant = self.constant_of_function(value);
                self.get(constant);
            }
            Values::Pairs => drop(self.instructions().v128_const(pair(value))),
        }
    }

    /// A local variable with a pair of equal constants. Browsers make constants of pairs by several instructions each time, also in loops.
    fn constant_of_function(&mut self, value: f64) -> Local {
        if let Some((_, local)) = self.constants.iter().find(|constant| constant.0.to_bits() == value.to_bits()) {
            return *local;
        }
        self.types.push(ValType::V128);
        let local = Local::Variable(FIRST_LOCAL + self.types.len() as u32 - 1);
        self.constants.push((value, local));
        local
    }

    /// Pushes number `place` of the block.
    pub fn load(&mut self, place: usize) {
        self.load_from(BLOCK, place);
    }

    fn load_from(&mut self, base: u32, place: usize) {
        self.instructions().local_get(base);
        self.load_at(place);
    }

    /// Pushes number `place`, counted from the address on the stack.
    pub fn load_at(&mut self, place: usize) {
        let address = self.at(place);
        match self.values {
            Values::Numbers => drop(self.instructions().f64_load(address)),
            Values::Pairs => drop(self.instructions().v128_load(address)),
        }
    }

    /// Stores a value as number `place` of the block.
    pub fn store(&mut self, place: usize, local: Local) {
        self.instructions().local_get(BLOCK);
        self.store_at(place, local);
    }

    /// Stores a value as number `place`, counted from the address on the stack.
    pub fn store_at(&mut self, place: usize, local: Local) {
        let address = self.at(place);
        self.get(local);
        match self.values {
            Values::Numbers => drop(self.instructions().f64_store(address)),
            Values::Pairs => drop(self.instructions().v128_store(address)),
        }
    }

    /// Address of number `place`, relative to a base.
    pub fn at(&self, place: usize) -> MemArg {
        // Pairs are aligned as numbers, too.
        MemArg { offset: (place * self.size) as u64, align: 3, memory_index: 0 }
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
                        self.get(operand);
                        self.instructions().f64x2_extract_lane(lane);
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

    /// The function `run`, which returns the number of steps or rows made.
    pub fn finish(mut self) -> wasm_encoder::Function {
        self.instructions().local_get(MADE);
        self.function(COUNT)
    }

    /// A function without result.
    pub fn finish_routine(self) -> wasm_encoder::Function {
        self.function(BLOCK)
    }

    /// The function, whose last parameter is `last`.
    fn function(mut self, last: u32) -> wasm_encoder::Function {
        self.instructions().end();
        let numbers = std::iter::once((FIRST_LOCAL - 1 - last, ValType::I32));
        let values = self.types.chunk_by(PartialEq::eq).map(|types| (types.len() as u32, types[0]));
        let mut function = wasm_encoder::Function::new(numbers.chain(values).collect::<Vec<_>>());
        let mut constants = Vec::new();
        for &(value, local) in &self.constants {
            if let Local::Variable(index) = local {
                InstructionSink::new(&mut constants).v128_const(pair(value)).local_set(index);
            }
        }
        function.raw(constants.into_iter().chain(self.code));
        function
    }
}

/// Bits of two equal numbers.
fn pair(value: f64) -> i128 {
    let bits = u128::from(value.to_bits());
    (bits | bits << 64) as i128
}
