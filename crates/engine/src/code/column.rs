//! Vectorized instructions: one operation on a column of values, for models with many equal parts such as a chain of
//! masses. Each element has the bits of the corresponding single instruction, but one dispatch serves the whole column, and
//! the compiler can use SIMD.

use super::instruction::{Operation, Register, each};
use program::Interpolation;
use std::sync::Arc;

/// Number of elements computed per block.
const LANES: usize = 16;

/// One operation for `count` consecutive target registers. All operands are in registers before the first target.
#[derive(Clone, Debug)]
pub(crate) struct Column {
    /// The operation.
    pub operation: Operation,
    /// Register of the first element.
    pub to: Register,
    /// Number of elements.
    pub count: u32,
    /// The operands; those beyond the arity of the operation are not read.
    pub operands: [Operand; 3],
}

/// Registers of one operand, by element.
#[derive(Clone, Debug)]
pub(crate) enum Operand {
    /// One register for all elements.
    Same(Register),
    /// Consecutive registers from this one on.
    Next(Register),
    /// First register and stride, which can be negative.
    Every(Register, i32),
    /// Any registers, one per element.
    Listed(Box<[Register]>),
}

impl Operand {
    /// The most compact form of these registers.
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

    /// Register of one element.
    pub fn register(&self, element: usize) -> Register {
        match self {
            Self::Same(register) => *register,
            Self::Next(first) => first + element as Register,
            Self::Every(first, distance) => first.wrapping_add_signed(distance.wrapping_mul(element as i32)),
            Self::Listed(registers) => registers[element],
        }
    }
}

impl Column {
    /// Computes all elements for `ROWS` rows at once.
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

    /// [`Column::all`] for operations cheaper than copying their operands. For a single row, consecutive operands and at
    /// most one operand common to all elements are read in place.
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

    /// Computes one row in blocks of [`LANES`] elements. Consecutive operands are read in place, others are copied first.
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

    /// Copies the operands that are common to all elements.
    fn collect_constant(&self, known: &[f64], collected: &mut [[f64; LANES]; 3]) {
        for (values, operand) in collected.iter_mut().zip(&self.operands) {
            if let Operand::Same(register) = operand {
                values.fill(known[*register as usize]);
            }
        }
    }

    /// Copies the operands of `count` elements from `first` on. Operands read in place are skipped: consecutive registers
    /// with at least [`LANES`] of them before the targets.
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

/// Computes `targets` from operand slices, element by element; operand number `SAME` has one value for all elements. As a
/// constant, `SAME` does not prevent vectorization.
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
