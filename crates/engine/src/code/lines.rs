//! Register code as a list of scalar operations, for compilers.

use super::column::Column;
use super::instruction::{Instruction, Operation, Register};

/// One operation with its registers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line {
    /// The operation.
    pub operation: Operation,
    /// Register of the result.
    pub to: Register,
    /// Registers of the operands; those beyond the arity of the operation have no meaning.
    pub operands: [Register; 3],
}

/// The operations of `code`, those of columns one by one; `None` if it solves linear systems.
pub(crate) fn lines(code: &[Instruction], columns: &[Column]) -> Option<Vec<Line>> {
    let mut lines = Vec::new();
    for &instruction in code {
        match instruction {
            Instruction::Solve(_) => return None,
            Instruction::Column(column) => lines.extend(columns[column as usize].lines()),
            _ => lines.push(single(instruction)?),
        }
    }
    Some(lines)
}

/// A single instruction; `None` for columns and linear systems. Inverse of [`Operation::instruction`].
fn single(instruction: Instruction) -> Option<Line> {
    let (operation, to, operands) = match instruction {
        Instruction::Add(to, a, b) => (Operation::Add, to, [a, b, 0]),
        Instruction::Subtract(to, a, b) => (Operation::Subtract, to, [a, b, 0]),
        Instruction::Multiply(to, a, b) => (Operation::Multiply, to, [a, b, 0]),
        Instruction::Divide(to, a, b) => (Operation::Divide, to, [a, b, 0]),
        Instruction::Negate(to, a) => (Operation::Negate, to, [a, 0, 0]),
        Instruction::MultiplyAdd(to, a, b, c) => (Operation::MultiplyAdd, to, [a, b, c]),
        Instruction::MultiplySubtract(to, a, b, c) => (Operation::MultiplySubtract, to, [a, b, c]),
        Instruction::SubtractProduct(to, a, b, c) => (Operation::SubtractProduct, to, [a, b, c]),
        Instruction::Select(to, condition, a, b) => (Operation::Select, to, [condition, a, b]),
        Instruction::Unary(function, to, a) => (Operation::Unary(function), to, [a, 0, 0]),
        Instruction::Binary(function, to, a, b) => (Operation::Binary(function), to, [a, b, 0]),
        Instruction::Piece(interpolation, to, x) => (Operation::Piece(interpolation), to, [x, 0, 0]),
        Instruction::Interpolated(interpolation, to, x, piece) => {
            (Operation::Interpolated(interpolation), to, [x, piece, 0])
        }
        Instruction::Binomial(to, trials, probability, stream) => {
            (Operation::Binomial, to, [trials, probability, stream])
        }
        Instruction::Solve(_) | Instruction::Column(_) => return None,
    };
    Some(Line { operation, to, operands })
}

impl Column {
    /// The operations of the elements.
    fn lines(&self) -> impl Iterator<Item = Line> {
        (0..self.count as usize).map(|element| Line {
            operation: self.operation,
            to: self.to + element as Register,
            operands: std::array::from_fn(|which| self.operands[which].register(element)),
        })
    }
}
