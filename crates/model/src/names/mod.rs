//! Names: what is declared, what each name means, in which order definitions can be computed, and which names are the
//! unknowns of the equations.

mod check;
mod events;
mod order;
mod program;
mod scope;
mod traverse;
mod unknowns;

pub(crate) use check::NameCheck;
pub(crate) use events::check_event;
pub(crate) use order::{alternatives, definition_order, list};
pub(crate) use program::{Equation, EventEntry, InitialEntry, ParameterEntry, Program};
pub use scope::nearest;
pub(crate) use scope::{Meaning, Scope};
pub(crate) use traverse::{children, for_each, for_each_name};
pub(crate) use unknowns::{Unknown, find_unknowns};
