//! Vectors: what is written once for a vector is written out for each of its components. `r'' = -G*M*r/norm(r)^3` becomes two or
//! three equations of the unknowns `r.x`, `r.y` and `r.z`. All that follows (names, dimensions, lowering) then has to do with
//! numbers only.
//!
//! Families and functions of the author's own are written out before. A name is a vector if it is defined by one or begins as
//! one; see `find.rs`.

mod expressions;
mod faults;
mod find;
mod known;
mod operations;
mod statements;

pub(crate) use known::Vectors;

use crate::{Diagnostic, Expression, Statement};
use expressions::Writer;
use known::has_tuple;
use std::borrow::Cow;

impl Vectors {
    /// The statements with all vectors written out.
    pub fn write_out(&self, statements: &[Statement], diagnostics: &mut Vec<Diagnostic>) -> Vec<Statement> {
        statements::write_out(self, statements, diagnostics)
    }

    /// An expression that stands for itself, in its components; a number is its only one.
    ///
    /// # Errors
    /// What cannot be done with vectors.
    pub fn components(&self, expression: &Expression) -> Result<Vec<Expression>, Vec<Diagnostic>> {
        if !self.occur && !has_tuple(expression) {
            return Ok(vec![expression.clone()]);
        }
        let mut writer = Writer::new(self);
        let value = writer.value(expression);
        let components = writer.components(value);
        let found = writer.finish();
        if found.is_empty() { Ok(components) } else { Err(found) }
    }

    /// The number that an expression is.
    ///
    /// # Errors
    /// Vectors, and what cannot be done with them.
    pub fn number<'e>(&self, expression: &'e Expression) -> Result<Cow<'e, Expression>, Vec<Diagnostic>> {
        if !self.occur && !has_tuple(expression) {
            return Ok(Cow::Borrowed(expression));
        }
        let mut components = self.components(expression)?;
        match (components.pop(), components.len()) {
            (Some(only), 0) => Ok(Cow::Owned(only)),
            _ => Err(vec![faults::vector_for_number(expression)]),
        }
    }
}
