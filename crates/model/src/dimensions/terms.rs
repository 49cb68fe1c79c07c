//! Groups of expressions that must have one dimension.

use super::form::Form;
use crate::Expression;
use crate::notation::quote;
use units::{Words, words};

pub(super) const LEFT_SIDE: Words = words("left side");
pub(super) const RIGHT_SIDE: Words = words("right side");

/// One of several expressions that must have one dimension. The form is `None` if an error was already reported.
#[derive(Clone, Debug)]
pub(crate) struct Term<'e> {
    pub expression: &'e Expression,
    pub form: Option<Form>,
}

/// Construct in which several expressions must have one dimension.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Place {
    /// The terms of a sum, or of both sides of an equation.
    Sum,
    /// The sides of a comparison or an equation.
    Sides,
    /// The arguments of a function.
    Arguments,
    /// The branches of `if`.
    Branches,
    /// The components of a vector.
    Components,
}

impl Place {
    /// Noun phrase for one of the expressions in a message.
    pub(super) fn part(self, index: usize, term: &Expression) -> Words {
        match (self, index) {
            (Self::Sum, _) => words!("the term `{}`", quote(term)),
            (Self::Sides, 0) => words!("the {side}", side = LEFT_SIDE),
            (Self::Sides, _) => words!("the {side}", side = RIGHT_SIDE),
            (Self::Arguments, _) => words!("the argument `{}`", quote(term)),
            (Self::Components, _) => words!("the component `{}`", quote(term)),
            (Self::Branches, _) => words!("the branch `{}`", quote(term)),
        }
    }
}
