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
    /// [`engine::dormand_prince_growth`]: error before, error.
    Growth,
    /// [`engine::dormand_prince_shrinkage`]: error.
    Shrinkage,
    /// [`engine::sign_changes`].
    SignChanges,
}

impl Function {
    /// Maximum number of operands.
    pub const MOST_OPERANDS: usize = 6;

    /// Number of operands, 1 to 6.
    pub fn operands(self) -> usize {
        match self {
            Self::Unary(_) | Self::Piece(_) | Self::Shrinkage => 1,
            Self::Binary(_) | Self::Interpolated(_) | Self::Growth => 2,
            Self::Binomial => 3,
            Self::SignChanges => 6,
        }
    }

    /// The function, if it has no data of its own.
    pub fn plain(self) -> Option<Plain> {
        match self {
            Self::Unary(function) => Some(Plain::One(one(function))),
            Self::Binary(function) => Some(Plain::Two(two(function))),
            Self::Binomial => Some(Plain::Three(program::binomial)),
            Self::Growth => Some(Plain::Two(engine::dormand_prince_growth)),
            Self::Shrinkage => Some(Plain::One(engine::dormand_prince_shrinkage)),
            Self::SignChanges => Some(Plain::Six(engine::sign_changes)),
            Self::Piece(_) | Self::Interpolated(_) => None,
        }
    }

    /// Value at `operands`, of which those beyond [`Function::operands`] are not read. `interpolations` are those of the
    /// listing.
    pub fn value(self, operands: [f64; 6], interpolations: &[Arc<Interpolation>]) -> f64 {
        let [a, b, c, d, e, f] = operands;
        let interpolation = |number: u32| interpolations.get(number as usize);
        match self {
            Self::Unary(function) => function.evaluate(a),
            Self::Binary(function) => function.evaluate(a, b),
            Self::Piece(number) => interpolation(number).map_or(f64::NAN, |interpolation| interpolation.piece(a)),
            Self::Interpolated(number) => {
                interpolation(number).map_or(f64::NAN, |interpolation| interpolation.value(a, b))
            }
            Self::Binomial => program::binomial(a, b, c),
            Self::Growth => engine::dormand_prince_growth(a, b),
            Self::Shrinkage => engine::dormand_prince_shrinkage(a),
            Self::SignChanges => engine::sign_changes(a, b, c, d, e, f),
        }
    }
}

/// Pointer to a function, for hosts that import functions by their address.
#[derive(Clone, Copy, Debug)]
pub enum Plain {
    /// A function of one operand.
    One(fn(f64) -> f64),
    /// A function of two operands.
    Two(fn(f64, f64) -> f64),
    /// A function of three operands.
    Three(fn(f64, f64, f64) -> f64),
    /// A function of six operands.
    Six(fn(f64, f64, f64, f64, f64, f64) -> f64),
}

fn one(function: Unary) -> fn(f64) -> f64 {
    macro_rules! pointers {
        ($($name:ident)*) => {
            match function {
                $(Unary::$name => |x| Unary::$name.evaluate(x),)*
            }
        };
    }
    pointers!(
        Negate Not Absolute Sign SquareRoot CubeRoot Exp Ln Log10 Sin Cos Tan Asin Acos Atan Sinh Cosh Tanh Asinh Acosh
        Atanh Floor Ceil Round Uniform Normal Exponential
    )
}

fn two(function: Binary) -> fn(f64, f64) -> f64 {
    macro_rules! pointers {
        ($($name:ident)*) => {
            match function {
                $(Binary::$name => |a, b| Binary::$name.evaluate(a, b),)*
            }
        };
    }
    pointers!(
        Add Subtract Multiply Divide Power Atan2 Minimum Maximum Less LessOrEqual Equal NotEqual And Or Stream Poisson
    )
}
