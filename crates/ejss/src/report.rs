//! Report of an import: parts that are missing, guessed or changed, with the place of each.

use crate::place::{Place, Reason, Section};
use crate::prose::visible;
use crate::refusal::Obstacle;
use units::{Language, Words, say, words};

/// Greatest number of entries; further ones are counted.
const MOST_ENTRIES: usize = 400;

/// Report of an import.
#[derive(Clone, Debug, Default)]
pub struct Report {
    entries: Vec<Entry>,
    /// Number of entries beyond the greatest number.
    more: usize,
}

/// Kind of an entry.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EntryKind {
    /// Something of the original is missing in the document.
    Left,
    /// The document computes something in another way than the original.
    Differs,
    /// The document says the same by other means.
    Changed,
}

impl EntryKind {
    /// Identifier in the report for programs.
    pub fn key(self) -> &'static str {
        match self {
            Self::Left => "left",
            Self::Differs => "differs",
            Self::Changed => "changed",
        }
    }
}

/// Entry of a report.
#[derive(Clone, Debug)]
pub struct Entry {
    /// Kind.
    pub kind: EntryKind,
    place: Place,
    /// Sentence.
    pub text: Words,
    /// Number of places with the same sentence on this page.
    pub count: usize,
    /// Line of the document that the entry is about, from 1.
    pub document_line: Option<usize>,
}

impl Entry {
    /// Part of the simulation.
    pub fn section(&self) -> Section {
        self.place.section
    }

    /// Name of the page or element.
    pub fn page(&self) -> &str {
        &self.place.page
    }

    /// Line of the page, from 1.
    pub fn line(&self) -> Option<usize> {
        self.place.line
    }

    /// The sentence with its place in a language: *Fixed relations, "energy", line 2: ..*.
    pub fn sentence(&self, language: Language) -> String {
        let (section, page) = (self.place.section.words(), shown(&self.place.page));
        let text = self.text.text(language);
        let sentence = match (self.place.line, page.is_empty()) {
            (Some(line), false) => words!("{section}, \"{page}\", line {line}: {text}"),
            (Some(line), true) => words!("{section}, line {line}: {text}"),
            (None, false) => words!("{section}, \"{page}\": {text}"),
            (None, true) => words!("{section}: {text}"),
        };
        match self.count {
            0 | 1 => sentence.text(language).into_owned(),
            count => say!(language, "{sentence} ({count} times)"),
        }
    }
}

impl Report {
    /// Entries in the order in which they were found.
    pub fn entries(&self) -> &[Entry] {
        &self.entries
    }

    pub(crate) fn entries_mut(&mut self) -> &mut [Entry] {
        &mut self.entries
    }

    /// Number of entries that are not listed.
    pub fn more(&self) -> usize {
        self.more
    }

    pub(crate) fn add(&mut self, kind: EntryKind, place: Place, text: Words) {
        let same = |entry: &&mut Entry| {
            entry.place.section == place.section
                && entry.place.page == place.page
                && entry.text == text
                && entry.kind == kind
        };
        if let Some(entry) = self.entries.iter_mut().find(same) {
            entry.count += 1;
        } else if self.entries.len() < MOST_ENTRIES {
            self.entries.push(Entry { kind, place, text, count: 1, document_line: None });
        } else {
            self.more += 1;
        }
    }

    /// A page or a piece of code that cannot be read.
    pub(crate) fn not_read(&mut self, place: Place, obstacle: &Obstacle) {
        let reason = obstacle.words();
        self.add(EntryKind::Left, place, words!("The code is not carried over: {reason}."));
    }

    /// A quantity that is not carried over.
    pub(crate) fn quantity_left(&mut self, name: &str, reason: &Reason) {
        let why = reason.obstacle.words();
        self.add(EntryKind::Left, reason.place.clone(), words!("`{name}` is not carried over: {why}."));
    }
}

/// Name of a page in one short line, without what could end a quotation or mark up a text.
pub(crate) fn shown(name: &str) -> String {
    let plain: String = visible(name)
        .chars()
        .filter(|letter| !matches!(letter, '`' | '"' | '<' | '>' | '[' | ']' | '*' | '$' | '|' | '\\'))
        .take(60)
        .collect();
    plain.trim().to_owned()
}
