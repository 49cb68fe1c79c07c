//! SI value of a unit as an exact quotient as long as possible: a centimetre divides by 100 instead of multiplying by the
//! inexact 0.01.

use crate::Exponent;

/// The number `numerator / denominator * 10^tens * rest`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Scale {
    numerator: u128,
    denominator: u128,
    tens: i32,
    /// Factor that is irrational or too large for a quotient of integers: the pi of a degree, the root of a centimetre.
    rest: f64,
}

impl Scale {
    pub(crate) const ONE: Self = Self::decimal(1, 0);

    /// The number `digits * 10^tens`.
    pub(crate) const fn decimal(digits: u64, tens: i32) -> Self {
        Self { numerator: digits as u128, denominator: 1, tens, rest: 1.0 }
    }

    /// The number `numerator / denominator`.
    pub(crate) const fn fraction(numerator: u64, denominator: u64) -> Self {
        Self { numerator: numerator as u128, denominator: denominator as u128, tens: 0, rest: 1.0 }
    }

    /// The number `rest * numerator / denominator`.
    pub(crate) const fn irrational(rest: f64, numerator: u64, denominator: u64) -> Self {
        Self { numerator: numerator as u128, denominator: denominator as u128, tens: 0, rest }
    }

    pub(crate) fn times(self, other: Self) -> Self {
        // Fast path: most units are coherent SI units, and division of 128-bit integers is slow.
        if other == Self::ONE {
            return self;
        }
        if self == Self::ONE {
            return other;
        }
        let numerator = self.numerator.checked_mul(other.numerator);
        let denominator = self.denominator.checked_mul(other.denominator);
        let (Some(numerator), Some(denominator)) = (numerator, denominator) else {
            return Self { rest: self.value() * other.value(), ..Self::ONE };
        };
        let divisor = greatest_common_divisor(numerator, denominator);
        Self {
            numerator: numerator / divisor,
            denominator: denominator / divisor,
            tens: self.tens.saturating_add(other.tens),
            rest: self.rest * other.rest,
        }
    }

    fn inverse(self) -> Self {
        let tens = self.tens.saturating_neg();
        Self { numerator: self.denominator, denominator: self.numerator, tens, rest: 1.0 / self.rest }
    }

    pub(crate) fn power(self, exponent: Exponent) -> Self {
        if !exponent.is_whole() {
            return Self { rest: libm::pow(self.value(), exponent.to_number()), ..Self::ONE };
        }
        let base = if exponent.numerator() < 0 { self.inverse() } else { self };
        (0..exponent.numerator().unsigned_abs()).fold(Self::ONE, |product, _| product.times(base))
    }

    /// Multiplier and divisor, both exact if possible.
    pub(crate) fn quotient(self) -> (f64, f64) {
        let exact = || {
            let power = 10_u128.checked_pow(self.tens.unsigned_abs())?;
            let (grows, stays) = if self.tens > 0 { (power, 1) } else { (1, power) };
            let numerator = self.numerator.checked_mul(grows)?;
            let denominator = self.denominator.checked_mul(stays)?;
            let divisor = greatest_common_divisor(numerator, denominator);
            Some(((numerator / divisor) as f64 * self.rest, (denominator / divisor) as f64))
        };
        exact().unwrap_or_else(|| (self.value(), 1.0))
    }

    fn value(self) -> f64 {
        // Parsing the power of ten rounds it correctly; a power function may not.
        let power = crate::number::decimal(&format!("1e{}", self.tens)).unwrap_or(f64::NAN);
        self.numerator as f64 / self.denominator as f64 * self.rest * power
    }
}

fn greatest_common_divisor(mut a: u128, mut b: u128) -> u128 {
    if a == 1 || b == 1 {
        return 1;
    }
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a.max(1)
}
