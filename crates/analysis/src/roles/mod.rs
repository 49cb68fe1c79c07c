//! Roles of the columns of a table: independent variables, measured quantities and counters of rows.
//!
//! Roles are decided from names, units and numbers (`decide`, `layout`). Where several readings hold they are in
//! `Table::readings`: the program refuses, the page asks, and no quantity is measured until `Table::against` has chosen one.
//! What a document declares (`Table::suit`) or a person chooses comes before what was read.

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
