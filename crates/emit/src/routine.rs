//! Formulas with many operations as functions that work on registers in the block. Runs of equal operations whose registers are
//! consecutive, as the engine makes them of equal parts of a model, are loops. What a single operation or loop reads is computed where it is
//! read, and not kept in the block.

use crate::calls::Calls;
use crate::operation::operation;
use crate::runs::{Run, Runs};
use crate::sink::lists::{LEAST, ranges};
use crate::sink::{Local, Sink, Values};
use engine::{Line, Register};
use wasm_encoder::Function;

/// Maximum number of operations of a function, those of a loop counted once. Browsers optimize a function as a whole, in more than linear
/// time.
const MOST: usize = 1000;

/// Functions without result that compute `lines` one after the other on registers from number `first` of the block on. `roots`: registers
/// that are read afterwards.
pub(crate) fn functions(lines: &[Line], roots: &[Register], first: usize, calls: &Calls) -> Vec<Function> {
    let runs = Runs::of(lines, roots);
    let mut functions = Vec::new();
    let mut sink = Sink::new(Values::Numbers, calls, Some(0));
    let mut operations = 0;
    for run in &runs.list {
        let kept =
            ranges(run.count, |a, b| runs.is_kept(run.to + a as Register) == runs.is_kept(run.to + b as Register));
        for range in kept {
            if !runs.is_kept(run.to + range.start as Register) {
                continue;
            }
            if operations >= MOST {
                functions
                    .push(std::mem::replace(&mut sink, Sink::new(Values::Numbers, calls, Some(0))).finish_routine());
                operations = 0;
            }
            let code = Code { runs: &runs, run, first };
            operations += if range.len() < LEAST { range.len() * run.operations } else { run.operations };
            sink.once(|sink| code.compute(sink, range.start, range.len()));
        }
    }
    functions.push(sink.finish_routine());
    functions
}

/// Code of a run.
struct Code<'a> {
    runs: &'a Runs,
    run: &'a Run,
    /// Place of register 0.
    first: usize,
}

/// Registers whose values are in local variables.
type Known = Vec<(Register, Local)>;

impl Code<'_> {
    /// Computes `count` elements from `start` on.
    fn compute(&self, sink: &mut Sink, start: usize, count: usize) {
        let mut constants = Known::new();
        if count >= LEAST {
            self.load_constants(sink, self.run, &mut constants, start);
        }
        sink.each_in(0..count, |sink, k| {
            let mut known = constants.clone();
            let to = self.place(self.run.to + (start + k) as Register);
            self.element(sink, self.run, start + k, to, &mut known);
        });
    }

    /// Loads the registers that all elements read, before a loop.
    fn load_constants(&self, sink: &mut Sink, run: &Run, constants: &mut Known, element: usize) {
        for (operand, stride) in run.operands() {
            let register = operand + (stride * element) as Register;
            if stride == 0 {
                if constants.iter().all(|known| known.0 != operand) {
                    let constant = sink.local();
                    sink.get(self.place(operand));
                    sink.set(constant);
                    constants.push((operand, constant));
                }
            } else if let Some((run, element)) = self.runs.computed_where_read(register) {
                self.load_constants(sink, run, constants, element);
            }
        }
    }

    /// Computes an element of a run, which is kept in `to`.
    fn element(&self, sink: &mut Sink, run: &Run, element: usize, to: Local, known: &mut Known) {
        let mut operands = [to; 3];
        for (place, (operand, stride)) in operands.iter_mut().zip(run.operands()) {
            *place = self.operand(sink, operand + (stride * element) as Register, known);
        }
        operation(sink, run.operation, operands, to);
    }

    /// Where the value of a register is, which is computed if it is not kept.
    fn operand(&self, sink: &mut Sink, register: Register, known: &mut Known) -> Local {
        if let Some((_, local)) = known.iter().find(|known| known.0 == register) {
            return *local;
        }
        let Some((run, element)) = self.runs.computed_where_read(register) else { return self.place(register) };
        let local = sink.local();
        self.element(sink, run, element, local, known);
        known.push((register, local));
        local
    }

    fn place(&self, register: Register) -> Local {
        Local::Place(self.first + register as usize)
    }
}
