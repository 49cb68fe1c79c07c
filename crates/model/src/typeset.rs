//! The model's equations as a textbook prints them: MathML Core from the syntax tree.

use crate::{Expression, Model};

impl Model {
    /// Each displayed statement as a `<math display="block">` element.
    pub fn typeset(&self) -> Vec<String> {
        Vec::new()
    }
}

/// An expression as a `<math>` element.
pub fn typeset_expression(expression: &Expression) -> String {
    let _ = expression;
    String::new()
}

/// A name, with its primes if it has any, as a `<math>` element.
pub fn typeset_name(name: &str) -> String {
    name.to_owned()
}
