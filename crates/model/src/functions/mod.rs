//! User-defined functions. A call is replaced by the body of the function with its arguments substituted. This happens
//! before names are resolved, so units, dependences and derivatives are inferred for each call.

mod budget;
mod declare;
mod expand;
mod statements;
mod substitute;

pub(crate) use budget::Budget;
pub(crate) use expand::is_too_deep;
pub(crate) use statements::written_out;

use crate::{Expression, Span, StatedUnit};
use std::collections::BTreeMap;

/// Functions declared by the statements of a model.
#[derive(Clone, Debug, Default)]
pub struct Functions {
    by_name: BTreeMap<String, Function>,
}

impl Functions {
    /// Names of the functions, in alphabetical order.
    pub(crate) fn names(&self) -> impl Iterator<Item = &str> {
        self.by_name.keys().map(String::as_str)
    }
}

/// A user-defined function.
#[derive(Clone, Debug)]
struct Function {
    name: String,
    /// Names of its arguments.
    parameters: Vec<String>,
    /// Body as written, with unexpanded calls.
    body: Expression,
    unit: Option<StatedUnit>,
    /// Place of its declared name.
    span: Span,
}
