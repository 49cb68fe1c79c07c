//! Source places of the parts of a model, for messages.

use crate::Span;

/// Source places of the parts of a [`program::Model`], by their indices.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Places {
    /// Declaration of each parameter.
    pub parameters: Vec<Span>,
    /// Initial value of each state.
    pub states: Vec<Span>,
    /// Statement of each event.
    pub events: Vec<Span>,
}
