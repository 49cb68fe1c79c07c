//! Syntax tree: the statements as written, with their places, before names are resolved.

mod bare;
mod expression;
mod locals;
mod name;
mod parts;
mod statement;

pub use expression::{BinaryOperator, Expansion, Expression, ExpressionKind, Over, UnaryOperator};
pub use name::{Name, Quoted, StatedUnit};
pub use statement::{
    Action, Alternative, AssignedRange, Assignment, Bounds, ChoiceStatement, ChosenValue, DrawnRange, EventExtras,
    FunctionStatement, Members, ParameterForm, ParameterStatement, Point, SizeStatement, Statement, StatementKind,
    TableStatement,
};

pub(crate) use parts::{expressions, expressions_mut, independent, rewrite};
