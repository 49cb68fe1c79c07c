//! The register machine: what one instruction does, to the bit. Nothing here depends on the platform: the four operations
//! and the square root are exact by IEEE 754, the other functions are those of [`model::Unary::evaluate`] and
//! [`model::Binary::evaluate`], and nothing is ever fused.

use crate::linear::Elimination;
use model::{Binary, Unary};

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

/// Runs `code` over `registers`.
pub(crate) fn run(code: &[Instruction], registers: &mut [f64], systems: &mut [Elimination]) {
    for &instruction in code {
        match instruction {
            Instruction::Add(to, a, b) => registers[to as usize] = registers[a as usize] + registers[b as usize],
            Instruction::Subtract(to, a, b) => registers[to as usize] = registers[a as usize] - registers[b as usize],
            Instruction::Multiply(to, a, b) => registers[to as usize] = registers[a as usize] * registers[b as usize],
            Instruction::Divide(to, a, b) => registers[to as usize] = registers[a as usize] / registers[b as usize],
            Instruction::Negate(to, a) => registers[to as usize] = -registers[a as usize],
            Instruction::MultiplyAdd(to, a, b, c) => {
                registers[to as usize] = registers[a as usize] * registers[b as usize] + registers[c as usize];
            }
            Instruction::MultiplySubtract(to, a, b, c) => {
                registers[to as usize] = registers[a as usize] * registers[b as usize] - registers[c as usize];
            }
            Instruction::SubtractProduct(to, a, b, c) => {
                registers[to as usize] = registers[c as usize] - registers[a as usize] * registers[b as usize];
            }
            Instruction::Select(to, condition, a, b) => {
                let chosen = if registers[condition as usize] != 0.0 { a } else { b };
                registers[to as usize] = registers[chosen as usize];
            }
            Instruction::Unary(function, to, a) => registers[to as usize] = function.evaluate(registers[a as usize]),
            Instruction::Binary(function, to, a, b) => {
                registers[to as usize] = function.evaluate(registers[a as usize], registers[b as usize]);
            }
            Instruction::Solve(system) => systems[system as usize].solve(registers),
        }
    }
}
