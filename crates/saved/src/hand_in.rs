//! A hand-in: one file with the work of a student or a group, and the numbers that follow from it.
//!
//! ```json
//! {"meniscus hand-in":1,"program":"0.1.0","made":1763812800000,
//!  "sender":{"name":"blue heron 17","seat":7,"assignment":"tube-2026"},
//!  "work":{"meniscus project":1,"documents":[],"state":"","items":[]},
//!  "facts":[{"part":"fit","item":"Linear damping: film.csv","quantity":"gamma","number":0.4}]}
//! ```
//!
//! The facts can be computed again from the work, bit for bit. Unknown fields are ignored.

use crate::Number;
use crate::project::{Project, ProjectError};
use serde::{Deserialize, Serialize};
use serde_json::value::RawValue;
use units::{Words, words};

/// Version of the format.
const VERSION: u32 = 1;

/// Maximum size of a hand-in, in bytes.
pub const LONGEST_HAND_IN: usize = 64 << 20;

/// Maximum number of facts.
const MOST_FACTS: usize = 100_000;

/// Maximum length of the name of a sender, in characters.
pub const LONGEST_NAME: usize = 100;

/// Extension of files with a hand-in.
pub const HAND_IN_ENDING: &str = ".hand-in";

/// The student or the group that hands in.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct Sender {
    /// Pseudonym or name of the group.
    pub name: String,
    /// Seat, from 1; `None` if no values were assigned.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub seat: Option<u32>,
    /// Identifier of the assignment; empty if there is none.
    #[serde(skip_serializing_if = "String::is_empty")]
    pub assignment: String,
}

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
}

impl Part {
    /// Name of the part.
    pub fn words(self) -> Words {
        match self {
            Self::Run => words("run", "simulación"),
            Self::Answer => words("answer", "respuesta"),
            Self::Record => words("record", "serie de datos"),
            Self::Film => words("film", "vídeo"),
            Self::Fit => words("fit", "ajuste"),
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
    /// Name of the quantity.
    pub quantity: String,
    /// The value.
    #[serde(flatten)]
    pub value: FactValue,
}

/// Content of a hand-in.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct HandIn {
    /// Version of the program that made it.
    pub program: String,
    /// Time at which it was made, in milliseconds since 1970.
    pub made: u64,
    /// The student or the group.
    pub sender: Sender,
    /// Document, state, and items.
    pub work: Project,
    /// The values stated to follow from the work.
    pub facts: Vec<Fact>,
}

/// Reason why a file cannot be read as a hand-in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HandInError {
    /// Longer than [`LONGEST_HAND_IN`], or too many parts.
    TooLarge,
    /// Written by a later version of the program.
    LaterVersion,
    /// JSON of another kind.
    Other,
    /// Cut off, or changed so that it cannot be read.
    Damaged,
}

impl HandInError {
    /// Description for the user.
    pub fn words(self) -> Words {
        match self {
            Self::TooLarge => words("is too large for a hand-in", "es demasiado grande para ser una entrega"),
            Self::LaterVersion => words(
                "was made by a later version of Meniscus; verify it with that version",
                "se hizo con una versión posterior de Meniscus; compruébalo con esa versión",
            ),
            Self::Other => words("is no hand-in of Meniscus", "no es una entrega de Meniscus"),
            Self::Damaged => words("is damaged; ask for it again", "está dañado; pide que te lo envíen otra vez"),
        }
    }
}

#[derive(Serialize, Deserialize)]
struct Written {
    #[serde(rename = "meniscus hand-in")]
    version: u32,
    #[serde(default)]
    program: String,
    #[serde(default)]
    made: u64,
    sender: Sender,
    work: Box<RawValue>,
    facts: Vec<Fact>,
}

#[derive(Deserialize)]
struct Version {
    #[serde(rename = "meniscus hand-in")]
    version: u32,
}

impl HandIn {
    /// Content of the file.
    pub fn write(&self) -> String {
        // A project, texts and numbers can always be serialised.
        let Ok(work) = RawValue::from_string(self.work.write()) else { return String::new() };
        let written = Written {
            version: VERSION,
            program: self.program.clone(),
            made: self.made,
            sender: self.sender.clone(),
            work,
            facts: self.facts.clone(),
        };
        serde_json::to_string(&written).unwrap_or_default()
    }

    /// Reads the content of a file.
    ///
    /// # Errors
    /// If the text is not a hand-in, or is too large.
    pub fn read(text: &str) -> Result<Self, HandInError> {
        if text.len() > LONGEST_HAND_IN {
            return Err(HandInError::TooLarge);
        }
        let Version { version } = match serde_json::from_str(text) {
            Ok(version) => version,
            Err(error) if error.is_data() => return Err(HandInError::Other),
            Err(_) => return Err(HandInError::Damaged),
        };
        if version > VERSION {
            return Err(HandInError::LaterVersion);
        }
        let Written { program, made, mut sender, work, facts, .. } =
            serde_json::from_str(text).map_err(|_| HandInError::Damaged)?;
        if facts.len() > MOST_FACTS {
            return Err(HandInError::TooLarge);
        }
        let work = Project::read(work.get()).map_err(|error| match error {
            ProjectError::TooLarge => HandInError::TooLarge,
            ProjectError::LaterVersion => HandInError::LaterVersion,
            ProjectError::Unreadable => HandInError::Damaged,
        })?;
        sender.name = sender.name.chars().filter(|c| !c.is_control()).take(LONGEST_NAME).collect();
        Ok(Self { program, made, sender, work, facts })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use document::page::Source;

    fn hand_in() -> HandIn {
        let fact = |quantity: &str, value| Fact {
            part: Part::Fit,
            item: "a: b".to_owned(),
            quantity: quantity.to_owned(),
            value,
        };
        HandIn {
            program: "0.1.0".to_owned(),
            made: 5,
            sender: Sender { name: "blue heron".to_owned(), seat: Some(7), assignment: "tube".to_owned() },
            work: Project {
                documents: vec![Source { name: "a.md".to_owned(), text: "---\n\"ñ\u{2028}".to_owned() }],
                ..Project::default()
            },
            facts: vec![
                fact("gamma", FactValue::Number(Number(0.1 + 0.2))),
                fact("nothing", FactValue::Number(Number(f64::NAN))),
                fact("zero", FactValue::Number(Number(-0.0))),
                fact("grade", FactValue::Text("right".to_owned())),
                fact("typed", FactValue::Text("0.3".to_owned())),
            ],
        }
    }

    #[test]
    fn what_is_written_reads_back() {
        assert_eq!(HandIn::read(&hand_in().write()), Ok(hand_in()));
    }

    #[test]
    fn other_files_are_refused_with_the_reason() {
        let whole = hand_in().write();
        let cases = [
            (String::new(), HandInError::Damaged),
            ("[]".to_owned(), HandInError::Other),
            ("{\"meniscus project\":1}".to_owned(), HandInError::Other),
            (whole.replace("\"meniscus hand-in\":1", "\"meniscus hand-in\":2"), HandInError::LaterVersion),
            (whole.replace("\"meniscus project\":1", "\"meniscus project\":2"), HandInError::LaterVersion),
            (whole.replace("\"documents\":[{", "\"documents\":[],\"x\":[{"), HandInError::Damaged),
            (whole.replace("\"part\":\"fit\"", "\"part\":\"x\""), HandInError::Damaged),
            (format!("{{\"meniscus hand-in\":1,\"x\":{}", "[".repeat(1 << 20)), HandInError::Damaged),
        ];
        for (text, expected) in cases {
            assert_eq!(HandIn::read(&text), Err(expected), "{text:.80}");
        }
        assert_eq!(HandIn::read(&" ".repeat(LONGEST_HAND_IN + 1)), Err(HandInError::TooLarge));
        for end in whole.char_indices().map(|(end, _)| end) {
            assert_eq!(HandIn::read(&whole[..end]), Err(HandInError::Damaged), "{end}");
        }
    }

    #[test]
    fn a_name_is_one_short_line() {
        let long = HandIn { sender: Sender { name: "a\n\u{202e}b".repeat(100), ..Sender::default() }, ..hand_in() };
        let name = HandIn::read(&long.write()).map(|hand_in| hand_in.sender.name);
        assert_eq!(name.map(|name| (name.contains('\n'), name.chars().count())), Ok((false, LONGEST_NAME)));
    }
}
