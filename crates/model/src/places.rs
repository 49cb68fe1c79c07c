//! Where the parts of a model stand in its text, for messages about them.

use crate::Span;

/// Where the parts of a [`program::Model`] stand in its source, by their indices.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Places {
    /// Where each parameter is declared.
    pub parameters: Vec<Span>,
    /// Where the initial value of each state is given.
    pub states: Vec<Span>,
    /// Where each event stands.
    pub events: Vec<Span>,
}
