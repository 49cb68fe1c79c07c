//! A hand-in: one file with the work of a student or a group, and the numbers that follow from it.
//!
//! ```json
//! {"meniscus hand-in":2,"program":"0.3.0","bits":1,"made":1763812800000,
//!  "sender":{"name":"blue heron 17","seat":7,"assignment":"tube-2026"},
//!  "work":{"meniscus project":1,"documents":[],"state":"","items":[]},
//!  "facts":[{"part":"fit","item":"Linear damping: film.csv","quantity":"value:gamma","number":0.4}]}
//! ```
//!
//! A file can also hold it deflated with a zlib header, or inside of a report ([`crate::carried`]): [`HandIn::open`] reads all.
//!
//! The facts can be computed again from the work, bit for bit by a program with the same number `bits`
//! ([`program::BITS`]). Unknown fields are ignored.
//!
//! Version 1, of programs up to 0.2.0, has English sentences as quantities ([`fact_of_version_1`]), and attempts without their
//! conditions.

use crate::carried::{self, Carried};
use crate::project::{Project, ProjectError};
use handed::json;
use handed::parts::{Head, Parts};
use serde::Deserialize;
use serde_json::value::RawValue;
use units::{Language, Words, words};

pub use crate::quantity::{fact_of_version_1, quantity_text};
pub use handed::fact::{FOLLOWS, FOLLOWS_NOT, Fact, FactValue, Part};
pub use handed::parts::{HAND_IN_VERSION, Sender, facts as facts_text};

/// Maximum size of a hand-in, in bytes.
pub const LONGEST_HAND_IN: usize = 64 << 20;

/// Maximum number of facts.
const MOST_FACTS: usize = 100_000;

/// Maximum length of the name of a sender, in characters.
pub const LONGEST_NAME: usize = 100;

/// Extension of files with a hand-in.
pub const HAND_IN_ENDING: &str = ".hand-in";

/// Content of a hand-in.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct HandIn {
    /// Version of its format, from 1 to [`HAND_IN_VERSION`].
    pub version: u32,
    /// Version of the program that made it.
    pub program: String,
    /// Number of the bits of that program's results ([`program::BITS`], from 1); `None` if it stated none, as versions up
    /// to 0.2.0 did.
    pub bits: Option<u32>,
    /// Time at which it was made, in milliseconds since 1970.
    pub made: u64,
    /// The student or the group.
    pub sender: Sender,
    /// Document, state, and items.
    pub work: Project,
    /// The values stated to follow from the work.
    pub facts: Vec<Fact>,
    /// Facts about the report that carries it, computed when it is opened; empty if no report carries it.
    pub page: Vec<Fact>,
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
    /// A page without the data of a hand-in.
    NoData,
    /// Cut off, or changed so that it cannot be read.
    Damaged,
}

impl HandInError {
    /// Description for the user.
    pub fn words(self) -> Words {
        match self {
            Self::TooLarge => words("is too large for a hand-in"),
            Self::LaterVersion => words("was made by a later version of Meniscus; verify it with that version"),
            Self::Other => words("is no hand-in of Meniscus"),
            Self::NoData => words("is a page without the data of a hand-in"),
            Self::Damaged => words("is damaged; ask for it again"),
        }
    }
}

#[derive(Deserialize)]
struct Written {
    #[serde(default)]
    program: String,
    #[serde(default)]
    bits: Option<u32>,
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
    /// A hand-in made by this program at the time `made`, in milliseconds since 1970. `facts`: the values that this program
    /// has computed from the work.
    pub fn new(made: u64, sender: Sender, work: Project, facts: Vec<Fact>) -> Self {
        let program = program::VERSION.to_owned();
        let bits = Some(program::BITS);
        Self { version: HAND_IN_VERSION, program, bits, made, sender, work, facts, page: Vec::new() }
    }

    /// The hand-in to be carried by a page in a language ([`carried::carry`]): it also states the text of the page.
    #[must_use]
    pub fn of_page(mut self, page: &str, language: Language) -> Self {
        self.facts.extend(carried::facts_without_data(page, language));
        self
    }

    /// Content of the file.
    pub fn write(&self) -> String {
        self.parts().text()
    }

    /// The parts, of which the file is made.
    pub fn parts(&self) -> Parts<'static> {
        let Self { version, program, bits, made, sender, work, facts: stated, .. } = self;
        let head =
            Head { version: *version, program: program.clone(), bits: *bits, made: *made, sender: sender.clone() };
        Parts {
            head,
            documents: work.documents_text().into(),
            state: json::text(&work.state).into(),
            items: work.named_items().into_iter().map(|(name, item)| (name, item.into())).collect(),
            facts: facts_text(stated).into(),
        }
    }

    /// Reads a file that holds a hand-in: its text, also deflated, or a report that carries it.
    ///
    /// # Errors
    /// If the file holds no hand-in, or is too large.
    pub fn open(file: &[u8]) -> Result<Self, HandInError> {
        if file.len() > LONGEST_HAND_IN {
            return Err(HandInError::TooLarge);
        }
        if is_deflated(file) {
            return Self::read(&inflated(file)?);
        }
        let text = String::from_utf8_lossy(file);
        if !text.trim_start_matches('\u{feff}').trim_start().starts_with('<') {
            return Self::read(&text);
        }
        let carried = Carried::of(&text).ok_or(HandInError::NoData)?;
        let packed = &carried.packed;
        let text = if is_deflated(packed) { inflated(packed)? } else { String::from_utf8_lossy(packed).into_owned() };
        let hand_in = Self::read(&text)?;
        Ok(Self { page: carried.facts(hand_in.version), ..hand_in })
    }

    /// Reads the text of a hand-in.
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
        if version > HAND_IN_VERSION {
            return Err(HandInError::LaterVersion);
        }
        let Written { program, bits, made, mut sender, work, facts } =
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
        Ok(Self { version, program, bits, made, sender, work, facts, page: Vec::new() })
    }
}

/// True if bytes begin with the header of zlib, with which no text begins.
fn is_deflated(bytes: &[u8]) -> bool {
    matches!(bytes, [0x78, second, ..] if (0x7800 | u32::from(*second)).is_multiple_of(31))
}

/// Inflates a text of at most [`LONGEST_HAND_IN`] bytes.
fn inflated(bytes: &[u8]) -> Result<String, HandInError> {
    let inflated = miniz_oxide::inflate::decompress_to_vec_zlib_with_limit(bytes, LONGEST_HAND_IN);
    let inflated = inflated.map_err(|error| match error.status {
        miniz_oxide::inflate::TINFLStatus::HasMoreOutput => HandInError::TooLarge,
        _ => HandInError::Damaged,
    })?;
    String::from_utf8(inflated).map_err(|_| HandInError::Damaged)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Number;
    use document::page::Source;

    fn hand_in() -> HandIn {
        let fact = |quantity: &str, value| Fact {
            part: Part::Fit,
            item: "a: b".to_owned(),
            quantity: quantity.to_owned(),
            value,
        };
        HandIn {
            version: HAND_IN_VERSION,
            program: "0.1.0".to_owned(),
            bits: Some(7),
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
            page: Vec::new(),
        }
    }

    #[test]
    fn what_is_written_reads_back() {
        assert_eq!(HandIn::read(&hand_in().write()), Ok(hand_in()));
    }

    #[test]
    fn a_file_is_read_in_each_of_its_forms() {
        let text = hand_in().write();
        let packed = miniz_oxide::deflate::compress_to_vec_zlib(text.as_bytes(), 6);
        let page = "<!doctype html><html><body><h1>a</h1><p>0.4</p><footer>f</footer></body></html>";
        let languages = [Language::English, catalogues::with(Language::Spanish)];
        let carrying = carried::carry(page, &packed, languages[0]);
        let carrying_text = carried::carry(page, text.as_bytes(), languages[1]);
        assert_eq!(HandIn::open(text.as_bytes()), Ok(hand_in()));
        assert_eq!(HandIn::open(&packed), Ok(hand_in()));
        for (carrying, language) in [carrying, carrying_text].into_iter().zip(languages) {
            let expected = HandIn { page: carried::facts_without_data(page, language), ..hand_in() };
            assert_eq!(HandIn::open(carrying.as_bytes()), Ok(expected));
        }
        assert_eq!(HandIn::open(page.as_bytes()), Err(HandInError::NoData));
        for end in 0..packed.len() {
            assert_eq!(HandIn::open(&packed[..end]), Err(HandInError::Damaged), "{end}");
        }
        let bomb = miniz_oxide::deflate::compress_to_vec_zlib(&vec![b' '; LONGEST_HAND_IN + 1], 1);
        assert_eq!(HandIn::open(&bomb), Err(HandInError::TooLarge));
    }

    #[test]
    fn other_files_are_refused_with_the_reason() {
        let whole = hand_in().write();
        let cases = [
            (String::new(), HandInError::Damaged),
            ("[]".to_owned(), HandInError::Other),
            ("{\"meniscus project\":1}".to_owned(), HandInError::Other),
            (whole.replace("\"meniscus hand-in\":2", "\"meniscus hand-in\":3"), HandInError::LaterVersion),
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
