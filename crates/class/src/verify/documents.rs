//! Documents of hand-ins beside the teacher's document, or beside the document that most of them have.

use super::difference::shortened;
use document::page::Source;
use std::collections::BTreeMap;
use units::{Language, say};

/// Maximum number of lines of the middle of two texts that are compared one by one: beyond it all of them differ.
const MOST_COMPARED: usize = 2000;
/// Maximum number of differing lines that are kept.
const MOST_KEPT: usize = 200;
/// Maximum number of differing lines that are named.
const MOST_NAMED: usize = 6;

/// A line in which two texts differ.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ChangedLine {
    /// File of the document.
    pub file: String,
    /// Number of the line in the hand-in, from 1; where a line is missing, of the line after it.
    pub line: usize,
    /// Text in the hand-in; `None` if it is missing there.
    pub own: Option<String>,
    /// Text in the other document; `None` if the hand-in has a line more.
    pub other: Option<String>,
}

/// Document with which that of a hand-in is compared.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ComparedWith {
    /// The teacher's.
    Teacher,
    /// The one that this number of hand-ins has.
    Groups(usize),
}

/// A hand-in whose document is another one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DocumentDifference {
    /// The other document.
    pub with: ComparedWith,
    /// The lines; empty if the document is none of the teacher's.
    pub lines: Vec<ChangedLine>,
}

impl DocumentDifference {
    /// Lines of text: what differs, and the first of the differing lines.
    pub fn lines(&self, language: Language) -> Vec<String> {
        if self.lines.is_empty() {
            return vec![language.say("its document is none of the given documents").to_owned()];
        }
        let count = self.lines.len();
        let mut text = vec![match self.with {
            ComparedWith::Teacher => {
                say!(language, "its document differs from the given one; lines that differ: {count}")
            }
            ComparedWith::Groups(groups) => {
                say!(language, "its document differs from that of {groups} other hand-ins; lines that differ: {count}")
            }
        }];
        text.extend(self.lines.iter().take(MOST_NAMED).map(|line| line.text(language)));
        let more = count.saturating_sub(MOST_NAMED);
        if more > 0 {
            text.push(say!(language, "and {more} further lines"));
        }
        text
    }
}

impl ChangedLine {
    /// One line: place and both texts.
    pub fn text(&self, language: Language) -> String {
        let (file, line) = (shortened(&self.file), self.line);
        let [own, other] = [&self.own, &self.other].map(|text| text.as_deref().map(shortened));
        match (own, other) {
            (Some(own), Some(other)) => say!(language, "{file}, line {line}: \"{own}\" instead of \"{other}\""),
            (Some(own), None) => say!(language, "{file}, line {line}: \"{own}\" is added"),
            (None, other) => {
                let other = other.unwrap_or_default();
                say!(language, "{file}, line {line}: \"{other}\" is missing")
            }
        }
    }
}

/// Lines of a text without their ends, without lines that are empty at its end.
fn lines(text: &str) -> Vec<&str> {
    let text = text.trim_start_matches('\u{feff}').trim_end();
    text.lines().map(str::trim_end).collect()
}

/// True if two documents have the same lines: their first files, and translations of the same name.
pub fn is_same(own: &[Source], other: &[Source]) -> bool {
    pairs(own, other).all(|(own, other)| lines(&own.text) == other.map_or_else(Vec::new, |other| lines(&other.text)))
}

/// The lines in which a document differs from another one, at most 200.
pub fn changed_lines(own: &[Source], other: &[Source]) -> Vec<ChangedLine> {
    let changed = pairs(own, other).flat_map(|(own, other)| {
        let (ours, theirs) = (lines(&own.text), other.map_or_else(Vec::new, |other| lines(&other.text)));
        changed_in(&own.name, &ours, &theirs)
    });
    changed.take(MOST_KEPT).collect()
}

/// Files with their counterparts: the first ones, then translations by name. A missing translation is no difference.
fn pairs<'a>(own: &'a [Source], other: &'a [Source]) -> impl Iterator<Item = (&'a Source, Option<&'a Source>)> {
    own.iter().enumerate().map(move |(place, file)| match place {
        0 => (file, other.first()),
        _ => (file, other.iter().skip(1).find(|other| other.name == file.name)),
    })
}

fn changed_in(file: &str, own: &[&str], other: &[&str]) -> Vec<ChangedLine> {
    let begin = own.iter().zip(other).take_while(|(one, other)| one == other).count();
    let (own, other) = (&own[begin..], &other[begin..]);
    let end = own.iter().rev().zip(other.iter().rev()).take_while(|(one, other)| one == other).count();
    let (own, other) = (&own[..own.len() - end], &other[..other.len() - end]);
    let mut changed = Vec::new();
    let (mut at, mut there) = (0, 0);
    for (next, next_there) in common(own, other).into_iter().chain([(own.len(), other.len())]) {
        // Lines between two common ones stand for each other in their order.
        while at < next || there < next_there {
            let line = |texts: &[&str], place: usize, until: usize| {
                (place < until).then(|| texts.get(place).map(|text| (*text).to_owned())).flatten()
            };
            let (ours, theirs) = (line(own, at, next), line(other, there, next_there));
            changed.push(ChangedLine { file: file.to_owned(), line: begin + at + 1, own: ours, other: theirs });
            (at, there) = ((at + 1).min(next), (there + 1).min(next_there));
        }
        (at, there) = (next + 1, next_there + 1);
    }
    changed
}

/// Places of a longest common subsequence of lines; none if there are too many lines.
fn common(own: &[&str], other: &[&str]) -> Vec<(usize, usize)> {
    if own.len() > MOST_COMPARED || other.len() > MOST_COMPARED {
        return Vec::new();
    }
    let width = other.len() + 1;
    let mut longest = vec![0_u16; (own.len() + 1) * width];
    for row in (0..own.len()).rev() {
        for column in (0..other.len()).rev() {
            longest[row * width + column] = if own[row] == other[column] {
                longest[(row + 1) * width + column + 1] + 1
            } else {
                longest[(row + 1) * width + column].max(longest[row * width + column + 1])
            };
        }
    }
    let (mut row, mut column, mut found) = (0, 0, Vec::new());
    while row < own.len() && column < other.len() {
        if own[row] == other[column] {
            found.push((row, column));
            (row, column) = (row + 1, column + 1);
        } else if longest[(row + 1) * width + column] >= longest[row * width + column + 1] {
            row += 1;
        } else {
            column += 1;
        }
    }
    found
}

/// Share of the lines of the first files that two documents have in common, 0 to 1. Empty lines do not count.
pub fn likeness(own: &[Source], other: &[Source]) -> f64 {
    fn counted(files: &[Source]) -> BTreeMap<&str, usize> {
        let mut counts = BTreeMap::new();
        for line in lines(files.first().map_or("", |file| &file.text)).into_iter().map(str::trim) {
            if !line.is_empty() {
                *counts.entry(line).or_default() += 1;
            }
        }
        counts
    }
    let (own, other) = (counted(own), counted(other));
    let common: usize = own.iter().map(|(line, count)| other.get(line).copied().unwrap_or(0).min(*count)).sum();
    let all = own.values().sum::<usize>().max(other.values().sum());
    common as f64 / all.max(1) as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    fn document(text: &str) -> Vec<Source> {
        vec![Source { name: "a.md".to_owned(), text: text.to_owned() }]
    }

    #[test]
    fn changed_lines_are_named_and_line_ends_are_none() {
        let own = document("\u{feff}a\r\nb\r\nc\r\nd\r\n");
        assert!(is_same(&own, &document("a\nb\nc\nd")));
        for (other, expected) in [
            ("a\nB\nc\nd", &["a.md, line 2: \"b\" instead of \"B\""][..]),
            ("b\nc\nd", &["a.md, line 1: \"a\" is added"]),
            ("a\nb\nc\nd\ne", &["a.md, line 5: \"e\" is missing"]),
            ("a\nx\nb\nc\ny", &["a.md, line 2: \"x\" is missing", "a.md, line 4: \"d\" instead of \"y\""]),
        ] {
            assert!(!is_same(&own, &document(other)));
            let changed = changed_lines(&own, &document(other));
            let text: Vec<String> = changed.iter().map(|line| line.text(Language::English)).collect();
            assert_eq!(text, expected, "{other}");
        }
        assert_eq!(likeness(&own, &document("a\nb\nx\ny")), 0.5);
        let long: String = (0..5000).map(|line| format!("{line}\n")).collect();
        assert_eq!(changed_lines(&document(&long), &document("x\ny")).len(), MOST_KEPT);
    }

    #[test]
    fn a_translation_that_is_changed_or_added_differs_and_a_missing_one_does_not() {
        let with = |text: &str| {
            let mut files = document("a");
            files.push(Source { name: "a.es.md".to_owned(), text: text.to_owned() });
            files
        };
        assert!(is_same(&document("a"), &with("b")));
        assert!(!is_same(&with("c"), &with("b")) && !is_same(&with("b"), &document("a")));
    }
}
