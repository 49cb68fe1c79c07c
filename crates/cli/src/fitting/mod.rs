//! `meniscus fit` and `meniscus rank`: documents as theories of measured data.

pub mod arguments;
pub mod carrying;
mod fit;
mod rank;
mod theory;

pub use fit::fit;
pub use rank::rank;
