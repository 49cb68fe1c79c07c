//! Names: declarations, meaning of each name, evaluation order of the definitions, and the unknowns of the equations.

mod assigned;
mod check;
mod counts;
mod declarations;
mod events;
mod foreign;
mod members;
mod order;
mod scope;
mod traverse;
mod unknown;
mod unknown_name;
mod unknowns;

pub(crate) use check::NameCheck;
pub(crate) use declarations::{Declarations, Equation, EventEntry, InitialEntry, ParameterEntry, TableEntry};
pub(crate) use events::{check_event, crossing};
pub(crate) use foreign::quotients;
pub(crate) use order::{alternatives, definition_order, list};
pub(crate) use scope::{Meaning, Scope};
pub(crate) use traverse::{for_each, for_each_name};
pub(crate) use unknown::Unknown;
pub(crate) use unknowns::find_unknowns;
