//! Texts of diagnostics in both languages: checks of each pair, and a catalogue for review.
use model::Diagnostic;
use std::collections::BTreeSet;
use std::path::Path;
use units::Words;

/// Words that occur in many English sentences, but not in Spanish ones or in the language of models.
const ENGLISH: &[&str] = &[
    "the", "is", "are", "of", "must", "with", "which", "this", "that", "these", "write", "cannot", "has", "by", "it",
    "its", "to", "for", "from", "here", "give", "was", "were", "there", "than", "at", "on", "an", "use", "only",
    "other", "does", "stands", "such", "too", "many", "length", "force", "number", "term", "side",
];

/// All pairs of texts, in the order of first occurrence.
#[derive(Default)]
pub struct Catalogue {
    seen: BTreeSet<(String, String)>,
    text: String,
    problems: Vec<String>,
}

impl Catalogue {
    /// Checks and adds all texts of these diagnostics.
    pub fn add(&mut self, diagnostics: &[Diagnostic]) {
        for found in diagnostics {
            let labels = found.labels.iter().map(|label| &label.text).filter(|text| !text.is_empty());
            for words in [&found.message].into_iter().chain(labels).chain(&found.notes).chain(&found.hints) {
                self.problems.extend(problem(words).map(|problem| format!("{problem}: {words:?}")));
                if self
                    .seen
                    .insert((words.english(), words.text(catalogues::with(units::Language::Spanish)).to_string()))
                {
                    for (tag, text) in [
                        ("en", words.english()),
                        ("es", words.text(catalogues::with(units::Language::Spanish)).into_owned()),
                    ] {
                        self.text
                            .extend(text.lines().map(|line| format!("{tag}  {line}").trim_end().to_owned() + "\n"));
                    }
                    self.text.push('\n');
                }
            }
        }
    }

    /// Compares with the reviewed file; `UPDATE_EXPECTED=1` writes it instead, for review before a commit.
    #[track_caller]
    pub fn compare(&self, file: &Path) {
        assert!(self.problems.is_empty(), "{:#?}", self.problems);
        let head = "The texts of diagnostics in English and Spanish, as tests/spanish.rs finds them.\n\n";
        let found = head.to_owned() + self.text.trim_end() + "\n";
        if std::env::var_os("UPDATE_EXPECTED").is_some() {
            std::fs::write(file, found).unwrap();
            return;
        }
        let expected = std::fs::read_to_string(file).unwrap();
        let differing = found.lines().zip(expected.lines()).find(|(found, expected)| found != expected);
        assert!(found == expected, "{}: {differing:?}", file.display());
    }
}

/// Fault of a text and its translation, or `None`.
fn problem(words: &Words) -> Option<&'static str> {
    let (english, spanish) =
        (Parts::of(&words.english()), Parts::of(&words.text(catalogues::with(units::Language::Spanish))));
    if words.english().is_empty() || spanish.words.is_empty() && !english.words.is_empty() {
        Some("there is no text")
    } else if english.quoted != spanish.quoted {
        Some("the names differ")
    } else if english.numbers != spanish.numbers {
        Some("the numbers differ")
    } else {
        spanish.words.iter().any(|word| ENGLISH.contains(&word.as_str())).then_some("English is left")
    }
}

/// A text split into parts, each sorted.
struct Parts {
    /// Text between backquotes, without texts in quotation marks.
    quoted: Vec<String>,
    numbers: Vec<String>,
    words: Vec<String>,
}

impl Parts {
    fn of(text: &str) -> Self {
        let mut quoted = Vec::new();
        let mut rest = String::new();
        for (index, part) in text.replace("```", "").split('`').enumerate() {
            if index % 2 == 1 {
                quoted.push(part.split('"').step_by(2).collect());
            } else {
                rest += part;
            }
        }
        // A quoted text of the document is not translated.
        let rest: String = rest.split(['«', '»', '"']).step_by(2).collect();
        let pieces = rest.split(|c: char| !(c.is_alphanumeric() || matches!(c, '.' | ',' | '\'' | '_')));
        let (mut numbers, mut words) = (Vec::new(), Vec::new());
        for piece in pieces.map(|piece| piece.trim_matches(['.', ',', '\''])).filter(|piece| !piece.is_empty()) {
            if piece.starts_with(|c: char| c.is_ascii_digit()) {
                numbers.push(piece.replace(',', "."));
            } else {
                words.push(piece.to_lowercase());
            }
        }
        quoted.sort();
        numbers.sort();
        Self { quoted, numbers, words }
    }
}
