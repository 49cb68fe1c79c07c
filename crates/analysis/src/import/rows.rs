//! Rows: one pass over the bytes, with numbers stored directly in columns.

use super::between::{self, Between};
use super::cells::{COLUMNS, Cells};
use super::format::Format;
use super::head::{self, Below};
use super::number::{self, Cell};
use super::others::{Other, Others};
use super::refusal::{ImportError, Refusal};
use crate::finding::Finding;
use crate::run_name;

/// Upper bound of the words, and of other cells by kind and column, that are listed individually.
const TOLD: usize = 5;
/// Upper bound of the number of cells, or the size of the file in bytes if that is greater. Beyond it a longer row adds no
/// columns; otherwise a small file could need any amount of memory.
const CELLS: usize = 4_000_000;

/// Columns of numbers, and cells that are not numbers.
#[derive(Debug, Default)]
pub(super) struct Rows {
    pub columns: Vec<Vec<f64>>,
    /// Number of rows.
    pub length: usize,
    /// Number of lines and bytes of the text, and of lines read.
    lines: usize,
    bytes: usize,
    line: usize,
    /// Columns with a decimal sign other than that of the file.
    pub mixed: Vec<usize>,
    /// Number of cells that hold a number.
    numbers: usize,
    /// Other contents of the cells, by column.
    pub others: Vec<Others>,
    /// The first of these cells in each column.
    listed: Vec<Listed>,
    /// Lines that hold only words: line of the first, and their number.
    pub word_lines: Option<(usize, usize)>,
    /// Number of these lines whose words all begin with a digit.
    pub unread_lines: usize,
    /// Rows before which a line of the header is repeated.
    pub repeats: Vec<usize>,
    /// Names of the runs that begin at the first row and at `repeats`; empty if they have none.
    pub titles: Vec<String>,
    /// Lines between the rows.
    pub between: Vec<Between>,
    /// Rows with too many cells: line of the first, and their number.
    long: Option<(usize, usize)>,
}

/// Cell that is not a plain number.
#[derive(Debug)]
struct Listed {
    line: usize,
    column: usize,
    text: String,
    what: What,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum What {
    Word,
    Clock,
    WithUnit,
}

/// Beginning of a text, for a message.
pub(super) fn excerpt(text: &str) -> String {
    const LONG: usize = 40;
    match text.char_indices().nth(LONG) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text.to_owned(),
    }
}

impl Rows {
    /// Empty rows for a text, with the columns that have the other decimal sign.
    pub fn of(text: &str, mixed: Vec<usize>) -> Self {
        let lines = text.bytes().filter(|byte| *byte == b'\n').count() + 1;
        Self { lines, bytes: text.len(), mixed, ..Self::default() }
    }

    /// Reads the lines in about `budget` bytes of `text`, which continues where the last call ended. Lines of the header
    /// may be repeated between them. Returns the number of bytes read.
    pub fn read(&mut self, text: &str, budget: usize, format: &Format, header: &[&str]) -> usize {
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
            let mut width = 0;
            if !number::plain(line.as_bytes(), (format.delimiter, format.decimal), &mut row) {
                row.clear();
                match self.any(line, number, format, &mut row) {
                    Some(found) => width = found,
                    None => {
                        between::keep(&mut self.between, self.length, number, line);
                        if self.repeats.last() != Some(&self.length) && is_in(header, line) {
                            self.repeats.push(self.length);
                        }
                        continue;
                    }
                }
            }
            self.push(&row, width, number);
        }
        at
    }

    /// Adds a row; `width` is the number of cells up to the last filled one, if that is not a plain number.
    fn push(&mut self, row: &[f64], width: usize, line: usize) {
        let (lines, cells) = (self.lines, self.bytes.max(CELLS));
        let filled = row.iter().rposition(|value| value.is_finite()).map_or(0, |last| last + 1).max(width);
        if filled == 0 {
            return;
        }
        if filled > self.columns.len() {
            let wanted = filled.min(COLUMNS).min((cells / lines).max(self.columns.len()));
            // Trailing cells may be missing in the first row, so later rows can be longer.
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

    /// Reads a line cell by cell. Returns the number of cells up to the last time or number with a unit; `None` if the line
    /// is not a row.
    fn any(&mut self, line: &str, number: usize, format: &Format, row: &mut Vec<f64>) -> Option<usize> {
        let start = line.trim_start();
        let comment = start.starts_with(['#', '%']) && !number::is_spreadsheet_error(head::first_word(start));
        if start.is_empty() || comment || start.starts_with("//") {
            return None;
        }
        // `Run 2` between blanks is a title, not a word and a number.
        if start.starts_with(char::is_alphabetic) && run_name::name(start).is_some() {
            self.word_lines.get_or_insert((number, 0)).1 += 1;
            return None;
        }
        let mut others: Vec<(usize, &str, Other)> = Vec::new();
        let (mut width, mut is_row) = (0, false);
        for (column, text) in Cells::of(line, format.delimiter).enumerate().take(COLUMNS) {
            let signs = if self.mixed.contains(&column) { format.other_signs() } else { format.signs() };
            let (value, other) = match number::cell(text, signs) {
                Cell::Number(value) => {
                    is_row = true;
                    if number::is_unusual(text) {
                        self.note_notation(number, column, text, value);
                    }
                    (value, None)
                }
                Cell::Gap => (f64::NAN, None),
                Cell::Word => (f64::NAN, Some(Other::of(text, signs))),
            };
            row.push(value);
            let Some(other) = other else { continue };
            if !matches!(other, Other::Word) {
                (width, is_row) = (column + 1, true);
            }
            others.push((column, text, other));
        }
        if !is_row {
            // Title or header between the rows.
            if !others.is_empty() {
                let digits = |text: &str| text.starts_with(|first: char| first.is_ascii_digit());
                self.unread_lines += usize::from(others.iter().all(|(_, text, _)| digits(text)));
                self.word_lines.get_or_insert((number, 0)).1 += 1;
            }
            return None;
        }
        for (column, text, other) in others {
            self.note(number, column, text, other);
        }
        Some(width)
    }

    fn note(&mut self, line: usize, column: usize, text: &str, other: Other) {
        if self.others.len() <= column {
            self.others.resize_with(column + 1, Others::default);
        }
        let (row, Some(mine)) = (self.length, self.others.get_mut(column)) else { return };
        let what = match other {
            Other::Word => {
                mine.words += 1;
                // A code such as `7BC4` or `CH1` is no number that failed.
                let is_code = text.bytes().all(|byte| byte.is_ascii_alphanumeric());
                let digits = text.contains(|letter: char| letter.is_ascii_digit());
                mine.codes += usize::from(is_code && digits);
                if !is_code && digits {
                    mine.digits += 1;
                    mine.first_digits.get_or_insert_with(|| (line, excerpt(text)));
                }
                mine.first.get_or_insert_with(|| (line, excerpt(text)));
                mine.labels.add(row, text);
                What::Word
            }
            Other::Clock(reading) => {
                mine.clocks.push((row, reading));
                What::Clock
            }
            Other::WithUnit(value, unit) => {
                // `100 ms` and `1.2 s` in one column: all in the unit of the first.
                let mut value = value;
                match &mut mine.unit {
                    Some((first, same)) if *first != unit => match head::ratio(&unit, first) {
                        Some(ratio) => value = if ratio < 1.0 { value / (1.0 / ratio).round() } else { value * ratio },
                        None => *same = false,
                    },
                    Some(_) => {}
                    None => mine.unit = Some((unit, true)),
                }
                mine.with_units.push((row, value));
                What::WithUnit
            }
        };
        let listed = &mut mine.listed[what as usize];
        *listed += 1;
        if *listed <= TOLD {
            self.listed.push(Listed { line, column, text: excerpt(text), what });
        }
    }

    /// Removes lines that begin a section from the lines of words.
    pub fn forget_lines(&mut self, lines: impl Iterator<Item = usize>) {
        for line in lines {
            self.word_lines = self
                .word_lines
                .filter(|(_, count)| *count > 1)
                .map(|(first, count)| (if first == line { line + 1 } else { first }, count - 1));
        }
    }

    fn note_notation(&mut self, line: usize, column: usize, text: &str, value: f64) {
        if self.others.len() <= column {
            self.others.resize_with(column + 1, Others::default);
        }
        if let Some(mine) = self.others.get_mut(column) {
            mine.notation.get_or_insert_with(|| (line, excerpt(text), value));
        }
    }

    /// Contents of a column besides numbers.
    pub fn others_mut(&mut self, column: usize) -> Option<&mut Others> {
        self.others.get_mut(column)
    }

    /// Stores values of cells set aside in a column, which are then no longer listed as words.
    pub fn accept(&mut self, column: usize, values: impl Iterator<Item = (usize, f64)>, clocks: bool) {
        let Some(cells) = self.columns.get_mut(column) else { return };
        for (row, value) in values {
            if let Some(cell) = cells.get_mut(row) {
                *cell = value;
                self.numbers += 1;
            }
        }
        let taken = if clocks { What::Clock } else { What::WithUnit };
        self.listed.retain(|one| one.column != column || one.what != taken);
    }

    /// Turns a column of times into words, because another column holds them better.
    pub fn leave_out(&mut self, column: usize) {
        let Some(cells) = self.columns.get_mut(column) else { return };
        let filled = cells.iter().filter(|value| value.is_finite()).count();
        cells.fill(f64::NAN);
        self.numbers -= filled;
        if let Some(others) = self.others.get_mut(column) {
            others.words += filled;
        }
    }

    /// Turns columns of codes into words: among `97E4`, `3D44` and `90BD`, `5E69` and `0134` are no numbers.
    pub fn leave_out_codes(&mut self) {
        let numbers = |values: &Vec<f64>| values.iter().filter(|value| value.is_finite()).count();
        let is_code = |(values, others): (&Vec<f64>, &Others)| others.codes > numbers(values).max(2);
        let codes: Vec<bool> = self.columns.iter().zip(&self.others).map(is_code).collect();
        for (column, _) in codes.into_iter().enumerate().filter(|(_, is_code)| *is_code) {
            self.leave_out(column);
            self.reject(column);
        }
    }

    /// Counts the unused times and numbers with units of a column as words.
    pub fn reject(&mut self, column: usize) {
        let Some(mine) = self.others.get_mut(column) else { return };
        mine.words += mine.clocks.len() + mine.with_units.len();
        mine.clocks.clear();
        mine.with_units.clear();
        let first = self.listed.iter().find(|one| one.column == column);
        mine.first = first.map(|one| (one.line, one.text.clone())).or(mine.first.take());
    }

    /// Adds columns that only the header has, within the bound on cells.
    pub fn widen(&mut self, wanted: usize, text: &str) {
        let most = text.len().max(CELLS) / self.length.max(1);
        let length = self.length;
        let wanted = wanted.min(COLUMNS).min(most).max(self.columns.len());
        self.columns.resize_with(wanted, || vec![f64::NAN; length]);
    }

    /// Properties of the rows needed to read the header.
    pub fn below(&self) -> Below<'_> {
        let wide = self.columns.len().max(self.others.len());
        // Columns that begin below a second header are not those of the first.
        let later = |column: &usize| self.columns.get(*column).is_some_and(|own| between::begins(&self.between, own));
        let wide = wide - (0..wide).rev().take_while(later).count();
        let numeric = |column: usize| {
            let others = self.others.get(column);
            let beside = others.map_or(0, |others| others.clocks.len() + others.with_units.len());
            let numbers = self.columns.get(column).map_or(0, |values| values.iter().filter(|v| v.is_finite()).count());
            numbers + beside > 0 && numbers + beside >= self.words_in(column)
        };
        let numbers = |column: usize| self.columns.get(column).map_or(&[][..], Vec::as_slice);
        Below { numeric: (0..wide).map(numeric).collect(), first: numbers(0), second: numbers(1) }
    }

    /// Number of words in a column.
    pub fn words_in(&self, column: usize) -> usize {
        self.others.get(column).map_or(0, |others| others.words)
    }

    /// First word of a column, and its line.
    pub fn first_word(&self, column: usize) -> Option<(usize, String)> {
        self.others.get(column).and_then(|others| others.first.clone())
    }

    /// Refuses fewer than two rows, or more words than numbers in columns that have numbers.
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
            let reported = self.listed.first().map(|one| (one.line, one.column, one.text.clone()));
            let (line, column, text) =
                reported.unwrap_or((self.word_lines.map_or(1, |lines| lines.0), 0, String::new()));
            return Err(ImportError::new(Some(line), Refusal::Words { column: column + 1, text }));
        }
        if self.length < 2 {
            return Err(ImportError::new(Some(header_lines + 1), Refusal::FewRows));
        }
        Ok(())
    }

    /// Notes on the rows, with columns named by `label`; columns without a label were left out as a whole.
    pub fn findings(&self, label: impl Fn(usize) -> Option<String>) -> Vec<Finding> {
        let mut findings = Vec::new();
        if let Some((line, count)) = self.word_lines {
            findings.push(Finding::WordLines { line, count });
        }
        let reported = self.listed.iter().filter_map(|one| {
            Some(Finding::Word { line: one.line, column: label(one.column)?, text: one.text.clone() })
        });
        findings.extend(reported.take(TOLD));
        let reported = findings.len() - usize::from(self.word_lines.is_some());
        let of_column = |(column, others): (usize, &Others)| label(column).map(|_| others.words);
        let all: usize = self.others.iter().enumerate().filter_map(of_column).sum();
        if all > reported {
            findings.push(Finding::MoreWords(all - reported));
        }
        let notation = |(column, others): (usize, &Others)| {
            let (line, text, value) = others.notation.clone()?;
            Some(Finding::Notation { line, column: label(column)?, text, value: value.to_string() })
        };
        findings.extend(self.others.iter().enumerate().filter_map(notation).take(TOLD));
        if let Some((line, count)) = self.long {
            findings.push(Finding::ExtraCells { line, count });
        }
        findings
    }
}

/// True if a line also occurs in the header.
fn is_in(header: &[&str], line: &str) -> bool {
    let line = line.trim();
    !line.is_empty() && header.iter().any(|header| header.trim() == line)
}
