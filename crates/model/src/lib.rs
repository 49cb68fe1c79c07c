//! The equation language: from text to a checked system of first-order equations.
//!
//! [`compile()`] turns text into [`Checked`]: the [`program::Model`], the statements as the author wrote them (for
//! typesetting), and [`Places`], the spans of parameters, states and events by their indices. [`Compiler`] adds further
//! expressions of a document to the graph of a model. The stages, in order:
//!
//! | module | stage |
//! |---|---|
//! | `lexer`, `parser`, `syntax` | text to tokens to statements; the grammar is in the first lines of `parser/mod.rs` |
//! | `families`, `vectors`, `functions` | families (`x[i] for i in 1..N`), vectors, the author's functions are written out |
//! | `moments`, `so_far`, `ticks`, `maps`, `chance`, `choices` | the same for remembered values, maps, draws, choices |
//! | `names` | declarations, meaning of each name, order of the definitions, unknowns of the equations |
//! | `dimensions` | dimensions are inferred and checked |
//! | `lowering`, `matching` | the equations are solved for the highest derivatives and become nodes of the graph |
//!
//! Behind the first three rows all stages deal with single quantities only, whose names may be `x[3]` and `r.x`. What a run
//! remembers becomes discrete quantities, definitions and events with names that no text can give, such as `landing.x` or
//! `maximum(y) so far`; such states ([`program::Role::Remembered`]) and quantities ([`program::Quantity::remembered`]) are
//! shown nowhere. [`program::Model::sizes`] says with which sizes of families a model was built; another size means another
//! model (`document::resized`). Dry friction is nothing that the engine knows: `lowering/friction.rs` turns each
//! `coulomb(v, F)` into a state that only events change, the force that keeps `v` at 0, and two events.
//!
//! Beside the stages: `formatting` gives the text of a model its layout from the tokens alone (`gaps.rs`: blanks between two
//! of them, `columns.rs`: alignment of neighbouring lines); [`sentence()`] reads the parts of a document that are no
//! statements; `typeset` writes MathML; [`Diagnostic`] is the message of every stage.
//!
//! - **Invariant:** parsing cannot fail. Every stage returns a value and a list of diagnostics. A part that could not be read
//!   is an `Error` in the tree, and later stages report nothing more about it.
//! - **Invariant:** no documents, no solvers. A span counts bytes of a source.
//! - **Invariant:** work is bounded. `limits.rs` bounds bytes, statements, states and nodes; a model beyond them gets a
//!   diagnostic.

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
