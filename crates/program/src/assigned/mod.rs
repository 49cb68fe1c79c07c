//! Values assigned to each student: functions of an assignment, a parameter and a seat, in integer arithmetic, so that page,
//! command line and server agree to the bit.
//!
//! Seats stand in blocks of eight. Within a block each parameter takes every eighth of its range once, in an order that
//! depends on assignment, parameter and block, at a random value of the eighth. A class of 8 n seats therefore has exactly
//! 2 n values in each quarter of each range. A block in which a seat would equal an earlier one is drawn again.

mod draws;
mod grid;
mod hash;
pub(crate) mod seat;
#[cfg(test)]
mod tests;

pub use grid::{Assigned, Grid, GridFault};
pub use seat::Seat;

pub(crate) use draws::Draws;
