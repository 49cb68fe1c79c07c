//! What kinds of values there are, and of which kind is what has a name.

use super::form::Form;
use crate::Span;
use program::Kind;
use units::{Words, words};

/// What an expression's value is.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Type {
    /// A number of this dimension.
    Number(Form),
    /// True or false.
    Truth,
    /// A text.
    Text,
    /// Something is wrong with it and has been reported; nothing more is said about what depends on it.
    Unknown,
}

/// What is known about the names of a model.
#[derive(Clone, Debug)]
pub(crate) struct Types {
    pub independent: Form,
    pub parameters: Vec<Form>,
    /// Where the number of each parameter and its unit stand; nothing where the parameters are those of another text.
    pub parameter_places: Vec<ParameterPlace>,
    /// What the value of each parameter is.
    pub parameter_kinds: Vec<Kind>,
    pub definitions: Vec<Type>,
    /// The values of definitions that are plain numbers, for exponents.
    pub numbers: Vec<Option<f64>>,
    /// The dimension of each unknown function, without primes.
    pub unknowns: Vec<Form>,
    /// The names of the unknown functions.
    pub unknown_names: Vec<String>,
}

/// Where a parameter's number and its unit in brackets stand, and whether they can be relied on.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ParameterPlace {
    pub value: Span,
    pub unit: Option<Span>,
    /// Whether an equation or a stated unit uses the parameter and fits: its own unit is then hardly to blame for what does not fit.
    pub is_confirmed: bool,
}

impl Type {
    /// What it is called after "is".
    pub fn described(&self) -> Words {
        match self {
            Self::Number(_) => words("a number", "un número"),
            Self::Truth => words("true or false", "un valor lógico"),
            Self::Text => words("a text", "un texto"),
            Self::Unknown => words("unknown", "desconocido"),
        }
    }
}
