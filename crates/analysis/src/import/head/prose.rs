//! Lines above the rows that are no header: sentences behind a comment sign, settings of an instrument, names of runs.

use super::cells_of::{bare_unit, split};
use super::{label, meant};
use crate::import::cells::{Cells, Delimiter};
use crate::roles::is_time;
use crate::run_name;

/// Words of sentences, in English, Spanish, Portuguese, German and French; none is the name of a column.
const WORDS: [&str; 52] = [
    "a",
    "an",
    "the",
    "my",
    "our",
    "this",
    "of",
    "with",
    "and",
    "is",
    "are",
    "was",
    "were",
    "for",
    "from",
    "by",
    "on",
    "at",
    "first",
    "second",
    "third",
    "measured",
    "recorded",
    "selected",
    "created",
    "generated",
    "file",
    "el",
    "la",
    "los",
    "las",
    "del",
    "con",
    "para",
    "mi",
    "um",
    "uma",
    "com",
    "os",
    "der",
    "die",
    "das",
    "mit",
    "und",
    "von",
    "le",
    "les",
    "des",
    "avec",
    "pour",
    "data",
    "experiment",
];

/// True if a line behind a comment sign is a sentence or a remark and not a header of `columns` columns.
///
/// A header states a time or a unit, has units only, or is one word a column. `Length 50 cm` and
/// `Selected output parameters:` are remarks.
pub(super) fn is_prose(line: &str, delimiter: Delimiter, columns: usize) -> bool {
    let line = line.trim();
    if line.is_empty() || columns < 2 {
        return false;
    }
    let cells: Vec<&str> = split(line, delimiter, columns).into_iter().filter(|cell| !cell.is_empty()).collect();
    if run_name::name(line).is_some() || line.to_ascii_lowercase().starts_with("multi:") {
        return false;
    }
    let labels: Vec<label::Label> = cells.iter().map(|cell| label::read(cell)).collect();
    // A setting of the program that wrote the file.
    if cells.iter().any(|cell| *cell == "=" || cell.ends_with('=')) || line.contains(" =") {
        return true;
    }
    let whole = |cell: &&str| bare_unit(cell).len() < cell.len() || meant::unit(cell, "").is_some();
    if cells.iter().all(whole) {
        return false;
    }
    let is_number = |cell: &&str| cell.starts_with(|first: char| first.is_ascii_digit());
    let sentence = |cell: &&str| {
        cell.split([' ', ',']).any(|word| WORDS.contains(&word.to_lowercase().as_str())) && cell.len() > 1
            || cell.ends_with([':', '.', ',', '!', '?'])
    };
    let blanks = matches!(delimiter, Delimiter::Blanks | Delimiter::Blank);
    let bracketed = labels.iter().any(|label| label.unit.is_some()) && line.contains(['[', '(', '/', '<', '{']);
    let timed = labels.iter().any(|label| is_time(&label.name));
    if (bracketed || timed) && cells.len() <= columns && !cells.iter().any(is_number) {
        return false;
    }
    // Other delimiters than blanks do not stand in a sentence by chance.
    let divided = !blanks && Cells::of(line, delimiter).count() == columns;
    let numbered = || line.split_whitespace().any(|word| word.starts_with(|first: char| first.is_ascii_digit()));
    let prose = cells.iter().any(sentence) || (!divided && numbered());
    prose && !(divided && delimiter != Delimiter::Comma)
}

/// True for a title between two equal signs, `- Data logger -`, `=== Results ===`.
pub(super) fn is_title(line: &str, delimiter: Delimiter) -> bool {
    let mut words = line.split_whitespace();
    let first = words.next().unwrap_or_default();
    let is_sign = !first.is_empty() && first.bytes().all(|byte| b"-=*#~_+".contains(&byte));
    matches!(delimiter, Delimiter::Blanks | Delimiter::Blank)
        && is_sign
        && words.count() > 1
        && line.trim_end().ends_with(first)
}

/// True if a line is the name of a run and nothing else.
pub(super) fn is_run(line: &str, delimiter: Delimiter) -> bool {
    let blanks = matches!(delimiter, Delimiter::Blanks | Delimiter::Blank);
    (blanks || Cells::of(line, delimiter).filter(|cell| !cell.is_empty()).count() == 1)
        && run_name::name(line.trim_matches([' ', '\t', ',', ';'])).is_some()
}

/// Comment without the name of the run before the names of its columns, `run 2: t y`.
pub(super) fn without_run(line: &str, is_comment: bool) -> &str {
    match line.split_once(':') {
        Some((run, rest)) if is_comment && run_name::name(run).is_some() && !rest.trim().is_empty() => {
            rest.trim_start()
        }
        _ => line,
    }
}

/// Names of all columns from comments that number them, `1 Height, km`, `2: Temperature [K]`; `None` without them.
pub(super) fn numbered<'a>(comments: &[&'a str], columns: usize) -> Option<Vec<&'a str>> {
    let numbered = |line: &&'a str| {
        let line = line.trim();
        let line = line.strip_prefix("Column ").or_else(|| line.strip_prefix("column ")).unwrap_or(line);
        let end = line.find(|letter: char| !letter.is_ascii_digit())?;
        let (number, rest) = line.split_at(end);
        let name = rest.trim_start_matches([':', '.', ')', '=', ' ', '\t']);
        let is_apart = rest.len() > name.len() && name.starts_with(char::is_alphabetic);
        Some((number.parse::<usize>().ok()?, name)).filter(|_| is_apart)
    };
    let read: Vec<Option<(usize, &str)>> = comments.iter().map(numbered).collect();
    let start = (0..(read.len() + 1).saturating_sub(columns)).rev().find(|start| {
        let block = read.iter().skip(*start).take(columns).enumerate();
        columns > 1 && block.clone().all(|(place, line)| line.is_some_and(|(number, _)| number == place + 1))
    })?;
    read.into_iter().skip(start).take(columns).map(|line| line.map(|(_, name)| name)).collect()
}

/// Lines of settings, `XInc:,0.04`: at least three lines of a name with a colon and its value.
pub(super) fn settings(lines: &[&str], delimiter: Delimiter) -> Vec<usize> {
    if matches!(delimiter, Delimiter::Blanks | Delimiter::Blank) {
        return Vec::new();
    }
    let is_setting = |line: &str| {
        let mut cells = Cells::of(line, delimiter);
        cells.next().is_some_and(|first| first.len() > 1 && first.ends_with(':'))
            && cells.filter(|cell| !cell.is_empty()).count() <= 1
    };
    let found: Vec<usize> = (0..lines.len()).filter(|line| is_setting(lines[*line])).collect();
    if found.len() >= 3 { found } else { Vec::new() }
}
