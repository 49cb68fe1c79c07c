//! Functions of the author's own. A call is written out: the body of the function with the arguments in it takes its place
//! before names get their meanings, so that units, dependences and derivatives are those of each call.

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

/// The functions that the statements of a model declare.
#[derive(Clone, Debug, Default)]
pub struct Functions {
    by_name: BTreeMap<String, Function>,
}

impl Functions {
    /// Their names, in alphabetical order.
    pub(crate) fn names(&self) -> impl Iterator<Item = &str> {
        self.by_name.keys().map(String::as_str)
    }
}

/// One of them.
#[derive(Clone, Debug)]
struct Function {
    name: String,
    /// The names of its arguments.
    parameters: Vec<String>,
    /// Its value as it is written, with calls in it.
    body: Expression,
    unit: Option<StatedUnit>,
    /// Where its name is declared.
    span: Span,
}
