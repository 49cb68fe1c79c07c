//! Instructions of the register machine.

use crate::methods::sparse::Sparse;
use program::{Binary, Unary};

/// Index of a register.
pub type Register = u32;

/// One instruction; the first register is the target. A product and the sum that uses it are one instruction (with both
/// roundings) because dispatch costs more than arithmetic. Functions that cost more than dispatch share a variant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Instruction {
    Add(Register, Register, Register),
    Subtract(Register, Register, Register),
    Multiply(Register, Register, Register),
    Divide(Register, Register, Register),
    Negate(Register, Register),
    /// a * b + c; registers: target, a, b, c.
    MultiplyAdd(Register, Register, Register, Register),
    /// a * b - c; registers: target, a, b, c.
    MultiplySubtract(Register, Register, Register, Register),
    /// c - a * b; registers: target, a, b, c.
    SubtractProduct(Register, Register, Register, Register),
    /// a if the condition is not 0, else b; registers: target, condition, a, b.
    Select(Register, Register, Register, Register),
    Unary(Unary, Register, Register),
    Binary(Binary, Register, Register, Register),
    /// Piece index of an interpolation (its index, target, argument).
    Piece(u32, Register, Register),
    /// Value of an interpolation (its index, target, argument, piece).
    Interpolated(u32, Register, Register, Register),
    /// Sample of a binomial distribution: target, trials, probability, random stream.
    Binomial(Register, Register, Register, Register),
    /// Solves the linear system of this index.
    Solve(u32),
    /// Computes the column of this index.
    Column(u32),
}

/// Operation of the register machine on its operands a, b and c.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Operation {
    /// a + b
    Add,
    /// a - b
    Subtract,
    /// a * b
    Multiply,
    /// a / b
    Divide,
    /// -a
    Negate,
    /// a * b + c, with both roundings.
    MultiplyAdd,
    /// a * b - c, with both roundings.
    MultiplySubtract,
    /// c - a * b, with both roundings.
    SubtractProduct,
    /// b if the condition a is not 0, else c.
    Select,
    /// Sample of a binomial distribution: trials, probability, random stream.
    Binomial,
    /// A function of a.
    Unary(Unary),
    /// A function of a and b.
    Binary(Binary),
    /// Index of the piece of an interpolation (its index) in which a lies.
    Piece(u32),
    /// Value at a of an interpolation (its index) in the piece b.
    Interpolated(u32),
}

impl Operation {
    /// Number of operands, 1 to 3.
    pub fn operands(self) -> usize {
        match self {
            Self::Negate | Self::Unary(_) | Self::Piece(_) => 1,
            Self::Add | Self::Subtract | Self::Multiply | Self::Divide | Self::Binary(_) | Self::Interpolated(_) => 2,
            Self::MultiplyAdd | Self::MultiplySubtract | Self::SubtractProduct | Self::Select | Self::Binomial => 3,
        }
    }

    /// The instruction with this target and these operands; surplus operands are ignored.
    pub(crate) fn instruction(self, to: Register, [a, b, c]: [Register; 3]) -> Instruction {
        match self {
            Self::Add => Instruction::Add(to, a, b),
            Self::Subtract => Instruction::Subtract(to, a, b),
            Self::Multiply => Instruction::Multiply(to, a, b),
            Self::Divide => Instruction::Divide(to, a, b),
            Self::Negate => Instruction::Negate(to, a),
            Self::MultiplyAdd => Instruction::MultiplyAdd(to, a, b, c),
            Self::MultiplySubtract => Instruction::MultiplySubtract(to, a, b, c),
            Self::SubtractProduct => Instruction::SubtractProduct(to, a, b, c),
            Self::Select => Instruction::Select(to, a, b, c),
            Self::Binomial => Instruction::Binomial(to, a, b, c),
            Self::Unary(function) => Instruction::Unary(function, to, a),
            Self::Binary(function) => Instruction::Binary(function, to, a, b),
            Self::Piece(interpolation) => Instruction::Piece(interpolation, to, a),
            Self::Interpolated(interpolation) => Instruction::Interpolated(interpolation, to, a, b),
        }
    }

    /// Unique key of the operation, for sorting.
    pub(crate) fn number(self) -> (u8, u32) {
        match self {
            Self::Add => (0, 0),
            Self::Subtract => (1, 0),
            Self::Multiply => (2, 0),
            Self::Divide => (3, 0),
            Self::Negate => (4, 0),
            Self::MultiplyAdd => (5, 0),
            Self::MultiplySubtract => (6, 0),
            Self::SubtractProduct => (7, 0),
            Self::Select => (8, 0),
            Self::Unary(function) => (9, function as u32),
            Self::Binary(function) => (10, function as u32),
            Self::Piece(interpolation) => (11, interpolation),
            Self::Interpolated(interpolation) => (12, interpolation),
            Self::Binomial => (13, 0),
        }
    }
}

/// A linear system whose entries are registers.
#[derive(Clone, Debug)]
pub(crate) struct Elimination {
    /// Registers of the matrix entries.
    pub entries: Vec<Register>,
    /// Registers of the right-hand side.
    pub right: Vec<Register>,
    /// First register of the unknowns.
    pub target: Register,
    /// Working storage for the matrix and its factors; solving allocates nothing.
    pub matrix: Sparse,
    /// Working storage for the solution.
    pub solution: Vec<f64>,
}

impl Elimination {
    /// Solves the system of one row: reads its entries from `registers` and writes the unknowns there.
    pub fn solve<const ROWS: usize>(&mut self, registers: &mut [[f64; ROWS]], row: usize) {
        self.matrix.factorize(0.0, |values, places| {
            for (&place, &register) in places.iter().zip(&self.entries) {
                values[place] = registers[register as usize][row];
            }
        });
        for (value, &register) in self.solution.iter_mut().zip(&self.right) {
            *value = registers[register as usize][row];
        }
        self.matrix.solve(&mut self.solution);
        let targets = registers[self.target as usize..].iter_mut();
        targets.zip(&self.solution).for_each(|(register, value)| register[row] = *value);
    }
}

/// Writes the result of `operation` to register `to`, row by row.
#[inline(always)]
pub(crate) fn each<const ROWS: usize, const OPERANDS: usize>(
    registers: &mut [[f64; ROWS]],
    to: Register,
    operands: [Register; OPERANDS],
    operation: impl Fn([f64; OPERANDS]) -> f64,
) {
    let operands = operands.map(|register| registers[register as usize]);
    registers[to as usize] = std::array::from_fn(|row| operation(std::array::from_fn(|which| operands[which][row])));
}
