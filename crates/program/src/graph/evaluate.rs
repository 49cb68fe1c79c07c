//! Numeric values of the functions of a graph. Constant folding, the register machine and the tests share them, so that an
//! expression has the same bits everywhere.

use crate::{Binary, Unary, chance};

impl Unary {
    /// Value at `x`.
    pub fn evaluate(self, x: f64) -> f64 {
        match self {
            Self::Negate => -x,
            Self::Not => truth(x == 0.0),
            Self::Absolute => x.abs(),
            Self::Sign => sign(x),
            Self::SquareRoot => x.sqrt(),
            Self::CubeRoot => libm::cbrt(x),
            Self::Exp => elementary::exp(x),
            Self::Ln => elementary::ln(x),
            Self::Log10 => libm::log10(x),
            Self::Sin => elementary::sin(x),
            Self::Cos => elementary::cos(x),
            Self::Tan => elementary::tan(x),
            Self::Asin => libm::asin(x),
            Self::Acos => libm::acos(x),
            Self::Atan => elementary::atan(x),
            Self::Sinh => elementary::sinh(x),
            Self::Cosh => elementary::cosh(x),
            Self::Tanh => elementary::tanh(x),
            Self::Asinh => libm::asinh(x),
            Self::Acosh => libm::acosh(x),
            Self::Atanh => libm::atanh(x),
            Self::Floor => x.floor(),
            Self::Ceil => x.ceil(),
            Self::Round => x.round(),
            Self::Uniform => chance::uniform(x),
            Self::Normal => chance::normal(x),
            Self::Exponential => chance::exponential(x),
        }
    }

    /// Replaces each of `values` by the value there, with the bits of [`Unary::evaluate`]. The most frequent functions are computed
    /// in lanes with the processor features of the caller, except in pages, whose modules have no registers for lanes.
    #[inline(always)]
    pub fn evaluate_all(self, values: &mut [f64]) {
        match self {
            Self::Exp if LANES => elementary::exp_all(values),
            Self::Sin if LANES => elementary::sin_all(values),
            Self::Cos if LANES => elementary::cos_all(values),
            _ => values.iter_mut().for_each(|value| *value = self.evaluate(*value)),
        }
    }
}

/// True if functions are computed in lanes.
const LANES: bool = cfg!(not(target_arch = "wasm32"));

impl Binary {
    /// Value at `a` and `b`.
    pub fn evaluate(self, a: f64, b: f64) -> f64 {
        match self {
            Self::Add => a + b,
            Self::Subtract => a - b,
            Self::Multiply => a * b,
            Self::Divide => a / b,
            Self::Power => elementary::pow(a, b),
            Self::Atan2 => elementary::atan2(a, b),
            Self::Minimum => lesser(a, b),
            Self::Maximum => greater(a, b),
            Self::Less => truth(a < b),
            Self::LessOrEqual => truth(a <= b),
            Self::Equal => truth(a == b),
            Self::NotEqual => truth(a != b),
            Self::And => truth(a != 0.0 && b != 0.0),
            Self::Or => truth(a != 0.0 || b != 0.0),
            Self::Stream => chance::stream(a, b),
            Self::Poisson => chance::poisson(a, b),
        }
    }
}

/// 1 for true, 0 for false.
fn truth(value: bool) -> f64 {
    f64::from(u8::from(value))
}

/// Sign of `x`: unlike `f64::signum`, 0 for 0; NaN for NaN.
fn sign(x: f64) -> f64 {
    if x > 0.0 {
        1.0
    } else if x < 0.0 {
        -1.0
    } else {
        x
    }
}

/// Minimum: unlike `f64::min`, NaN if either is NaN, and defined for zeros of both signs.
fn lesser(a: f64, b: f64) -> f64 {
    if a.is_nan() || a < b { a } else { b }
}

/// Maximum: unlike `f64::max`, NaN if either is NaN, and defined for zeros of both signs.
fn greater(a: f64, b: f64) -> f64 {
    if a.is_nan() || a > b { a } else { b }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn undefined_arguments_stay_visible() {
        for binary in [Binary::Minimum, Binary::Maximum] {
            assert!(binary.evaluate(f64::NAN, 1.0).is_nan());
            assert!(binary.evaluate(1.0, f64::NAN).is_nan());
        }
        assert!(Unary::Sign.evaluate(f64::NAN).is_nan());
    }

    #[test]
    fn values_of_many_arguments_have_the_bits_of_each() {
        let arguments: Vec<f64> =
            (0..61).map(|place| 1e5 * libm::sin(f64::from(place))).chain([f64::INFINITY, 0.3]).collect();
        for function in [Unary::Exp, Unary::Sin, Unary::Cos, Unary::Tanh, Unary::Negate] {
            let mut values = arguments.clone();
            function.evaluate_all(&mut values);
            for (value, argument) in values.iter().zip(&arguments) {
                let alone = function.evaluate(*argument);
                let same = value.to_bits() == alone.to_bits() || value.is_nan() && alone.is_nan();
                assert!(same, "{function:?} of {argument}: {value} and {alone}");
            }
        }
    }

    #[test]
    fn the_sign_of_zero_is_zero_and_halves_round_away_from_it() {
        assert_eq!(Unary::Sign.evaluate(-0.0), 0.0);
        assert_eq!(Unary::Sign.evaluate(-3.0), -1.0);
        assert_eq!(Unary::Round.evaluate(2.5), 3.0);
        assert_eq!(Unary::Round.evaluate(-2.5), -3.0);
    }
}
