//! Lowering: from checked statements to the graph of a first-order system.

mod affine;
mod angles;
mod assemble;
mod collect;
mod explain;
mod expression;
mod friction;
mod rank;
mod solve;
mod turns;
mod warnings;

pub(crate) use angles::remark_on_degrees;
pub(crate) use assemble::assemble;
pub(crate) use expression::{Chain, Lowered, Lowering, TooManyNodes};
pub(crate) use friction::frictions;
pub(crate) use solve::too_many_nodes;
pub use turns::turned;
pub(crate) use turns::{TurnUnits, own_unit};
pub(crate) use warnings::warn;
