//! Dimensions of expressions: inferred where not stated, and checked everywhere.

mod alike;
mod call;
mod check;
mod describe;
mod expansion;
mod form;
mod infer;
mod mismatch;
mod once;
mod remedy;
mod terms;
#[cfg(test)]
mod tests;
mod tuple;
mod types;

pub(crate) use alike::Alike;
pub(crate) use check::check_dimensions;
pub(crate) use form::{Form, Solver};
pub(crate) use infer::Inference;
pub(crate) use types::{Type, Types};
