//! Dimensions of expressions: inferred where not stated, and checked everywhere.

mod call;
mod check;
mod describe;
mod expansion;
mod form;
mod infer;
mod mismatch;
mod remedy;
mod terms;
mod tuple;
mod types;

pub(crate) use check::check_dimensions;
pub(crate) use form::{Form, Solver};
pub(crate) use infer::Inference;
pub(crate) use types::{Type, Types};
