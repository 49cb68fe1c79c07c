//! The equation language: from text to a checked system of first-order equations.

mod diagnostic;
mod graph;
mod syntax;
mod system;

pub use diagnostic::{Diagnostic, Label, Severity, Span, has_errors};
pub use graph::{Binary, Graph, LinearSystem, Node, NodeId, Unary};
pub use syntax::*;
pub use system::*;
