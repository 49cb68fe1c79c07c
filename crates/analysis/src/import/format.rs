//! Which delimiter and which decimal sign a text has.

use super::cells::{Cells, Delimiter};
use super::number::{self, Cell};
use std::collections::BTreeMap;

/// How many lines are looked at from the beginning, and how many from all over the rest.
const FIRST: usize = 200;
const SPREAD: usize = 100;

/// How a text is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Format {
    /// What stands between two cells.
    pub delimiter: Delimiter,
    /// `b'.'` or `b','`.
    pub decimal: u8,
    /// How many lines come before the first row.
    pub header_lines: usize,
}

impl Format {
    /// In words: `tabs, decimal comma, 2 header lines`.
    pub fn text(&self, spanish: bool) -> String {
        let (english, other) = match self.delimiter {
            Delimiter::Tab => ("tabs", "tabuladores"),
            Delimiter::Semicolon => ("semicolons", "puntos y comas"),
            Delimiter::Comma => ("commas", "comas"),
            Delimiter::CommaAndBlank => ("commas with a blank", "comas con espacio"),
            Delimiter::Blanks | Delimiter::Blank => ("blanks", "espacios"),
            Delimiter::Other(_) => ("", ""),
        };
        let mut text = match self.delimiter {
            Delimiter::Other(byte) => char::from(byte).to_string(),
            _ if spanish => other.to_owned(),
            _ => english.to_owned(),
        };
        text.push_str(match (self.decimal, spanish) {
            (b',', false) => ", decimal comma",
            (b',', true) => ", coma decimal",
            (_, false) => ", decimal point",
            (_, true) => ", punto decimal",
        });
        let lines = self.header_lines;
        text.push_str(&match (lines, spanish) {
            (0, false) => ", no header".to_owned(),
            (0, true) => ", sin encabezado".to_owned(),
            (1, false) => ", 1 header line".to_owned(),
            (1, true) => ", 1 línea de encabezado".to_owned(),
            (_, false) => format!(", {lines} header lines"),
            (_, true) => format!(", {lines} líneas de encabezado"),
        });
        text
    }
}

/// What a line has.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Count {
    pub numbers: usize,
    pub words: usize,
    /// All of it, gaps too, those at the end not counted.
    pub cells: usize,
    /// Gaps at the end counted as well.
    pub all: usize,
}

/// Counts what stands in the cells of a line.
pub(super) fn count(line: &str, delimiter: Delimiter, decimal: u8) -> Count {
    let mut count = Count::default();
    for cell in Cells::of(line, delimiter) {
        count.all += 1;
        // Among blanks a comma at the edge of a number is punctuation.
        let punctuation = matches!(delimiter, Delimiter::Blanks | Delimiter::Blank)
            && decimal == b','
            && (cell.starts_with(',') || cell.ends_with(','));
        match number::cell(cell, decimal) {
            Cell::Number(_) if !punctuation => count.numbers += 1,
            Cell::Gap => continue,
            _ => count.words += 1,
        }
        count.cells = count.all;
    }
    count
}

/// Delimiter and decimal sign of a text, and how many words a row has in the format found.
pub(super) fn recognise(text: &str) -> (Delimiter, u8, usize) {
    let lines = sample(text);
    let candidates = candidates(&lines);
    let counts: Vec<Vec<Count>> = candidates
        .iter()
        .map(|(delimiter, decimal)| lines.iter().map(|line| count(line, *delimiter, *decimal)).collect())
        .collect();
    // Rows with nothing but numbers decide; where most lines have a word in them, the cells do.
    let rows = |counts: &[Count]| counts.iter().filter(|count| count.numbers >= 2 && count.words == 0).count();
    let cells = |counts: &[Count]| -> usize {
        counts.iter().filter(|count| count.numbers >= 2).map(|count| count.numbers.saturating_sub(count.words)).sum()
    };
    let clean = counts.iter().map(|counts| rows(counts)).max().unwrap_or(0);
    let with_numbers = |counts: &[Count]| counts.iter().filter(|count| count.numbers > 0).count();
    let by_cells = 2 * clean < counts.iter().map(|counts| with_numbers(counts)).max().unwrap_or(0);
    let mut best = 0;
    let mut best_score = (0, 0);
    for (index, counts) in counts.iter().enumerate() {
        let found = if by_cells { cells(counts) } else { rows(counts) };
        // The earlier candidate wins where both are as good.
        let score = (found, usual(counts.iter().filter(|count| count.numbers >= 2).map(|count| count.all)).1);
        if score > best_score {
            (best, best_score) = (index, score);
        }
    }
    let (delimiter, decimal) = candidates.get(best).copied().unwrap_or((Delimiter::Blanks, b'.'));
    let words = counts
        .get(best)
        .map_or(0, |counts| usual(counts.iter().filter(|count| count.numbers >= 2).map(|count| count.words)).0);
    (delimiter, decimal, words)
}

/// The most frequent number, the greatest of several, and how often it occurs.
fn usual(numbers: impl Iterator<Item = usize>) -> (usize, usize) {
    let mut occurrences = BTreeMap::new();
    for number in numbers {
        *occurrences.entry(number).or_insert(0) += 1;
    }
    occurrences.into_iter().max_by_key(|(number, count)| (*count, *number)).unwrap_or((0, 0))
}

/// What can be, the likelier first.
fn candidates(lines: &[&str]) -> Vec<(Delimiter, u8)> {
    use Delimiter::{Blank, Blanks, Comma, CommaAndBlank, Other, Semicolon, Tab};
    let mut candidates = vec![(Tab, b'.'), (Tab, b','), (Semicolon, b'.'), (Semicolon, b',')];
    // `1,5, 2,5`: some commas have a blank behind them, others have none.
    let followed = lines.iter().any(|line| line.contains(", "));
    let alone = lines.iter().any(|line| line.replace(", ", "").contains(','));
    if followed && alone {
        candidates.push((CommaAndBlank, b','));
    }
    candidates.extend([(Comma, b'.'), (Blanks, b'.'), (Blanks, b','), (Blank, b'.'), (Blank, b','), (Comma, b',')]);
    for other in [b'|', b'&', b':', b'/', b'~'] {
        candidates.extend([(Other(other), b'.'), (Other(other), b',')]);
    }
    candidates
}

/// The first lines that are not blank, and some from all over the text: a comma may be rare.
fn sample(text: &str) -> Vec<&str> {
    let mut lines: Vec<&str> = Vec::new();
    let mut end = 0;
    for line in text.split_inclusive('\n').take(10 * FIRST) {
        end += line.len();
        if !line.trim().is_empty() {
            lines.push(shortened(line));
        }
        if lines.len() == FIRST {
            break;
        }
    }
    let rest = text.len() - end;
    for part in 0..SPREAD * usize::from(rest > 0) {
        let place = end + rest / SPREAD * part;
        let bytes = text.as_bytes().get(place..).unwrap_or_default();
        let Some(start) = bytes.iter().take(100_000).position(|byte| *byte == b'\n').map(|newline| place + newline + 1)
        else {
            continue;
        };
        if let Some(line) =
            text.get(start..).and_then(|rest| rest.lines().next()).filter(|line| !line.trim().is_empty())
        {
            lines.push(shortened(line));
        }
    }
    lines
}

/// So much of a line as tells how it is written.
fn shortened(line: &str) -> &str {
    const LONG: usize = 4000;
    let line = line.trim_end_matches(['\n', '\r']);
    if line.len() <= LONG {
        return line;
    }
    let mut end = LONG;
    while !line.is_char_boundary(end) {
        end -= 1;
    }
    &line[..end]
}
