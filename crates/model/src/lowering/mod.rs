//! Lowering: from checked statements to the graph of a first-order system.

mod affine;
mod assemble;
mod collect;
mod explain;
mod expression;
mod rank;
mod solve;

pub(crate) use assemble::assemble;
pub(crate) use expression::{Chain, Lowered, Lowering, TooManyNodes};
pub(crate) use solve::too_many_nodes;
