//! A sheet: one file with a person's answers to a survey. It has no name, seat or time.
//!
//! ```json
//! {"meniscus survey":1,"document":"U-tube","items":[
//! {"name":"4f1c…","kind":"scale","asked":"It was clear","words":["disagree","agree"],"of":5,"chosen":4},
//! {"name":"90ab…","kind":"text","asked":"What would you change?","typed":"Nothing"}
//! ]}
//! ```
//!
//! Texts are in the language of the document, and `chosen` counts from 1. An item without answer has neither `chosen` nor
//! `typed`. Unknown fields are ignored. `play::Survey::file` writes the file.

use serde::{Deserialize, Serialize};
use units::{Words, words};

/// Version of the format.
const VERSION: u32 = 1;

/// Maximum size of a sheet, in bytes.
pub const LONGEST_SHEET: usize = 1 << 20;

/// Maximum number of items.
const MOST_ITEMS: usize = 50;
/// Maximum number of alternatives or steps.
const MOST_ANSWERS: usize = 20;
/// Maximum length of a text of an item, in characters.
const LONGEST_TEXT: usize = 300;
/// Maximum length of an answer in words, in characters.
const LONGEST_ANSWER: usize = 2000;

/// Extension of files with a sheet.
pub const SHEET_ENDING: &str = ".survey";

/// Kind of an item.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum ItemKind {
    /// The group to which the person belongs.
    Role,
    /// Agreement with a statement, in steps.
    Scale,
    /// One of several texts.
    Choice,
    /// Free text.
    Text,
}

/// An item of a survey.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct SurveyItem {
    /// Name of the item, which does not depend on the language of the page.
    pub name: String,
    /// Its kind.
    pub kind: ItemKind,
    /// The question or statement.
    pub asked: String,
    /// The alternatives; the words at the lower and the upper end of a scale; empty for free text.
    pub words: Vec<String>,
    /// Number of alternatives or steps; 0 for free text.
    pub answers: usize,
}

/// An answer to an item.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum SurveyAnswer {
    /// Index of an alternative or step.
    Chosen(usize),
    /// Free text; it has several lines.
    Typed(String),
}

/// Answers of one person.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Sheet {
    /// Title of the document.
    pub document: String,
    /// All items in the order of the document, with the answers given.
    pub items: Vec<(SurveyItem, Option<SurveyAnswer>)>,
}

/// Reason why a file cannot be read as a sheet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SheetError {
    /// Longer than [`LONGEST_SHEET`], or too many or too long parts.
    TooLarge,
    /// Written by a later version of the program.
    LaterVersion,
    /// JSON of another kind.
    Other,
    /// Cut off, or changed so that it cannot be read.
    Damaged,
}

impl SheetError {
    /// Description for the user.
    pub fn words(self) -> Words {
        match self {
            Self::TooLarge => words("is too large for the answers to a survey"),
            Self::LaterVersion => words("was made by a later version of Meniscus; open it with that version"),
            Self::Other => words("has no answers to a survey of Meniscus"),
            Self::Damaged => words("is damaged; ask for it again"),
        }
    }
}

#[derive(Deserialize)]
struct Version {
    #[serde(rename = "meniscus survey")]
    version: u32,
}

#[derive(Deserialize)]
struct Written {
    #[serde(default)]
    document: String,
    items: Vec<WrittenItem>,
}

#[derive(Deserialize)]
struct WrittenItem {
    name: String,
    kind: ItemKind,
    asked: String,
    #[serde(default)]
    words: Vec<String>,
    #[serde(default)]
    of: usize,
    #[serde(default)]
    chosen: Option<usize>,
    #[serde(default)]
    typed: Option<String>,
}

impl Sheet {
    /// Reads the content of a file.
    ///
    /// # Errors
    /// If the text is not a sheet, or is too large.
    pub fn read(text: &str) -> Result<Self, SheetError> {
        if text.len() > LONGEST_SHEET {
            return Err(SheetError::TooLarge);
        }
        let Version { version } = match serde_json::from_str(text) {
            Ok(version) => version,
            Err(error) if error.is_data() => return Err(SheetError::Other),
            Err(_) => return Err(SheetError::Damaged),
        };
        if version > VERSION {
            return Err(SheetError::LaterVersion);
        }
        let written: Written = serde_json::from_str(text).map_err(|_| SheetError::Damaged)?;
        if written.items.len() > MOST_ITEMS {
            return Err(SheetError::TooLarge);
        }
        let items = written.items.into_iter().map(WrittenItem::checked).collect::<Result<_, _>>()?;
        Ok(Self { document: line(&written.document, LONGEST_TEXT)?, items })
    }
}

impl WrittenItem {
    fn checked(self) -> Result<(SurveyItem, Option<SurveyAnswer>), SheetError> {
        let words = self.words.iter().map(|word| line(word, LONGEST_TEXT)).collect::<Result<Vec<_>, _>>()?;
        if self.of > MOST_ANSWERS || words.len() > MOST_ANSWERS {
            return Err(SheetError::TooLarge);
        }
        let fits = match self.kind {
            ItemKind::Role | ItemKind::Choice => words.len() == self.of && self.of >= 2 && self.typed.is_none(),
            ItemKind::Scale => words.len() == 2 && self.of >= 2 && self.typed.is_none(),
            ItemKind::Text => words.is_empty() && self.of == 0 && self.chosen.is_none(),
        };
        if !fits || self.chosen.is_some_and(|chosen| !(1..=self.of).contains(&chosen)) {
            return Err(SheetError::Damaged);
        }
        let typed = self.typed.map(|typed| cleaned(&typed, LONGEST_ANSWER, |letter| letter == '\n')).transpose()?;
        let typed = typed.filter(|typed| !typed.trim().is_empty()).map(SurveyAnswer::Typed);
        let answer = self.chosen.map(|chosen| SurveyAnswer::Chosen(chosen - 1)).or(typed);
        let name = line(&self.name, LONGEST_TEXT)?;
        let asked = line(&self.asked, LONGEST_TEXT)?;
        Ok((SurveyItem { name, kind: self.kind, asked, words, answers: self.of }, answer))
    }
}

/// A text of one line.
fn line(text: &str, longest: usize) -> Result<String, SheetError> {
    cleaned(text, longest, |_| false)
}

/// The text without control characters (except those that are `kept`) and without marks that reverse the direction of
/// what follows.
fn cleaned(text: &str, longest: usize, kept: impl Fn(char) -> bool) -> Result<String, SheetError> {
    if text.chars().count() > longest {
        return Err(SheetError::TooLarge);
    }
    let turns =
        |letter: char| matches!(letter, '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
    Ok(text.chars().filter(|&letter| kept(letter) || !letter.is_control() && !turns(letter)).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    const SHEET: &str = r#"{"meniscus survey":1,"document":"U-tube","later":[],"items":[
{"name":"a","kind":"role","asked":"You are a","words":["student","teacher"],"of":2,"chosen":2},
{"name":"b","kind":"scale","asked":"It was clear","words":["no","yes"],"of":5,"chosen":4},
{"name":"c","kind":"choice","asked":"Best","words":["plots","fit"],"of":2},
{"name":"d","kind":"text","asked":"Why?","typed":"ñ \"x\"\n=1+1\u202e<script>\u0007"}
]}
"#;

    #[test]
    fn a_sheet_is_read_and_its_texts_are_inert() {
        let sheet = Sheet::read(SHEET).unwrap();
        let answers: Vec<_> = sheet.items.iter().map(|(_, answer)| answer.clone()).collect();
        let typed = SurveyAnswer::Typed("ñ \"x\"\n=1+1<script>".to_owned());
        assert_eq!(answers, [Some(SurveyAnswer::Chosen(1)), Some(SurveyAnswer::Chosen(3)), None, Some(typed)]);
        assert_eq!((sheet.document.as_str(), sheet.items[1].0.answers), ("U-tube", 5));
    }

    #[test]
    fn other_files_are_refused_with_the_reason() {
        let long = "x".repeat(1_000_000);
        let cases = [
            (String::new(), SheetError::Damaged),
            ("[]".to_owned(), SheetError::Other),
            ("{\"meniscus hand-in\":1}".to_owned(), SheetError::Other),
            (SHEET.replace("survey\":1", "survey\":2"), SheetError::LaterVersion),
            (SHEET.replace("\"role\"", "\"name\""), SheetError::Damaged),
            (SHEET.replace("\"chosen\":4", "\"chosen\":6"), SheetError::Damaged),
            (SHEET.replace("\"chosen\":4", "\"chosen\":0"), SheetError::Damaged),
            (SHEET.replace("\"chosen\":4", "\"chosen\":-1"), SheetError::Damaged),
            (SHEET.replace("\"chosen\":4", "\"typed\":\"x\""), SheetError::Damaged),
            (SHEET.replace("\"of\":5", "\"of\":1000000000"), SheetError::TooLarge),
            (SHEET.replace("[\"no\",\"yes\"]", "[\"no\"]"), SheetError::Damaged),
            (SHEET.replace("It was clear", &long), SheetError::TooLarge),
            (SHEET.replace("<script>", &long), SheetError::TooLarge),
            (SHEET.replace("\"later\":[]", &format!("\"later\":{}", "[".repeat(500_000))), SheetError::Damaged),
            (" ".repeat(LONGEST_SHEET + 1), SheetError::TooLarge),
        ];
        for (text, expected) in cases {
            assert_eq!(Sheet::read(&text), Err(expected), "{text:.80}");
        }
        let whole = SHEET.trim_end();
        for end in whole.char_indices().map(|(end, _)| end) {
            assert_eq!(Sheet::read(&whole[..end]), Err(SheetError::Damaged), "{end}");
        }
    }
}
