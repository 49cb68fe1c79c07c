//! Functions that emitted code imports, so that they have the same bits everywhere.

use program::{Binary, Interpolation, Unary};
use std::sync::Arc;

/// A function that emitted code imports. Operands and result are numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Function {
    /// A function of one operand.
    Unary(Unary),
    /// A function of two operands.
    Binary(Binary),
    /// Index of the piece of an interpolation (its index in the listing): argument.
    Piece(u32),
    /// Value of an interpolation (its index in the listing): argument, piece.
    Interpolated(u32),
    /// Sample of a binomial distribution: trials, probability, stream.
    Binomial,
}

impl Function {
    /// Number of operands, 1 to 3.
    pub fn operands(self) -> usize {
        match self {
            Self::Unary(_) | Self::Piece(_) => 1,
            Self::Binary(_) | Self::Interpolated(_) => 2,
            Self::Binomial => 3,
        }
    }

    /// Value at `operands`, of which those beyond [`Function::operands`] are not read. `interpolations` are those of the
    /// listing.
    pub fn value(self, operands: [f64; 3], interpolations: &[Arc<Interpolation>]) -> f64 {
        let [a, b, c] = operands;
        let interpolation = |number: u32| interpolations.get(number as usize);
        match self {
            Self::Unary(function) => function.evaluate(a),
            Self::Binary(function) => function.evaluate(a, b),
            Self::Piece(number) => interpolation(number).map_or(f64::NAN, |interpolation| interpolation.piece(a)),
            Self::Interpolated(number) => {
                interpolation(number).map_or(f64::NAN, |interpolation| interpolation.value(a, b))
            }
            Self::Binomial => program::binomial(a, b, c),
        }
    }
}
