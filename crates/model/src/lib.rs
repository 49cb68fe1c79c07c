//! The equation language: from text to a checked system of first-order equations.

mod alphabet;
mod build;
mod compile;
mod diagnostic;
mod differentiate;
mod dimensions;
mod evaluate;
mod expression;
mod functions;
mod graph;
mod lexer;
mod limits;
mod lowering;
mod matching;
mod names;
mod notation;
mod parser;
mod sensitivity;
mod syntax;
mod system;
mod typeset;
mod walk;
mod whole;

pub use compile::compile;
pub use diagnostic::{Diagnostic, Label, Severity, Span, has_errors};
pub use differentiate::{Variable, differentiate, differentiate_all};
pub use expression::{Compiler, Dependence};
pub use graph::{Binary, Graph, LinearSystem, Node, NodeId, Unary};
pub use names::nearest;
pub use parser::{Assignment, parse, parse_assignments, parse_expression};
pub use syntax::*;
pub use system::*;
pub use typeset::{typeset_expression, typeset_name};
