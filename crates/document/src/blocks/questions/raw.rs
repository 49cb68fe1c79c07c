//! Parts of a question as written: the prompt, then keys with their texts.

use crate::text::source::{lines, trim};
use model::{Diagnostic, Span};
use std::ops::Range;
use units::words;

/// Content of a key.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Holds {
    /// Expressions or names of the model, on one line.
    Expressions,
    /// A word or numbers.
    Word,
    /// Texts in quotation marks, with more or less before and between them. The key stands before each entry.
    Entries,
    /// Markdown.
    Prose,
}

/// A key of questions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Key {
    /// Word before the colon.
    pub word: &'static str,
    /// Content of the key.
    pub holds: Holds,
    /// Key of the kind of question that this key belongs to; `None` if it can stand in every question.
    pub kind: Option<&'static str>,
}

/// Keys of a question; the text before the first key is the prompt.
pub const KEYS: [Key; 10] = [
    Key { word: "after", holds: Holds::Word, kind: None },
    Key { word: "set", holds: Holds::Expressions, kind: None },
    Key { word: "hide", holds: Holds::Expressions, kind: None },
    Key { word: "answer", holds: Holds::Expressions, kind: Some("answer") },
    Key { word: "wrong", holds: Holds::Entries, kind: Some("answer") },
    Key { word: "choose", holds: Holds::Word, kind: Some("choose") },
    Key { word: "option", holds: Holds::Entries, kind: Some("choose") },
    Key { word: "attempts", holds: Holds::Word, kind: None },
    Key { word: "hint", holds: Holds::Prose, kind: None },
    Key { word: "explanation", holds: Holds::Prose, kind: None },
];

impl Key {
    /// The key at the beginning of a line.
    fn of_line(line: &str) -> Option<Self> {
        let (word, _) = line.split_once(':')?;
        KEYS.into_iter().find(|key| key.word == word)
    }
}

/// A question as written.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct RawQuestion {
    /// Byte range without the fence.
    pub place: Range<usize>,
    pub(super) prompt: Range<usize>,
    fields: Vec<(Key, Range<usize>)>,
}

impl RawQuestion {
    /// Byte range of the question text.
    pub fn prompt(&self) -> Range<usize> {
        self.prompt.clone()
    }

    /// Keys with the byte ranges after their colons, in text order. Entries of one key that follow each other are one range.
    pub fn fields(&self) -> &[(Key, Range<usize>)] {
        &self.fields
    }

    /// Byte range after the colon of a key.
    pub fn field(&self, word: &str) -> Option<Range<usize>> {
        self.fields.iter().find(|(key, _)| key.word == word).map(|(_, range)| range.clone())
    }

    /// Byte ranges of the entries of a key, without outer blanks.
    pub fn entries(&self, source: &str, word: &str) -> Vec<Range<usize>> {
        let Some(field) = self.field(word) else { return Vec::new() };
        let mut starts = vec![(field.start, field.start)];
        let begins = |line: &str| Key::of_line(line).is_some_and(|key| key.word == word);
        let further = lines(source, field.clone()).skip(1).filter(|line| begins(line.text(source)));
        starts.extend(further.map(|line| (line.start, line.start + word.len() + 1)));
        let ends = starts.iter().skip(1).map(|(line, _)| *line).chain([field.end]).collect::<Vec<_>>();
        starts.into_iter().zip(ends).map(|((_, start), end)| trim(source, start..end)).collect()
    }
}

/// Splits the question in `range` into its parts. Each part extends to the next key.
pub fn split(source: &str, range: Range<usize>, diagnostics: &mut Vec<Diagnostic>) -> RawQuestion {
    let mut question = RawQuestion { place: trim(source, range.clone()), ..RawQuestion::default() };
    question.prompt = range.start..range.end;
    for line in lines(source, range.clone()) {
        let Some(found) = Key::of_line(line.text(source)) else {
            continue;
        };
        let key = found.word;
        match question.fields.last_mut() {
            Some((last, _)) if *last == found && found.holds == Holds::Entries => continue,
            Some((_, last)) => last.end = line.start,
            None => question.prompt.end = line.start,
        }
        if question.field(key).is_some() {
            let span = Span::new(line.start, line.start + key.len());
            diagnostics.push(match found.holds {
                Holds::Entries => {
                    let message = words!("the lines `{key}:` do not follow each other");
                    Diagnostic::error("question-syntax", message, span)
                }
                _ => Diagnostic::error("duplicate-key", words!("the question has two `{key}:`"), span),
            });
        }
        question.fields.push((found, line.start + key.len() + 1..range.end));
    }
    question
}

/// First key at the beginning of a line of a text.
pub fn key_in(text: &str) -> Option<&'static str> {
    text.lines().find_map(Key::of_line).map(|key| key.word)
}

/// Byte range of a part of a question, without outer blanks: the text after the key `word`, or the prompt for `None`.
pub fn part(source: &str, range: Range<usize>, word: Option<&str>) -> Option<Range<usize>> {
    let raw = split(source, range, &mut Vec::new());
    match word {
        None => Some(trim(source, raw.prompt)),
        Some(word) => raw.field(word).map(|range| trim(source, range)),
    }
}
