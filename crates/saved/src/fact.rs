//! A value that follows from work.

use crate::Number;
use serde::{Deserialize, Serialize};
use units::{Words, words};

/// Value of a fact about data that follow from other data of the work, such as the record of a film.
pub const FOLLOWS: &str = "follows";
/// Value of such a fact if they do not. It never holds, also if it is stated.
pub const FOLLOWS_NOT: &str = "does not follow";

/// The part of the work that a fact is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Part {
    /// The run that is shown.
    Run,
    /// An answer to a question.
    Answer,
    /// A record.
    Record,
    /// The work on a film.
    Film,
    /// A fit.
    Fit,
    /// A section of the report that carries the hand-in.
    Report,
}

impl Part {
    /// Name of the part.
    pub fn words(self) -> Words {
        match self {
            Self::Run => words("run"),
            Self::Answer => words("answer"),
            Self::Record => words("record"),
            Self::Film => words("film"),
            Self::Fit => words("fit"),
            Self::Report => words("report"),
        }
    }
}

/// Value of a fact.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum FactValue {
    /// A number, in SI units.
    Number(Number),
    /// A text, such as a grade or the hash of a table.
    Text(String),
}

impl PartialEq for FactValue {
    /// Compares numbers by their bits: 0 differs from -0. Two values that are not a number are equal.
    fn eq(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Number(Number(one)), Self::Number(Number(other))) => {
                one.to_bits() == other.to_bits() || one.is_nan() && other.is_nan()
            }
            (Self::Text(one), Self::Text(other)) => one == other,
            _ => false,
        }
    }
}

/// A value that follows from the work.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Fact {
    /// Part of the work.
    pub part: Part,
    /// The record, fit or film by its name, or the question by its number.
    pub item: String,
    /// Identifier of the quantity, see [`super::hand_in::quantity_text`].
    pub quantity: String,
    /// The value.
    #[serde(flatten)]
    pub value: FactValue,
}
