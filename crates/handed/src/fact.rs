//! A value that follows from work.

use crate::Number;
use crate::json::{self, Object};
use serde::Deserialize;
use units::{Words, words};

/// Value of a fact about data that follow from other data of the work, such as the record of a film.
pub const FOLLOWS: &str = "follows";
/// Value of such a fact if they do not. It never holds, also if it is stated.
pub const FOLLOWS_NOT: &str = "does not follow";

/// The part of the work that a fact is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Deserialize)]
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
    /// Code in the file.
    pub fn code(self) -> &'static str {
        match self {
            Self::Run => "run",
            Self::Answer => "answer",
            Self::Record => "record",
            Self::Film => "film",
            Self::Fit => "fit",
            Self::Report => "report",
        }
    }

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
#[derive(Clone, Debug, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum FactValue {
    /// A number, in SI units.
    Number(Number),
    /// A text, such as a grade or the hash of a table.
    Text(String),
}

impl FactValue {
    /// The value in JSON, `{"number": 1}` or `{"text": "a"}`.
    pub fn json(&self) -> String {
        self.with(Object::default()).end()
    }

    /// Adds the value to an object.
    fn with(&self, object: Object) -> Object {
        match self {
            Self::Number(Number(value)) => object.with("number", json::number(*value)),
            Self::Text(text) => object.with("text", json::text(text)),
        }
    }
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
#[derive(Clone, Debug, PartialEq, Deserialize)]
pub struct Fact {
    /// Part of the work.
    pub part: Part,
    /// The record, fit or film by its name, or the question by its number.
    pub item: String,
    /// Identifier of the quantity, see `saved::hand_in::quantity_text`.
    pub quantity: String,
    /// The value.
    #[serde(flatten)]
    pub value: FactValue,
}

impl Fact {
    /// The fact in JSON.
    pub fn json(&self) -> String {
        let fact = Object::default()
            .with("part", json::text(self.part.code()))
            .with("item", json::text(&self.item))
            .with("quantity", json::text(&self.quantity));
        self.value.with(fact).end()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_fact_reads_back_with_its_bits() {
        let parts = [Part::Run, Part::Answer, Part::Record, Part::Film, Part::Fit, Part::Report];
        let values = [0.1 + 0.2, -0.0, f64::NAN].map(|value| FactValue::Number(Number(value)));
        for (part, value) in parts
            .into_iter()
            .zip(values.into_iter().chain(["a\n\"", "b", "c"].map(|text| FactValue::Text(text.to_owned()))))
        {
            let fact = Fact { part, item: "a: \u{2028}".to_owned(), quantity: "value:x'".to_owned(), value };
            assert_eq!(serde_json::from_str::<Fact>(&fact.json()).unwrap(), fact);
        }
    }
}
