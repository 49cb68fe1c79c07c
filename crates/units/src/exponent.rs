//! Rational exponents, such as the 1/2 of a square root.

use std::fmt;

/// Upper bound of numerator and denominator; physical dimensions stay far below.
const BOUND: i16 = 1000;

/// A rational exponent in lowest terms. Operations return `None` if numerator or denominator would exceed 1000.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Exponent {
    numerator: i16,
    denominator: i16,
}

impl Exponent {
    /// 0
    pub const ZERO: Self = Self::whole(0);
    /// 1
    pub const ONE: Self = Self::whole(1);

    const fn whole(value: i16) -> Self {
        Self { numerator: value, denominator: 1 }
    }

    /// An integer exponent; `None` beyond the bound.
    fn bounded(value: i32) -> Option<Self> {
        i16::try_from(value).ok().filter(|value| (-BOUND..=BOUND).contains(value)).map(Self::whole)
    }

    /// `numerator / denominator` in lowest terms; `None` for a denominator of 0 or beyond the bound.
    pub fn new(numerator: i64, denominator: i64) -> Option<Self> {
        if denominator == 0 {
            return None;
        }
        let divisor = greatest_common_divisor(numerator.unsigned_abs(), denominator.unsigned_abs());
        let divisor = i64::try_from(divisor).ok()?;
        let sign = denominator.signum();
        let numerator = (numerator / divisor).checked_mul(sign)?;
        let denominator = (denominator / divisor).checked_mul(sign)?;
        if numerator.abs() > i64::from(BOUND) || denominator > i64::from(BOUND) {
            return None;
        }
        Some(Self { numerator: numerator as i16, denominator: denominator as i16 })
    }

    /// The exponent equal to `value`: an integer, or a fraction with a denominator up to 12 (0.5, 1.5, 1/3 to the last
    /// digit). `None` for any other number.
    pub fn from_number(value: f64) -> Option<Self> {
        (1..=12).find_map(|denominator: i64| {
            let numerator = (value * denominator as f64).round();
            let is_it = numerator.abs() <= f64::from(BOUND) && numerator / denominator as f64 == value;
            if is_it { Self::new(numerator as i64, denominator) } else { None }
        })
    }

    /// Numerator, with the sign.
    pub fn numerator(self) -> i32 {
        i32::from(self.numerator)
    }

    /// Denominator, at least 1.
    pub fn denominator(self) -> i32 {
        i32::from(self.denominator)
    }

    /// True for 0.
    pub fn is_zero(self) -> bool {
        self.numerator == 0
    }

    /// True for an integer.
    pub fn is_whole(self) -> bool {
        self.denominator == 1
    }

    /// Nearest `f64`.
    pub fn to_number(self) -> f64 {
        f64::from(self.numerator) / f64::from(self.denominator)
    }

    /// Power of a symbol as text: `m^2`, `s^(1/2)`.
    pub(crate) fn power_of(self, symbol: &str) -> String {
        if self == Self::ONE {
            symbol.to_owned()
        } else if self.is_whole() {
            format!("{symbol}^{self}")
        } else {
            format!("{symbol}^({self})")
        }
    }

    /// Sum; `None` beyond the bound.
    pub fn plus(self, other: Self) -> Option<Self> {
        // Nearly all exponents are integers, which need no division.
        if self.is_whole() && other.is_whole() {
            return Self::bounded(self.numerator() + other.numerator());
        }
        let (a, b) = (i64::from(self.numerator), i64::from(self.denominator));
        let (c, d) = (i64::from(other.numerator), i64::from(other.denominator));
        Self::new(a * d + c * b, b * d)
    }

    /// Product; `None` beyond the bound.
    pub fn times(self, other: Self) -> Option<Self> {
        if self.is_whole() && other.is_whole() {
            return Self::bounded(self.numerator() * other.numerator());
        }
        let (a, b) = (i64::from(self.numerator), i64::from(self.denominator));
        let (c, d) = (i64::from(other.numerator), i64::from(other.denominator));
        Self::new(a * c, b * d)
    }

    /// Negative.
    pub fn negated(self) -> Self {
        Self { numerator: -self.numerator, ..self }
    }
}

impl From<i8> for Exponent {
    fn from(value: i8) -> Self {
        Self::whole(i16::from(value))
    }
}

/// Text of the exponent: `2`, `-1`, `1/2`.
impl fmt::Display for Exponent {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.denominator == 1 {
            write!(formatter, "{}", self.numerator)
        } else {
            write!(formatter, "{}/{}", self.numerator, self.denominator)
        }
    }
}

fn greatest_common_divisor(mut a: u64, mut b: u64) -> u64 {
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a.max(1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn is_kept_in_lowest_terms() {
        let half = Exponent::new(2, 4).unwrap();
        assert_eq!(half.to_string(), "1/2");
        assert_eq!(Exponent::new(3, -6).unwrap().to_string(), "-1/2");
        assert_eq!(half.plus(half), Some(Exponent::ONE));
        assert_eq!(half.times(Exponent::from(-4)), Some(Exponent::from(-2)));
    }

    #[test]
    fn what_leaves_the_bound_is_none() {
        assert_eq!(Exponent::new(1, 0), None);
        assert_eq!(Exponent::new(i64::MIN, -1), None);
        let large = Exponent::new(1000, 1).unwrap();
        assert_eq!(large.plus(Exponent::ONE), None);
        assert_eq!(large.times(large), None);
    }

    #[test]
    fn numbers_become_exponents_when_they_are_simple_fractions() {
        for (number, text) in [(2.0, "2"), (-0.5, "-1/2"), (1.0 / 3.0, "1/3"), (0.0, "0"), (1.75, "7/4")] {
            assert_eq!(Exponent::from_number(number).unwrap().to_string(), text);
        }
        for number in [0.123_456, 1e300, f64::NAN, f64::INFINITY, 1001.0] {
            assert_eq!(Exponent::from_number(number), None, "{number}");
        }
    }
}
