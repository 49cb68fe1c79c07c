//! The equation language: from text to a checked system of first-order equations.

mod build;
mod compile;
mod diagnostic;
mod differentiate;
mod evaluate;
mod expression;
mod graph;
mod syntax;
mod system;
mod walk;

pub use compile::compile;
pub use diagnostic::{Diagnostic, Label, Severity, Span, has_errors};
pub use differentiate::{Variable, differentiate, differentiate_all};
pub use expression::Dependence;
pub use graph::{Binary, Graph, LinearSystem, Node, NodeId, Unary};
pub use syntax::*;
pub use system::*;
