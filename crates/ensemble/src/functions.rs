//! Elementary functions in lanes. Each function has a loop of its own, so that one which is compiled without branches becomes
//! SIMD; those of `elementary` have lanes of their own.

use crate::grid::{Block, one, two};
use program::{Binary, Unary};

/// Computes a function of one row.
#[inline(always)]
pub fn unary(function: Unary, to: &mut [Block], a: &[Block]) {
    macro_rules! loops {
        ($($name:ident)*; $($lanes:ident: $all:ident)*) => {
            match function {
                $(Unary::$name => one(to, a, |a| Unary::$name.evaluate(a)),)*
                $(Unary::$lanes => {
                    for (to, a) in to.iter_mut().zip(a) {
                        let mut block = *a;
                        elementary::$all(&mut block.0);
                        *to = block;
                    }
                })*
            }
        };
    }
    loops!(
        Negate Not Absolute Sign SquareRoot CubeRoot Log10 Asin Acos Asinh Acosh Atanh Floor Ceil Round Uniform Normal Exponential;
        Exp: exp_all Ln: ln_all Sin: sin_all Cos: cos_all Tan: tan_all Atan: atan_all Sinh: sinh_all Cosh: cosh_all Tanh: tanh_all
    );
}

/// Computes a function of two rows.
#[inline(always)]
pub fn binary(function: Binary, to: &mut [Block], a: &[Block], b: &[Block]) {
    macro_rules! loops {
        ($($name:ident)*; $($lanes:ident: $all:ident)*) => {
            match function {
                $(Binary::$name => two(to, a, b, |a, b| Binary::$name.evaluate(a, b)),)*
                $(Binary::$lanes => {
                    for ((to, a), b) in to.iter_mut().zip(a).zip(b) {
                        let mut block = *a;
                        elementary::$all(&mut block.0, &b.0);
                        *to = block;
                    }
                })*
            }
        };
    }
    loops!(
        Add Subtract Multiply Divide Minimum Maximum Less LessOrEqual Equal NotEqual And Or Stream Poisson;
        Power: pow_all Atan2: atan2_all
    );
}
