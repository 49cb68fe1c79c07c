//! One operation on a column of values: what repeats in a model with many equal parts, such as a chain of masses. Element by
//! element it computes what the instruction of that operation computes, to the bit; but one dispatch serves the whole
//! column, and the processor may treat several elements at once.

use super::instruction::{Operation, Register, each};
use program::Interpolation;
use std::sync::Arc;

/// So many elements are computed in one go.
const LANES: usize = 16;

/// One operation for `count` targets in a row. All operands stand before the first target.
#[derive(Clone, Debug)]
pub(crate) struct Column {
    /// What is computed.
    pub operation: Operation,
    /// The register of the first element.
    pub to: Register,
    /// How many elements there are.
    pub count: u32,
    /// As many as the operation has; the others are not read.
    pub operands: [Operand; 3],
}

/// Where an operand stands, by element.
#[derive(Clone, Debug)]
pub(crate) enum Operand {
    /// One register for all elements.
    Same(Register),
    /// From this register on, one after the other.
    Next(Register),
    /// The first register and the distance, perhaps negative, from each to the next.
    Every(Register, i32),
    /// Anywhere.
    Listed(Box<[Register]>),
}

impl Operand {
    /// The simplest form of these registers.
    pub fn of(registers: &[Register]) -> Self {
        let (Some(&first), second) = (registers.first(), registers.get(1)) else { return Self::Same(0) };
        let distance = second.map_or(0, |&second| i64::from(second) - i64::from(first));
        let even = registers.windows(2).all(|pair| i64::from(pair[1]) - i64::from(pair[0]) == distance);
        match i32::try_from(distance) {
            Ok(0) if even => Self::Same(first),
            Ok(1) if even => Self::Next(first),
            Ok(distance) if even => Self::Every(first, distance),
            _ => Self::Listed(registers.into()),
        }
    }

    /// The register of one element.
    fn register(&self, element: usize) -> Register {
        match self {
            Self::Same(register) => *register,
            Self::Next(first) => first + element as Register,
            Self::Every(first, distance) => first.wrapping_add_signed(distance.wrapping_mul(element as i32)),
            Self::Listed(registers) => registers[element],
        }
    }
}

impl Column {
    /// Computes all elements, for as many rows at a time as a register has values.
    pub fn run<const ROWS: usize>(&self, registers: &mut [[f64; ROWS]], interpolations: &[Arc<Interpolation>]) {
        match self.operation {
            Operation::Add => self.arithmetic(registers, |[a, b]| a + b),
            Operation::Subtract => self.arithmetic(registers, |[a, b]| a - b),
            Operation::Multiply => self.arithmetic(registers, |[a, b]| a * b),
            Operation::Divide => self.arithmetic(registers, |[a, b]| a / b),
            Operation::Negate => self.arithmetic(registers, |[a]| -a),
            Operation::MultiplyAdd => self.arithmetic(registers, |[a, b, c]| a * b + c),
            Operation::MultiplySubtract => self.arithmetic(registers, |[a, b, c]| a * b - c),
            Operation::SubtractProduct => self.arithmetic(registers, |[a, b, c]| c - a * b),
            Operation::Select => self.all(registers, |[condition, a, b]| if condition != 0.0 { a } else { b }),
            Operation::Binomial => self.all(registers, |[n, p, stream]| program::binomial(n, p, stream)),
            Operation::Unary(function) => self.all(registers, |[a]| function.evaluate(a)),
            Operation::Binary(function) => self.all(registers, |[a, b]| function.evaluate(a, b)),
            Operation::Piece(number) => {
                let interpolation = &interpolations[number as usize];
                self.all(registers, |[x]| interpolation.piece(x));
            }
            Operation::Interpolated(number) => {
                let interpolation = &interpolations[number as usize];
                self.all(registers, |[x, piece]| interpolation.value(x, piece));
            }
        }
    }

    /// [`Column::all`] for an operation that takes less time than collecting its operands. Those of one row that stand one
    /// after the other, and at most one that is the same for all elements, are read where they are.
    #[inline(always)]
    fn arithmetic<const ROWS: usize, const OPERANDS: usize>(
        &self,
        registers: &mut [[f64; ROWS]],
        operation: impl Fn([f64; OPERANDS]) -> f64,
    ) {
        let mut same = None;
        for (which, operand) in self.operands[..OPERANDS].iter().enumerate() {
            match operand {
                Operand::Next(_) => {}
                Operand::Same(_) if same.is_none() => same = Some(which),
                _ => return self.all(registers, operation),
            }
        }
        if ROWS > 1 {
            return self.all(registers, operation);
        }
        let (known, targets) = registers.as_flattened_mut().split_at_mut(self.to as usize);
        let targets = &mut targets[..self.count as usize];
        let known = &*known;
        let operands = std::array::from_fn(|which| &known[self.operands[which].register(0) as usize..]);
        match same {
            None => one_by_one::<OPERANDS, 3>(targets, operands, operation),
            Some(0) => one_by_one::<OPERANDS, 0>(targets, operands, operation),
            Some(1) => one_by_one::<OPERANDS, 1>(targets, operands, operation),
            Some(_) => one_by_one::<OPERANDS, 2>(targets, operands, operation),
        }
    }

    #[inline(always)]
    fn all<const ROWS: usize, const OPERANDS: usize>(
        &self,
        registers: &mut [[f64; ROWS]],
        operation: impl Fn([f64; OPERANDS]) -> f64,
    ) {
        if ROWS == 1 {
            return self.blocks(registers.as_flattened_mut(), operation);
        }
        for element in 0..self.count as usize {
            let operands = std::array::from_fn(|which| self.operands[which].register(element));
            each(registers, self.to + element as Register, operands, &operation);
        }
    }

    /// Element after element of one row, in blocks. Operands that stand one after the other are read where they are, the
    /// others are collected first.
    #[inline(always)]
    fn blocks<const OPERANDS: usize>(&self, registers: &mut [f64], operation: impl Fn([f64; OPERANDS]) -> f64) {
        let (known, targets) = registers.split_at_mut(self.to as usize);
        let mut collected = [[0.0; LANES]; 3];
        self.collect_constant(known, &mut collected);
        for (block, target) in targets[..self.count as usize].chunks_mut(LANES).enumerate() {
            let first = block * LANES;
            self.collect(known, first, target.len(), &mut collected);
            let operands: [&[f64; LANES]; OPERANDS] = std::array::from_fn(|which| match self.operands[which] {
                Operand::Next(start) => known[start as usize + first..].first_chunk().unwrap_or(&collected[which]),
                _ => &collected[which],
            });
            let value = |lane: usize| operation(std::array::from_fn(|which| operands[which][lane]));
            match <&mut [f64; LANES]>::try_from(&mut *target) {
                Ok(target) => *target = std::array::from_fn(value),
                Err(_) => target.iter_mut().enumerate().for_each(|(lane, target)| *target = value(lane)),
            }
        }
    }

    /// Collects the operands that are the same for all elements.
    fn collect_constant(&self, known: &[f64], collected: &mut [[f64; LANES]; 3]) {
        for (values, operand) in collected.iter_mut().zip(&self.operands) {
            if let Operand::Same(register) = operand {
                values.fill(known[*register as usize]);
            }
        }
    }

    /// Collects the operands of `count` elements from `first` on, except those that are read where they are: one after the
    /// other, with at least [`LANES`] of them before the targets.
    fn collect(&self, known: &[f64], first: usize, count: usize, collected: &mut [[f64; LANES]; 3]) {
        for (values, operand) in collected.iter_mut().zip(&self.operands) {
            let values = &mut values[..count];
            match operand {
                Operand::Same(_) => {}
                Operand::Next(start) => {
                    let start = *start as usize + first;
                    if start + LANES > known.len() {
                        values.copy_from_slice(&known[start..start + count]);
                    }
                }
                Operand::Every(..) => {
                    for (lane, value) in values.iter_mut().enumerate() {
                        *value = known[operand.register(first + lane) as usize];
                    }
                }
                Operand::Listed(registers) => {
                    for (value, &register) in values.iter_mut().zip(&registers[first..]) {
                        *value = known[register as usize];
                    }
                }
            }
        }
    }
}

/// Computes `targets` from operands that begin where these slices do and go on from element to element, all but the one of number
/// `SAME`. Known to the compiler, it does not keep the processor from treating several elements at once.
#[inline(always)]
fn one_by_one<const OPERANDS: usize, const SAME: usize>(
    targets: &mut [f64],
    operands: [&[f64]; OPERANDS],
    operation: impl Fn([f64; OPERANDS]) -> f64,
) {
    let same = operands.get(SAME).and_then(|operand| operand.first()).copied().unwrap_or_default();
    let count = targets.len();
    let operands: [&[f64]; OPERANDS] =
        std::array::from_fn(|which| if which == SAME { &operands[which][..0] } else { &operands[which][..count] });
    for (element, target) in targets.iter_mut().enumerate() {
        let value = |which: usize| if which == SAME { same } else { operands[which][element] };
        *target = operation(std::array::from_fn(value));
    }
}
