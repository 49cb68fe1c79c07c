//! Types of values and of names.

use super::form::Form;
use crate::Span;
use program::Kind;
use units::{Words, words};

/// Type of an expression.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Type {
    /// A number of this dimension.
    Number(Form),
    /// True or false.
    Truth,
    /// A text.
    Text,
    /// An error was already reported; no errors that depend on it are reported.
    Unknown,
}

/// Types of the names of a model.
#[derive(Clone, Debug)]
pub(crate) struct Types {
    pub independent: Form,
    pub parameters: Vec<Form>,
    /// Places of the number and the unit of each parameter; empty if the parameters are declared in another text.
    pub parameter_places: Vec<ParameterPlace>,
    /// Kind of value of each parameter.
    pub parameter_kinds: Vec<Kind>,
    pub definitions: Vec<Type>,
    /// Values of definitions that are plain numbers, for use in exponents.
    pub numbers: Vec<Option<f64>>,
    /// Dimension of each unknown function, without primes.
    pub unknowns: Vec<Form>,
    /// Names of the unknown functions.
    pub unknown_names: Vec<String>,
}

/// Places of the number of a parameter and of its unit in brackets.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ParameterPlace {
    pub value: Span,
    pub unit: Option<Span>,
    /// True if a consistent equation or a stated unit uses the parameter. Its own unit is then hardly the cause of a
    /// mismatch.
    pub is_confirmed: bool,
}

impl Type {
    /// Noun phrase after "is" in a message.
    pub fn described(&self) -> Words {
        match self {
            Self::Number(_) => words("a number"),
            Self::Truth => words("true or false"),
            Self::Text => words("a text"),
            Self::Unknown => words("unknown"),
        }
    }
}
