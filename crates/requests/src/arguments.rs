//! Values in requests as the texts that `runner` reads. Python writes a number so that it reads back as the same bits.

use runner::names::Assignment;
use serde::Deserialize;
use units::Unit;

/// Text of a value: a number in the declared unit, or a text such as `3 cm` or `3 [cm]`.
#[derive(Clone, Debug, Deserialize)]
#[serde(transparent)]
pub struct Given(String);

/// One value or several.
#[derive(Clone, Debug, Deserialize)]
#[serde(untagged)]
pub enum OneOrMany {
    /// One value.
    One(Given),
    /// Several values.
    Many(Vec<Given>),
}

/// Values by name.
pub type GivenByName = Vec<(String, OneOrMany)>;

impl Given {
    /// `3 cm` as `3 [cm]`, as documents write it; another text as it is.
    pub fn text(&self) -> String {
        let text = self.0.trim();
        let end =
            text.find(|letter: char| !(letter.is_ascii_digit() || "+-.eE".contains(letter))).unwrap_or(text.len());
        let (number, unit) = (&text[..end], text[end..].trim());
        if number.parse::<f64>().is_ok() && !unit.is_empty() && Unit::parse(unit).is_ok() {
            format!("{number} [{unit}]")
        } else {
            text.to_owned()
        }
    }
}

impl OneOrMany {
    /// The text of the value. Several values are joined by commas.
    pub fn text(&self) -> String {
        match self {
            Self::One(value) => value.text(),
            Self::Many(values) => values.iter().map(Given::text).collect::<Vec<_>>().join(", "),
        }
    }
}

/// Text of an optional value.
pub fn text(given: Option<&Given>) -> Option<String> {
    given.map(Given::text)
}

/// Assignments of values by name.
pub fn assignments(given: &GivenByName) -> Vec<Assignment> {
    given.iter().map(|(name, value)| Assignment { name: name.clone(), value: value.text() }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_unit_behind_a_number_gets_brackets() {
        for (given, expected) in [
            ("3", "3"),
            (" 3 cm ", "3 [cm]"),
            ("3 [cm]", "3 [cm]"),
            ("-2.5e-3kg/s", "-2.5e-3 [kg/s]"),
            ("2*h", "2*h"),
            ("3 nonsense", "3 nonsense"),
            ("on", "on"),
        ] {
            assert_eq!(Given(given.to_owned()).text(), expected);
        }
    }
}
