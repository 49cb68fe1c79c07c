//! Dimensions: products of powers of the seven SI base quantities and of the pixel.
//!
//! The pixel is a base quantity, not a pure number: its length differs from video to video. A position in pixels must match
//! neither an angle nor, before the video has a scale, a length.

use crate::Exponent;
use std::fmt;

/// Symbols of the base units, in the order in which dimensions are printed.
const BASE: [&str; 8] = ["kg", "m", "s", "A", "K", "mol", "cd", "px"];

/// A dimension: exponents of kg, m, s, A, K, mol, cd, px.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Dimension([Exponent; 8]);

impl Dimension {
    /// Dimension of a pure number.
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

    /// The dimension with these integer exponents of kg, m, s, A, K, mol, cd.
    pub fn from_whole(exponents: [i8; 7]) -> Self {
        let mut dimension = Self::NONE;
        dimension.0.iter_mut().zip(exponents).for_each(|(to, exponent)| *to = Exponent::from(exponent));
        dimension
    }

    /// True if the dimension equals `other` after pixels are replaced by lengths, so that only the scale of a video is
    /// missing.
    pub fn lacks_scale_for(self, other: Self) -> bool {
        let [_, lengths, .., pixels] = self.0;
        let mut scaled = self;
        let sum = lengths.plus(pixels);
        scaled.0[7] = Exponent::ZERO;
        scaled.0[1] = sum.unwrap_or(lengths);
        !pixels.is_zero() && sum.is_some() && scaled == other
    }

    /// True for a pure number.
    pub fn is_none(&self) -> bool {
        *self == Self::NONE
    }

    /// Dimension of a product; `None` if an exponent exceeds the bound of [`Exponent`].
    pub fn times(self, other: Self) -> Option<Self> {
        let mut product = self;
        for (exponent, more) in product.0.iter_mut().zip(other.0) {
            *exponent = exponent.plus(more)?;
        }
        Some(product)
    }

    /// Dimension of a quotient; `None` if an exponent exceeds the bound of [`Exponent`].
    pub fn per(self, other: Self) -> Option<Self> {
        self.times(other.inverse())
    }

    /// Dimension of the reciprocal.
    pub fn inverse(self) -> Self {
        Self(self.0.map(Exponent::negated))
    }

    /// Dimension of a power; `None` if an exponent exceeds the bound of [`Exponent`].
    pub fn power(self, power: Exponent) -> Option<Self> {
        let mut result = self;
        for exponent in &mut result.0 {
            *exponent = exponent.times(power)?;
        }
        Some(result)
    }

    /// Dimension of a root of this degree; `None` for `degree` 0 or if an exponent exceeds the bound of [`Exponent`].
    pub fn root(self, degree: u32) -> Option<Self> {
        self.power(Exponent::new(1, i64::from(degree))?)
    }

    /// Base units with an exponent other than 0, and these exponents: `kg`, `m`, `s`, `A`, `K`, `mol`, `cd`, `px`.
    pub fn base(&self) -> impl Iterator<Item = (&'static str, Exponent)> + '_ {
        BASE.into_iter().zip(self.0).filter(|(_, exponent)| !exponent.is_zero())
    }
}

/// Product of base units, `kg m^-1 s^-2`; `1` for a pure number.
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
