//! Elementary functions with the same bits on every target, for one number or for many side by side.
//!
//! A function is straight-line code of additions, multiplications, divisions and bit operations: no tables, no fused
//! multiply-add, no rounding instruction. The vectorizer can therefore compute as many lanes at once as the processor has,
//! and each lane has the bits of the scalar function. Where a scalar function takes a shorter way (a small angle, one
//! quadrant), the omitted operations would not have changed a bit.
//!
//! - **Invariant:** a lane and a single number have the same bits, on every target.
//! - **Invariant:** the error is below [`ULPS`].
//!
//! ```
//! let mut values = [0.1, 0.2, 3.0];
//! elementary::sin_all(&mut values);
//! assert_eq!(values[1].to_bits(), elementary::sin(0.2).to_bits());
//! ```
//!
//! Rare arguments go to `libm`: angles beyond 10^5, logarithms and powers of numbers that are not positive and normal,
//! exponents beyond 10^18, angles of points with a coordinate of 0 or an extreme one. So do `cbrt`, `asin`, `acos`, `asinh`,
//! `acosh`, `atanh` and `log10`, which are not in this crate.
//!
//! Coefficients of polynomials are minimax coefficients (Remez), rounded one after the other; the others are fitted again
//! after each rounding. The tests compare with exact values (`tests/exact`, made by `make.py`);
//! `cargo run --release --package elementary --example pace` compares the speed with that of `libm`.
//!
//! Why no library, November 2026: `sleef` 0.3 needs `portable_simd` of the nightly compiler; `wide` 1.7 and `pxfm` 0.1 fuse
//! multiplication and addition where the processor can, so that bits depend on it; `alice-det-math` 0.3 has lanes of `f32`
//! only; `simdeez` 3.0 promises 35 units in the last place; `fpmath` 0.1 and `libm` 0.2 branch in every function; `pulp` and
//! `fearless_simd` have no elementary functions.

mod arctangent;
mod circular;
mod exponential;
mod hyperbolic;
mod lanes;
mod logarithm;
mod pair;
mod power;

pub use arctangent::{atan, atan2};
pub use circular::{cos, sin, tan};
pub use exponential::exp;
pub use hyperbolic::{cosh, sinh, tanh};
pub use lanes::{
    atan_all, atan2_all, cos_all, cosh_all, exp_all, ln_all, pow_all, sin_all, sinh_all, tan_all, tanh_all,
};
pub use logarithm::ln;
pub use power::pow;

/// Upper bound of the error of every function, in units in the last place of the exact value.
pub const ULPS: f64 = 0.95;
