//! `meniscus fit` and `meniscus rank`: documents as theories of measured data.

pub mod arguments;
pub mod carrying;
mod fit;
mod fitted;
mod json;
mod prepare;
mod rank;
mod text;

pub use fit::fit;
pub use rank::rank;
