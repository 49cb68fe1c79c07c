//! Code of a routine, and the register machine that runs it. The results do not depend on the platform, to the bit: the
//! four operations and the square root are exact by IEEE 754, other functions are [`program::Unary::evaluate`] and
//! [`program::Binary::evaluate`], and no multiply-add is fused.
//!
//! Of a [`Routine`](crate::Routine), a prologue runs when a parameter changes, a body at every evaluation. It evaluates one
//! row or sixteen at a time, with the same bits. Sixteen rows, and the decompositions of a fit, are computed in the widest
//! registers of the processor ([`crate::run_wide`]), except in pages. Operations that repeat over neighbouring registers
//! become one instruction, a `Column`, and from 32 states on those of equal order stand side by side (`Equations::order`): a
//! chain of masses costs hardly more than the loop one writes by hand.

pub(crate) mod routine;

mod column;
mod columns;
mod compile;
pub(crate) mod instruction;
pub(crate) mod lines;

use column::Column;
use instruction::{Elimination, Instruction, Register, each};
use program::Interpolation;
use std::sync::Arc;

/// Register code for a set of expressions, the roots.
#[derive(Clone, Debug, Default)]
pub(crate) struct Code {
    /// Instructions that depend on parameters and initial values only.
    pub prologue: Vec<Instruction>,
    /// All other instructions.
    pub body: Vec<Instruction>,
    /// Columns of both instruction lists.
    pub columns: Vec<Column>,
    /// Linear systems of both instruction lists.
    pub systems: Vec<Elimination>,
    /// Interpolations of both instruction lists.
    pub interpolations: Vec<Arc<Interpolation>>,
    /// Register values: the independent variable, the states, then constants and results.
    pub registers: Vec<f64>,
    /// Index of each parameter, with its register.
    pub parameters: Vec<(usize, Register)>,
    /// Index of each state, with the register of its initial value.
    pub initial: Vec<(usize, Register)>,
    /// The registers of the roots.
    pub roots: Vec<Register>,
    /// Consecutive root registers as ranges: first register and length; empty if the roots are too scattered.
    pub rows: Vec<(Register, usize)>,
}

/// Minimum average length of the ranges in [`Code::rows`].
const LEAST_ROW: usize = 8;

impl Code {
    /// Number of operations in the body; a column counts once per element.
    pub fn operations(&self) -> usize {
        let count = |instruction: &Instruction| match instruction {
            Instruction::Column(column) => self.columns[*column as usize].count as usize,
            _ => 1,
        };
        self.body.iter().map(count).sum()
    }

    /// Finds ranges of consecutive root registers.
    pub fn find_rows(&mut self) {
        for &register in &self.roots {
            match self.rows.last_mut() {
                Some((first, count)) if *first as usize + *count == register as usize => *count += 1,
                _ => self.rows.push((register, 1)),
            }
        }
        if self.rows.len() * LEAST_ROW > self.roots.len() {
            self.rows.clear();
        }
    }

    /// Copies the values of the roots to `out`, one per root.
    #[inline]
    pub fn copy_roots(&self, out: &mut [f64]) {
        if self.rows.is_empty() {
            for (value, &register) in out.iter_mut().zip(&self.roots) {
                *value = self.registers[register as usize];
            }
            return;
        }
        let mut rest = out;
        for &(first, count) in &self.rows {
            let (some, others) = rest.split_at_mut(count.min(rest.len()));
            let values = &self.registers[first as usize..];
            some.iter_mut().zip(values).for_each(|(value, register)| *value = *register);
            rest = others;
        }
    }
}

/// Runs `code` over `registers` for `ROWS` rows at once: one dispatch serves all rows, and the compiler can use SIMD. The
/// bits of a row do not depend on `ROWS`.
pub(crate) fn run<const ROWS: usize>(
    code: &[Instruction],
    registers: &mut [[f64; ROWS]],
    columns: &[Column],
    interpolations: &[Arc<Interpolation>],
    systems: &mut [Elimination],
) {
    run_inline(code, registers, columns, interpolations, systems);
}

/// [`run`], compiled with the processor features of the caller.
#[inline(always)]
fn run_inline<const ROWS: usize>(
    code: &[Instruction],
    registers: &mut [[f64; ROWS]],
    columns: &[Column],
    interpolations: &[Arc<Interpolation>],
    systems: &mut [Elimination],
) {
    for &instruction in code {
        match instruction {
            Instruction::Add(to, a, b) => each(registers, to, [a, b], |[a, b]| a + b),
            Instruction::Subtract(to, a, b) => each(registers, to, [a, b], |[a, b]| a - b),
            Instruction::Multiply(to, a, b) => each(registers, to, [a, b], |[a, b]| a * b),
            Instruction::Divide(to, a, b) => each(registers, to, [a, b], |[a, b]| a / b),
            Instruction::Negate(to, a) => each(registers, to, [a], |[a]| -a),
            Instruction::MultiplyAdd(to, a, b, c) => each(registers, to, [a, b, c], |[a, b, c]| a * b + c),
            Instruction::MultiplySubtract(to, a, b, c) => each(registers, to, [a, b, c], |[a, b, c]| a * b - c),
            Instruction::SubtractProduct(to, a, b, c) => each(registers, to, [a, b, c], |[a, b, c]| c - a * b),
            Instruction::Select(to, condition, a, b) => {
                each(registers, to, [condition, a, b], |[condition, a, b]| if condition != 0.0 { a } else { b });
            }
            Instruction::Binomial(to, trials, probability, stream) => {
                each(registers, to, [trials, probability, stream], |[n, p, stream]| program::binomial(n, p, stream));
            }
            Instruction::Unary(function, to, a) if ROWS == 1 => each(registers, to, [a], |[a]| function.evaluate(a)),
            Instruction::Unary(function, to, a) => {
                let mut values = registers[a as usize];
                function.evaluate_all(&mut values);
                registers[to as usize] = values;
            }
            Instruction::Binary(function, to, a, b) => each(registers, to, [a, b], |[a, b]| function.evaluate(a, b)),
            Instruction::Piece(number, to, x) => {
                let interpolation = &interpolations[number as usize];
                each(registers, to, [x], |[x]| interpolation.piece(x));
            }
            Instruction::Interpolated(number, to, x, piece) => {
                let interpolation = &interpolations[number as usize];
                each(registers, to, [x, piece], |[x, piece]| interpolation.value(x, piece));
            }
            Instruction::Column(column) => columns[column as usize].run(registers, interpolations),
            Instruction::Solve(system) => (0..ROWS).for_each(|row| systems[system as usize].solve(registers, row)),
        }
    }
}
