//! Vectors: a statement about vectors is expanded to one statement per component. `r'' = -G*M*r/norm(r)^3` becomes two or
//! three equations of the unknowns `r.x`, `r.y` and `r.z`. All later stages (names, dimensions, lowering) see numbers only.
//!
//! Families and user-defined functions are expanded before. A name is a vector if its definition or its initial value is
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
    /// Expands all vectors in the statements.
    pub fn write_out(&self, statements: &[Statement], diagnostics: &mut Vec<Diagnostic>) -> Vec<Statement> {
        statements::write_out(self, statements, diagnostics)
    }

    /// Components of an expression outside the model; a number is its own single component.
    ///
    /// # Errors
    /// Invalid operations with vectors.
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
    /// Vectors, and invalid operations with them.
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
