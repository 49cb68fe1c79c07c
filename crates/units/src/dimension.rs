//! Dimensions: products of powers of the seven SI base quantities.

/// A rational exponent. Operations that would overflow a small bound return `None`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Exponent {
    numerator: i32,
    denominator: i32,
}

/// Exponents of m, kg, s, A, K, mol, cd.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Dimension([Exponent; 7]);
