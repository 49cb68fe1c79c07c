//! Hand-ins in the page: reading them, computing their values again, and the result for a dropped one.

pub mod dialog;
pub mod reading;
pub mod recomputing;
pub mod sender;
pub mod verdict;
