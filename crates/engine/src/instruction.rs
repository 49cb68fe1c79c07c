//! The register machine: what one instruction does, to the bit. Nothing here depends on the platform: the four operations
//! and the square root are exact by IEEE 754, the other functions are those of [`program::Unary::evaluate`] and
//! [`program::Binary::evaluate`], and nothing is ever fused.

use crate::linear::Factors;
use program::{Binary, Unary};

/// The number of a register.
pub(crate) type Register = u32;

/// One instruction; the first register is the target. A product and the sum it goes into are one instruction (with both
/// roundings), because dispatch costs more than arithmetic; functions that cost more than dispatch share a variant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Instruction {
    Add(Register, Register, Register),
    Subtract(Register, Register, Register),
    Multiply(Register, Register, Register),
    Divide(Register, Register, Register),
    Negate(Register, Register),
    /// a * b + c
    MultiplyAdd(Register, Register, Register, Register),
    /// a * b - c
    MultiplySubtract(Register, Register, Register, Register),
    /// c - a * b
    SubtractProduct(Register, Register, Register, Register),
    /// a if the condition is not 0, else b.
    Select(Register, Register, Register, Register),
    Unary(Unary, Register, Register),
    Binary(Binary, Register, Register, Register),
    /// Solves the linear system of this number.
    Solve(u32),
}

/// A linear system among the registers of a routine.
#[derive(Clone, Debug)]
pub(crate) struct Elimination {
    /// The registers of the matrix, row by row.
    pub matrix: Vec<Register>,
    /// The registers of the right side.
    pub right: Vec<Register>,
    /// The first of the registers that receive the unknowns.
    pub target: Register,
    /// Room for the factors, so that solving allocates nothing.
    pub factors: Factors,
    /// Room for the solution.
    pub solution: Vec<f64>,
}

impl Elimination {
    /// About how many floating-point operations a solution takes.
    pub fn work(&self) -> usize {
        let size = self.solution.len();
        size * size * (2 + size / 3)
    }

    /// Reads the system of one row from `registers` and writes the unknowns there.
    pub fn solve<const ROWS: usize>(&mut self, registers: &mut [[f64; ROWS]], row: usize) {
        for (value, &register) in self.factors.values.iter_mut().zip(&self.matrix) {
            *value = registers[register as usize][row];
        }
        for (value, &register) in self.solution.iter_mut().zip(&self.right) {
            *value = registers[register as usize][row];
        }
        self.factors.factorize();
        self.factors.solve(&mut self.solution);
        let targets = registers[self.target as usize..].iter_mut();
        targets.zip(&self.solution).for_each(|(register, value)| register[row] = *value);
    }
}

/// Runs `code` over `registers`, for as many rows at a time as a register has values: one dispatch serves them all, and the
/// processor may treat several at once. The bits of a row do not depend on how many there are.
pub(crate) fn run<const ROWS: usize>(code: &[Instruction], registers: &mut [[f64; ROWS]], systems: &mut [Elimination]) {
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
            Instruction::Unary(function, to, a) => each(registers, to, [a], |[a]| function.evaluate(a)),
            Instruction::Binary(function, to, a, b) => each(registers, to, [a, b], |[a, b]| function.evaluate(a, b)),
            Instruction::Solve(system) => (0..ROWS).for_each(|row| systems[system as usize].solve(registers, row)),
        }
    }
}

/// Puts the result of `operation` into register `to`, row by row.
#[inline(always)]
fn each<const ROWS: usize, const OPERANDS: usize>(
    registers: &mut [[f64; ROWS]],
    to: Register,
    operands: [Register; OPERANDS],
    operation: impl Fn([f64; OPERANDS]) -> f64,
) {
    let operands = operands.map(|register| registers[register as usize]);
    registers[to as usize] = std::array::from_fn(|row| operation(std::array::from_fn(|which| operands[which][row])));
}
