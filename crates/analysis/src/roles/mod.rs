//! Roles of the columns of a table: independent variables, measured quantities and counters of rows.

mod assign;
mod bodies;
mod decide;
mod layout;
mod names;
mod numbers;
mod remark;
mod variable;

pub(crate) use assign::assign;
pub(crate) use names::is_time;
pub use remark::Remark;
pub use variable::Suited;
