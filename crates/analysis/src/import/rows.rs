//! The rows: one pass over the bytes, numbers straight into columns.

use super::cells::{Cells, Delimiter};
use super::format::Format;
use super::number::{self, Cell};
use super::refusal::{ImportError, Refusal};
use crate::finding::Finding;

/// So many words are told one by one.
const TOLD: usize = 5;
/// So many cells, or as many as the file has bytes: then a longer row makes no new columns. Otherwise a small file could
/// ask for any amount of memory.
const CELLS: usize = 4_000_000;
/// No table of measured data has more columns.
const COLUMNS: usize = 10_000;

/// The columns, and what was no number.
#[derive(Debug, Default)]
pub(super) struct Rows {
    pub columns: Vec<Vec<f64>>,
    /// How many rows.
    pub length: usize,
    /// How many lines and bytes the text has, and how many of its lines were read.
    lines: usize,
    bytes: usize,
    line: usize,
    /// How many cells hold a number.
    numbers: usize,
    /// How many hold a word, by column.
    words: Vec<usize>,
    /// The first words: line, column, text.
    told: Vec<(usize, usize, String)>,
    /// Lines of words alone: the first, and how many.
    word_lines: Option<(usize, usize)>,
    /// Rows with too many cells: the first, and how many.
    long: Option<(usize, usize)>,
}

/// The beginning of a text, for a message.
pub(super) fn excerpt(text: &str) -> String {
    const LONG: usize = 40;
    match text.char_indices().nth(LONG) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text.to_owned(),
    }
}

impl Rows {
    /// None yet, of a text of this length.
    pub fn of(text: &str) -> Self {
        let lines = text.bytes().filter(|byte| *byte == b'\n').count() + 1;
        Self { lines, bytes: text.len(), ..Self::default() }
    }

    /// Reads the lines in about `budget` bytes of `text`, which goes on where the last reading ended. How many bytes that
    /// were.
    pub fn read(&mut self, text: &str, budget: usize, format: &Format) -> usize {
        let mut row: Vec<f64> = Vec::new();
        let mut at = 0;
        while at < text.len().min(budget) {
            let rest = &text[at..];
            let end = rest.find('\n').map_or(rest.len(), |end| end + 1);
            at += end;
            self.line += 1;
            let number = format.header_lines + self.line;
            let line = &rest[..end];
            let line = line.strip_suffix('\n').map_or(line, |line| line.strip_suffix('\r').unwrap_or(line));
            row.clear();
            if !plain(line.as_bytes(), format, &mut row) {
                row.clear();
                if !self.any(line, number, format, &mut row) {
                    continue;
                }
            }
            self.push(&row, number);
        }
        at
    }

    fn push(&mut self, row: &[f64], line: usize) {
        let (lines, cells) = (self.lines, self.bytes.max(CELLS));
        let filled = row.iter().rposition(|value| value.is_finite()).map_or(0, |last| last + 1);
        if filled == 0 {
            return;
        }
        if filled > self.columns.len() {
            let wanted = filled.min(COLUMNS).min((cells / lines).max(self.columns.len()));
            // The first row may have missing last cells, so later rows can be longer.
            while self.columns.len() < wanted {
                let mut column = Vec::with_capacity(lines);
                column.resize(self.length, f64::NAN);
                self.columns.push(column);
            }
            if filled > wanted {
                self.long.get_or_insert((line, 0)).1 += 1;
            }
        }
        for (index, column) in self.columns.iter_mut().enumerate() {
            let value = row.get(index).copied().unwrap_or(f64::NAN);
            self.numbers += usize::from(value.is_finite());
            column.push(value);
        }
        self.length += 1;
    }

    /// Reads a line cell by cell; false if it is no row.
    fn any(&mut self, line: &str, number: usize, format: &Format, row: &mut Vec<f64>) -> bool {
        let start = line.trim_start();
        if start.is_empty() || start.starts_with(['#', '%']) || start.starts_with("//") {
            return false;
        }
        let before = self.told.len();
        let (mut words, mut numbers) = (0, 0);
        for (column, text) in Cells::of(line, format.delimiter).enumerate().take(COLUMNS) {
            row.push(match number::cell(text, format.decimal) {
                Cell::Number(value) => {
                    numbers += 1;
                    value
                }
                Cell::Gap => f64::NAN,
                Cell::Word => {
                    words += 1;
                    if self.told.len() < 100 {
                        self.told.push((number, column, excerpt(text)));
                    }
                    if self.words.len() <= column {
                        self.words.resize(column + 1, 0);
                    }
                    self.words[column] += 1;
                    f64::NAN
                }
            });
        }
        if numbers == 0 && words > 0 {
            // A title or a header between the rows.
            self.word_lines.get_or_insert((number, 0)).1 += 1;
            for (_, column, _) in self.told.drain(before..) {
                self.words[column] -= 1;
            }
        }
        numbers > 0
    }

    /// Makes room for columns that only the header has, as far as the bound on cells lets it.
    pub fn widen(&mut self, wanted: usize, text: &str) {
        let most = text.len().max(CELLS) / self.length.max(1);
        let length = self.length;
        let wanted = wanted.min(COLUMNS).min(most).max(self.columns.len());
        self.columns.resize_with(wanted, || vec![f64::NAN; length]);
    }

    /// How many words a column has.
    pub fn words_in(&self, column: usize) -> usize {
        self.words.get(column).copied().unwrap_or(0)
    }

    /// Refuses what is no table: fewer than two rows, or more words than numbers in columns that have numbers.
    pub fn refuse_words(&self, header_lines: usize) -> Result<(), ImportError> {
        let in_columns: usize = self
            .columns
            .iter()
            .enumerate()
            .filter(|(_, values)| values.iter().any(|value| value.is_finite()))
            .map(|(index, _)| self.words_in(index))
            .sum();
        let lines = self.word_lines.map_or(0, |(_, count)| count);
        if in_columns > self.numbers || lines > self.length {
            let told = self.told.first();
            let (line, column, text) =
                told.cloned().unwrap_or((self.word_lines.map_or(1, |lines| lines.0), 0, String::new()));
            return Err(ImportError::new(Some(line), Refusal::Words { column: column + 1, text }));
        }
        if self.length < 2 {
            return Err(ImportError::new(Some(header_lines + 1), Refusal::FewRows));
        }
        Ok(())
    }

    /// What was noticed, with columns called by `label`; columns without one were left out as a whole.
    pub fn findings(&self, label: impl Fn(usize) -> Option<String>) -> Vec<Finding> {
        let mut findings = Vec::new();
        if let Some((line, count)) = self.word_lines {
            findings.push(Finding::WordLines { line, count });
        }
        let told = self.told.iter().filter_map(|(line, column, text)| {
            Some(Finding::Word { line: *line, column: label(*column)?, text: text.clone() })
        });
        findings.extend(told.take(TOLD));
        let told = findings.len() - usize::from(self.word_lines.is_some());
        let all: usize =
            self.words.iter().enumerate().filter(|(column, _)| label(*column).is_some()).map(|(_, words)| words).sum();
        if all > told {
            findings.push(Finding::MoreWords(all - told));
        }
        if let Some((line, count)) = self.long {
            findings.push(Finding::ExtraCells { line, count });
        }
        findings
    }
}

/// Reads a line that holds nothing but numbers, gaps and delimiters; false for any other.
fn plain(line: &[u8], format: &Format, row: &mut Vec<f64>) -> bool {
    let any_blanks = format.delimiter == Delimiter::Blanks;
    let delimiter = match format.delimiter.byte() {
        Some(byte) => byte,
        None if any_blanks => b' ',
        None => return false,
    };
    let is_blank = |byte: u8| byte != delimiter && matches!(byte, b' ' | b'\t') || any_blanks && byte == b'\t';
    let mut at = 0;
    let skip = |mut at: usize| {
        while line.get(at).is_some_and(|byte| is_blank(*byte) || any_blanks && *byte == b' ') {
            at += 1;
        }
        at
    };
    loop {
        at = skip(at);
        match number::scan(&line[at..], format.decimal) {
            Some((value, length)) => {
                row.push(value);
                at += length;
            }
            None if line.get(at).is_none_or(|byte| *byte == delimiter) => row.push(f64::NAN),
            None => return false,
        }
        let after = skip(at);
        match line.get(after) {
            None => return true,
            // The blanks that were skipped are the delimiter.
            Some(_) if any_blanks && after > at => at = after,
            Some(byte) if !any_blanks && *byte == delimiter => at = after + 1,
            Some(_) => return false,
        }
    }
}
