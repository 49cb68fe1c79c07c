//! Delimited text as a table, without questions: delimiter, decimal sign, header, units, bodies and independent
//! variables are recognised.

mod cells;
mod decode;
mod format;
mod header;
mod number;
mod refusal;
mod roles;
mod rows;

pub use cells::Delimiter;
pub use decode::look;
pub use format::Format;
pub use refusal::{ImportError, Refusal};

use crate::finding::Finding;
use crate::table::{Column, Table};
use header::Head;
use rows::Rows;
use std::borrow::Cow;

/// A table and how it was read.
#[derive(Clone, Debug, PartialEq)]
pub struct Import {
    /// The table. Cells without a number are NaN.
    pub table: Table,
    /// What a person should know about the file.
    pub findings: Vec<Finding>,
    /// How the file is written.
    pub format: Format,
}

/// Nobody reads more about columns.
const FINDINGS: usize = 20;

/// Reads delimited text.
///
/// # Errors
/// When the bytes are no text, or the text is no table of at least two columns and rows of numbers.
pub fn text(bytes: &[u8]) -> Result<Import, ImportError> {
    let mut importer = Importer::new(decode::decode(bytes)?)?;
    while !importer.advance(usize::MAX) {}
    Ok(importer.finish()?.0)
}

/// A text, with `\n` at the ends of its lines or `\r\n`, of bytes that are not needed any more.
///
/// # Errors
/// When the bytes are no text.
pub fn decode(bytes: Vec<u8>) -> Result<String, ImportError> {
    decode::decode_owned(bytes)
}

/// A text that is being read, slice by slice: what is found is the same as at once.
#[derive(Debug)]
pub struct Importer<'a> {
    text: Cow<'a, str>,
    format: Format,
    first: First,
    rows: Rows,
    /// How many bytes of the rows have been read.
    read: usize,
}

impl<'a> Importer<'a> {
    /// Begins to read a text, as [`decode`] gives it: finds out how it is written and where its rows begin.
    ///
    /// # Errors
    /// When there are no rows of numbers.
    pub fn new(text: Cow<'a, str>) -> Result<Self, ImportError> {
        let (delimiter, decimal, words) = format::recognise(&text);
        let first = first_row(&text, delimiter, decimal, words)?;
        let format = Format { delimiter, decimal, header_lines: first.line };
        let rows = Rows::of(&text[first.offset..]);
        Ok(Self { text, format, first, rows, read: 0 })
    }

    /// The same for the cells of a spreadsheet, as [`sheet`] describes them.
    ///
    /// # Errors
    /// When there are no rows of numbers.
    pub fn of_sheet(cells: Cow<'a, str>) -> Result<Self, ImportError> {
        if cells.trim_start().is_empty() {
            return Err(ImportError::new(None, Refusal::Empty));
        }
        Self::new(cells)
    }

    /// Reads the rows in about `budget` bytes more. Whether all have been read.
    pub fn advance(&mut self, budget: usize) -> bool {
        let rest = &self.text[self.first.offset + self.read..];
        self.read += self.rows.read(rest, budget, &self.format);
        self.first.offset + self.read >= self.text.len()
    }

    /// Which part of the text has been read, from 0 to 1.
    pub fn progress(&self) -> f64 {
        (self.first.offset + self.read) as f64 / self.text.len().max(1) as f64
    }

    /// The table, once all rows have been read, and the text.
    ///
    /// # Errors
    /// When it is no table of at least two columns and rows of numbers.
    pub fn finish(self) -> Result<(Import, Cow<'a, str>), ImportError> {
        let Self { text, format, first, mut rows, .. } = self;
        let mut findings = Vec::new();
        let head_lines: Vec<&str> = text[..first.offset].lines().collect();
        let mut heads = header::read(&head_lines, format.delimiter, rows.columns.len(), &mut findings);
        findings.truncate(FINDINGS);
        refuse_double_commas(&heads, &rows, &format)?;
        rows.widen(heads.len(), &text);
        heads.resize(rows.columns.len(), Head::default());
        rows.refuse_words(first.line)?;
        let mut columns = Vec::with_capacity(heads.len());
        let mut kept = Vec::new();
        for (index, (head, values)) in heads.into_iter().zip(std::mem::take(&mut rows.columns)).enumerate() {
            let words = rows.words_in(index);
            let filled = values.iter().filter(|value| value.is_finite()).count();
            if filled == 0 && (words > 0 || head.name.is_empty()) {
                // A delimiter at the end of each line makes an empty column; words are no measurement.
                if words > 0 && findings.len() < FINDINGS {
                    findings.push(Finding::WordColumn(called(&head.name, index)));
                }
                continue;
            }
            if filled == 0 && findings.len() < FINDINGS {
                findings.push(Finding::EmptyColumn(called(&head.name, index)));
            }
            kept.push(index);
            columns.push(Column { name: head.name, unit: head.unit, body: head.body, independent: 0, values });
        }
        if columns.iter().filter(|column| column.filled() > 0).count() < 2 {
            return Err(ImportError::new(Some(first.line + 1), Refusal::OneColumn));
        }
        roles::assign(&mut columns);
        let table = Table { columns };
        let label = |index| kept.iter().position(|kept| *kept == index).map(|place| table.label(place));
        findings.extend(rows.findings(label));
        Ok((Import { table, findings, format }, text))
    }
}

/// Reads the cells of a spreadsheet, by the same rules as a text.
///
/// The cells come as text: a row is a line, cells are divided by tabs and stand in the columns that they have in the sheet.
/// Numbers have a decimal point and no other sign (`{:?}` of an `f64`); texts have neither tabs nor line ends nor quotation
/// marks; an error is written as the sheet shows it, `#DIV/0!`. A date with a time is `2026-01-02T10:00:00.050`, a time of day
/// or a duration `10:00:00.050` (hours may exceed 24), a date `2026-01-02`: such a column is read in seconds from its
/// first row.
///
/// # Errors
/// As [`text`].
pub fn sheet(cells: &str) -> Result<Import, ImportError> {
    let mut importer = Importer::of_sheet(Cow::Borrowed(cells))?;
    while !importer.advance(usize::MAX) {}
    Ok(importer.finish()?.0)
}

fn called(name: &str, index: usize) -> String {
    if name.is_empty() { (index + 1).to_string() } else { name.to_owned() }
}

/// Where the rows begin.
#[derive(Clone, Copy, Debug)]
struct First {
    /// How many lines come before.
    line: usize,
    /// How many bytes come before.
    offset: usize,
}

/// The first line with at least two numbers and no more words than the rows have.
fn first_row(text: &str, delimiter: Delimiter, decimal: u8, words: usize) -> Result<First, ImportError> {
    let mut offset = 0;
    let mut lonely = None;
    // Rows with gaps just before it belong to the table too.
    let mut gaps = None;
    for (line, content) in text.split_inclusive('\n').enumerate() {
        let count = format::count(content.trim_end_matches(['\n', '\r']), delimiter, decimal);
        if count.numbers >= 2 && count.words <= words {
            return Ok(gaps.unwrap_or(First { line, offset }));
        }
        if count.numbers == 1 && count.words == 0 && count.all >= 2 {
            gaps.get_or_insert(First { line, offset });
        } else {
            gaps = None;
        }
        if count.numbers == 1 && count.words == 0 && count.cells == 1 {
            lonely.get_or_insert(line + 1);
        }
        offset += content.len();
    }
    Err(match lonely {
        Some(line) => ImportError::new(Some(line), Refusal::OneColumn),
        None => {
            let (line, text) = text.lines().enumerate().find(|(_, text)| !text.trim().is_empty()).unwrap_or((0, ""));
            ImportError::new(Some(line + 1), Refusal::NoNumbers { text: rows::excerpt(text.trim()) })
        }
    })
}

/// Two names over four numbers, all commas: nobody can tell which commas are decimal signs.
fn refuse_double_commas(heads: &[Head], rows: &Rows, format: &Format) -> Result<(), ImportError> {
    let names = heads.iter().take_while(|head| !head.name.is_empty()).count();
    let whole = |values: &Vec<f64>| values.iter().all(|value| value.is_nan() || value.fract() == 0.0);
    if format.delimiter == Delimiter::Comma
        && names >= 2
        && rows.columns.len() == 2 * names
        && heads.iter().skip(names).all(|head| head.name.is_empty())
        && rows.columns.iter().all(whole)
    {
        return Err(ImportError::new(
            Some(format.header_lines + 1),
            Refusal::Commas { names, cells: rows.columns.len() },
        ));
    }
    Ok(())
}
