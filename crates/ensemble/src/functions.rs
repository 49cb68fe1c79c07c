//! Elementary functions in lanes. Each function has a loop of its own, so that one which is compiled without branches becomes SIMD.

use crate::grid::{Block, one, two};
use program::{Binary, Unary};

/// Computes a function of one row.
#[inline(always)]
pub fn unary(function: Unary, to: &mut [Block], a: &[Block]) {
    macro_rules! loops {
        ($($name:ident)*) => {
            match function {
                $(Unary::$name => one(to, a, |a| Unary::$name.evaluate(a)),)*
            }
        };
    }
    loops!(
        Negate Not Absolute Sign SquareRoot CubeRoot Exp Ln Log10 Sin Cos Tan Asin Acos Atan Sinh Cosh Tanh Asinh Acosh Atanh
        Floor Ceil Round Uniform Normal Exponential
    );
}

/// Computes a function of two rows.
#[inline(always)]
pub fn binary(function: Binary, to: &mut [Block], a: &[Block], b: &[Block]) {
    macro_rules! loops {
        ($($name:ident)*) => {
            match function {
                $(Binary::$name => two(to, a, b, |a, b| Binary::$name.evaluate(a, b)),)*
            }
        };
    }
    loops!(
        Add Subtract Multiply Divide Power Atan2 Minimum Maximum Less LessOrEqual Equal NotEqual And Or Stream Poisson
    );
}
