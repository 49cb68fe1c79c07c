//! A power of a quantity, as it is typed.

use crate::pooling::Measured;
use core::fmt;
use units::number::Style;
use units::number::typed::{counted, whole};
use units::{Dimension, Exponent, Words, words};

/// Greatest exponent.
const MOST: i64 = 9;

/// A power of a quantity: `L`, `omega_0^2`, `1/L`, `2/L^3`.
#[derive(Clone, Debug, PartialEq)]
pub struct Power {
    text: String,
    /// Name of the quantity.
    name: String,
    factor: f64,
    exponent: i32,
}

impl Power {
    /// The quantity itself.
    pub fn first(name: &str) -> Self {
        Self { text: name.to_owned(), name: name.to_owned(), factor: 1.0, exponent: 1 }
    }

    /// Reads a power: a name, `^` with a whole exponent from 1 to 9 where it is not 1, and before it `1/` or another number
    /// over it.
    ///
    /// # Errors
    /// The text is no such power.
    pub fn parse(text: &str) -> Result<Self, Words> {
        let refused =
            || words!("{text} is no power of a quantity: write a name, a power or a number over it, as L, L^2, 1/L");
        let typed = text.trim();
        let (factor, sign, power) = match typed.split_once('/') {
            Some((factor, power)) => (counted(factor, "", Style::POINT).map_err(|_| refused())?, -1, power),
            None => (1.0, 1, typed),
        };
        let (name, exponent) = match power.split_once('^') {
            Some((name, exponent)) => (name, whole(exponent, 1..=MOST, Style::POINT).map_err(|_| refused())?),
            None => (power, 1),
        };
        let exponent = i32::try_from(exponent).unwrap_or_default();
        let name = name.trim();
        let is_name = !name.is_empty() && name.chars().all(|one| one.is_alphanumeric() || "_.[]".contains(one));
        if !is_name || !f64::is_finite(factor) || factor == 0.0 {
            return Err(refused());
        }
        Ok(Self { text: typed.to_owned(), name: name.to_owned(), factor, exponent: sign * exponent })
    }

    /// Name of the quantity.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The power of a value.
    pub fn raise(&self, value: f64) -> f64 {
        self.factor * libm::pow(value, f64::from(self.exponent))
    }

    /// The power of a result, with its standard error to first order.
    pub fn raise_measured(&self, Measured { value, error }: Measured) -> Measured {
        let exponent = f64::from(self.exponent);
        let slope = self.factor * exponent * libm::pow(value, exponent - 1.0);
        Measured { value: self.raise(value), error: slope.abs() * error }
    }

    /// Dimension of the power; `None` if its exponents are too large.
    pub fn dimension(&self, of: Dimension) -> Option<Dimension> {
        of.power(Exponent::new(i64::from(self.exponent), 1)?)
    }
}

/// The power as it was typed.
impl fmt::Display for Power {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&self.text)
    }
}
