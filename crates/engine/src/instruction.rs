//! The register machine: what one instruction does, to the bit. Nothing here depends on the platform: the four operations
//! and the square root are exact by IEEE 754, the elementary functions are `libm`'s, and nothing is ever fused.

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
            Instruction::Add(to, a, b) => {
                registers[to as usize] = registers[a as usize] + registers[b as usize]
            }
            Instruction::Subtract(to, a, b) => {
                registers[to as usize] = registers[a as usize] - registers[b as usize]
            }
            Instruction::Multiply(to, a, b) => {
                registers[to as usize] = registers[a as usize] * registers[b as usize]
            }
            Instruction::Divide(to, a, b) => {
                registers[to as usize] = registers[a as usize] / registers[b as usize]
            }
            Instruction::Negate(to, a) => registers[to as usize] = -registers[a as usize],
            Instruction::MultiplyAdd(to, a, b, c) => {
                registers[to as usize] =
                    registers[a as usize] * registers[b as usize] + registers[c as usize];
            }
            Instruction::MultiplySubtract(to, a, b, c) => {
                registers[to as usize] =
                    registers[a as usize] * registers[b as usize] - registers[c as usize];
            }
            Instruction::SubtractProduct(to, a, b, c) => {
                registers[to as usize] =
                    registers[c as usize] - registers[a as usize] * registers[b as usize];
            }
            Instruction::Select(to, condition, a, b) => {
                let chosen = if registers[condition as usize] != 0.0 {
                    a
                } else {
                    b
                };
                registers[to as usize] = registers[chosen as usize];
            }
            Instruction::Unary(function, to, a) => {
                registers[to as usize] = unary(function, registers[a as usize])
            }
            Instruction::Binary(function, to, a, b) => {
                registers[to as usize] =
                    binary(function, registers[a as usize], registers[b as usize]);
            }
            Instruction::Solve(system) => systems[system as usize].solve(registers),
        }
    }
}

/// `function(x)`.
pub(crate) fn unary(function: Unary, x: f64) -> f64 {
    match function {
        Unary::Negate => -x,
        Unary::Not => truth(x == 0.0),
        Unary::Absolute => x.abs(),
        Unary::Sign if x > 0.0 => 1.0,
        Unary::Sign if x < 0.0 => -1.0,
        Unary::Sign => x,
        Unary::SquareRoot => x.sqrt(),
        Unary::CubeRoot => libm::cbrt(x),
        Unary::Exp => libm::exp(x),
        Unary::Ln => libm::log(x),
        Unary::Log10 => libm::log10(x),
        Unary::Sin => libm::sin(x),
        Unary::Cos => libm::cos(x),
        Unary::Tan => libm::tan(x),
        Unary::Asin => libm::asin(x),
        Unary::Acos => libm::acos(x),
        Unary::Atan => libm::atan(x),
        Unary::Sinh => libm::sinh(x),
        Unary::Cosh => libm::cosh(x),
        Unary::Tanh => libm::tanh(x),
        Unary::Asinh => libm::asinh(x),
        Unary::Acosh => libm::acosh(x),
        Unary::Atanh => libm::atanh(x),
        Unary::Floor => x.floor(),
        Unary::Ceil => x.ceil(),
        Unary::Round => x.round(),
    }
}

/// `function(a, b)`. What is not a number stays so through minimum and maximum, and no comparison holds for it.
pub(crate) fn binary(function: Binary, a: f64, b: f64) -> f64 {
    match function {
        Binary::Add => a + b,
        Binary::Subtract => a - b,
        Binary::Multiply => a * b,
        Binary::Divide => a / b,
        Binary::Power => libm::pow(a, b),
        Binary::Atan2 => libm::atan2(a, b),
        Binary::Minimum => {
            if b < a || b.is_nan() {
                b
            } else {
                a
            }
        }
        Binary::Maximum => {
            if b > a || b.is_nan() {
                b
            } else {
                a
            }
        }
        Binary::Modulo => a - b * (a / b).floor(),
        Binary::Less => truth(a < b),
        Binary::LessOrEqual => truth(a <= b),
        Binary::Equal => truth(a == b),
        Binary::NotEqual => truth(a != b),
        Binary::And => truth(a != 0.0 && b != 0.0),
        Binary::Or => truth(a != 0.0 || b != 0.0),
    }
}

fn truth(holds: bool) -> f64 {
    if holds { 1.0 } else { 0.0 }
}
