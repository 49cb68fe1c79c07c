//! The syntax tree: what the author wrote, with its places, before any name has a meaning.

mod bare;
mod expression;
mod name;
mod parts;
mod statement;

pub use expression::{BinaryOperator, Expansion, Expression, ExpressionKind, Over, UnaryOperator};
pub use name::{Name, Quoted, StatedUnit};
pub use statement::{
    Action, Alternative, Assignment, Bounds, ChoiceStatement, ChosenValue, DrawnRange, EventExtras, FunctionStatement,
    Members, ParameterForm, ParameterStatement, Point, SizeStatement, Statement, StatementKind, TableStatement,
};

pub(crate) use parts::{expressions, expressions_mut, independent, rewrite};
