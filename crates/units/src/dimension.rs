//! Dimensions: products of powers of the seven SI base quantities, and of pixels.
//!
//! A pixel is a quantity of its own and not a pure number: how long it is differs from film to film, and a position in pixels must
//! neither fit an angle nor, before the film has a scale, a length.

use crate::Exponent;
use std::fmt;

/// The symbols of the base units, in the order in which dimensions are printed.
const BASE: [&str; 8] = ["kg", "m", "s", "A", "K", "mol", "cd", "px"];

/// Exponents of kg, m, s, A, K, mol, cd, px.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Dimension([Exponent; 8]);

impl Dimension {
    /// A pure number.
    pub const NONE: Self = Self([Exponent::ZERO; 8]);
    /// kg
    pub const MASS: Self = Self::base_quantity(0);
    /// m
    pub const LENGTH: Self = Self::base_quantity(1);
    /// s
    pub const TIME: Self = Self::base_quantity(2);
    /// px
    pub const PIXEL: Self = Self::base_quantity(7);

    const fn base_quantity(index: usize) -> Self {
        let mut exponents = [Exponent::ZERO; 8];
        exponents[index] = Exponent::ONE;
        Self(exponents)
    }

    /// From whole exponents of kg, m, s, A, K, mol, cd.
    pub fn from_whole(exponents: [i8; 7]) -> Self {
        let mut dimension = Self::NONE;
        dimension.0.iter_mut().zip(exponents).for_each(|(to, exponent)| *to = Exponent::from(exponent));
        dimension
    }

    /// Whether it becomes `other` once a pixel has a length: that of a film without a scale, beside that of a model.
    pub fn lacks_scale_for(self, other: Self) -> bool {
        let [_, lengths, .., pixels] = self.0;
        let mut scaled = self;
        let sum = lengths.plus(pixels);
        scaled.0[7] = Exponent::ZERO;
        scaled.0[1] = sum.unwrap_or(lengths);
        !pixels.is_zero() && sum.is_some() && scaled == other
    }

    /// Whether it is a pure number.
    pub fn is_none(&self) -> bool {
        *self == Self::NONE
    }

    /// The dimension of a product; `None` when an exponent leaves [`Exponent`]'s bound.
    pub fn times(self, other: Self) -> Option<Self> {
        let mut product = self;
        for (exponent, more) in product.0.iter_mut().zip(other.0) {
            *exponent = exponent.plus(more)?;
        }
        Some(product)
    }

    /// The dimension of a quotient; `None` when an exponent leaves [`Exponent`]'s bound.
    pub fn per(self, other: Self) -> Option<Self> {
        self.times(other.inverse())
    }

    /// The dimension of the reciprocal.
    pub fn inverse(self) -> Self {
        Self(self.0.map(Exponent::negated))
    }

    /// The dimension of a power; `None` when an exponent leaves [`Exponent`]'s bound.
    pub fn power(self, power: Exponent) -> Option<Self> {
        let mut result = self;
        for exponent in &mut result.0 {
            *exponent = exponent.times(power)?;
        }
        Some(result)
    }

    /// The dimension of an n-th root; `None` for `degree` 0 and beyond [`Exponent`]'s bound.
    pub fn root(self, degree: u32) -> Option<Self> {
        self.power(Exponent::new(1, i64::from(degree))?)
    }

    /// The base units it is made of, each with its exponent, which is not 0: `kg`, `m`, `s`, `A`, `K`, `mol`, `cd`, `px`.
    pub fn base(&self) -> impl Iterator<Item = (&'static str, Exponent)> + '_ {
        BASE.into_iter().zip(self.0).filter(|(_, exponent)| !exponent.is_zero())
    }
}

/// Base units, `kg m^-1 s^-2`; `1` for a pure number.
impl fmt::Display for Dimension {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.is_none() {
            return formatter.write_str("1");
        }
        for (index, (symbol, exponent)) in self.base().enumerate() {
            if index > 0 {
                formatter.write_str(" ")?;
            }
            formatter.write_str(symbol)?;
            if !exponent.is_whole() {
                write!(formatter, "^({exponent})")?;
            } else if exponent != Exponent::ONE {
                write!(formatter, "^{exponent}")?;
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn products_quotients_powers_and_roots() {
        let speed = Dimension::LENGTH.per(Dimension::TIME).unwrap();
        assert_eq!(speed.to_string(), "m s^-1");
        let energy = Dimension::MASS.times(speed.power(Exponent::from(2)).unwrap()).unwrap();
        assert_eq!(energy.to_string(), "kg m^2 s^-2");
        assert_eq!(energy.per(Dimension::MASS).unwrap().root(2), Some(speed));
        assert_eq!(Dimension::LENGTH.root(2).unwrap().to_string(), "m^(1/2)");
        assert_eq!(speed.per(speed), Some(Dimension::NONE));
        assert_eq!(Dimension::NONE.to_string(), "1");
        assert_eq!(speed.root(0), None);
    }

    #[test]
    fn repeated_squaring_ends_in_none_and_not_in_an_overflow() {
        let mut dimension = Some(Dimension::LENGTH);
        for _ in 0..40 {
            dimension = dimension.and_then(|d| d.times(d));
        }
        assert_eq!(dimension, None);
    }

    #[test]
    fn pixels_are_lengths_without_a_scale() {
        let speed = Dimension::LENGTH.per(Dimension::TIME).unwrap();
        let in_pixels = Dimension::PIXEL.per(Dimension::TIME).unwrap();
        assert!(in_pixels.lacks_scale_for(speed) && Dimension::PIXEL.lacks_scale_for(Dimension::LENGTH));
        assert!(!in_pixels.lacks_scale_for(Dimension::LENGTH) && !speed.lacks_scale_for(speed));
        assert!(!in_pixels.lacks_scale_for(in_pixels) && !Dimension::PIXEL.lacks_scale_for(Dimension::NONE));
        assert_eq!(in_pixels.to_string(), "s^-1 px");
    }

    #[test]
    fn tells_its_base_units() {
        let dimension = Dimension::from_whole([1, -1, -2, 0, 0, 0, 0]);
        let base: Vec<_> = dimension.base().map(|(symbol, exponent)| format!("{symbol}:{exponent}")).collect();
        assert_eq!(base, ["kg:1", "m:-1", "s:-2"]);
    }
}
