//! The subset of JavaScript in which EJS models are written: numbers, texts, conditions, calls, `if`, `var`, `return` and
//! functions. Nothing is executed: the syntax tree is what the translation reads.

mod expressions;
mod lexer;
mod parser;
mod token;
mod tree;

pub(crate) use parser::{parse_expression, parse_program};
pub(crate) use tree::{Expression, Function, Node, Operator, Statement, StatementKind};
