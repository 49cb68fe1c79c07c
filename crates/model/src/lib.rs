//! The equation language: from text to a checked system of first-order equations.

mod bare_numbers;
mod chance;
mod choices;
mod compile;
mod components;
mod diagnostic;
mod dimensions;
mod discrete_kinds;
mod expression;
mod families;
mod formatting;
mod functions;
mod groups;
mod lexer;
mod limits;
mod lowering;
mod maps;
mod matching;
mod moments;
mod names;
mod notation;
mod of_runs;
mod parser;
mod places;
mod sentence;
mod so_far;
mod spanish_functions;
mod syntax;
mod tables;
mod ticks;
mod typeset;
mod vectors;

pub use bare_numbers::in_declared_unit;
pub use compile::{Checked, check, compile, refuse_length};
pub use diagnostic::{Diagnostic, Edit, Fix, Label, Severity, Span, has_errors};
pub use expression::Compiler;
pub use formatting::{Form, format, spaced};
pub use functions::Functions;
pub use lowering::turned;
pub use parser::{parse, parse_assignments, parse_expression};
pub use places::Places;
pub use sentence::{
    Clause, Grammar, Keyword, Lexeme, LexemeKind, Operand, Phrase, Sentence, Split, inside, lexemes, outside, sentence,
    sentences,
};
pub use syntax::*;
pub use typeset::{typeset, typeset_each, typeset_expression, typeset_one};
