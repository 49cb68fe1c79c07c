//! Cells of a sheet. Their records may be in any order, so they are listed first and then written row by row.

use super::book::{BOF, Book, EOF};
use super::record::{Content, Record, rk};
use crate::workbook::refusal::WorkbookError;
use crate::workbook::sheet::Lines;
use packed::bytes::{double, float, word};

const LABEL_SST: u16 = 0x00fd;
const LABEL: u16 = 0x0204;
const RICH_LABEL: u16 = 0x00d6;
const NUMBER: u16 = 0x0203;
const RK: u16 = 0x027e;
const MULTIPLE_RK: u16 = 0x00bd;
const FORMULA: u16 = 0x0006;
const TEXT: u16 = 0x0207;
const BOOLEAN_OR_ERROR: u16 = 0x0205;
/// Number of columns of a sheet.
const MOST_COLUMNS: u16 = 256;
/// Number of bytes that a written cell counts in the budget.
const BYTES_PER_CELL: u64 = 16;

/// Sheet being read.
#[derive(Debug)]
pub(super) struct SheetReader {
    stage: Stage,
    lines: Lines,
    cells: Vec<Cell>,
}

#[derive(Debug)]
enum Stage {
    /// Listing the cells: offset of the next record, depth of nested substreams (charts within a sheet), and position of a
    /// formula whose text follows.
    Listing { at: usize, depth: usize, formula: Option<(u16, u16)> },
    /// Writing the cells: number of cells done.
    Writing(usize),
}

/// Filled cell.
#[derive(Clone, Copy, Debug)]
struct Cell {
    row: u16,
    column: u16,
    /// Offset of its record in the stream, or of its entry in a record with several cells.
    at: u32,
    holds: Holds,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Holds {
    /// Record of its own.
    Record,
    /// Entry of a record with several numbers.
    Entry,
}

impl SheetReader {
    /// Begins at this offset of the stream; the text may have at most `most` bytes.
    pub fn new(at: usize, most: usize) -> Self {
        let stage = Stage::Listing { at, depth: 0, formula: None };
        Self { stage, lines: Lines::new(most), cells: Vec::new() }
    }

    /// Progress, from 0 to 1.
    pub fn progress(&self) -> f64 {
        match self.stage {
            Stage::Listing { .. } => 0.0,
            Stage::Writing(done) => 0.5 + 0.5 * done as f64 / self.cells.len().max(1) as f64,
        }
    }

    /// Reads about `budget` more bytes of the stream. Returns true at the end.
    pub fn read(&mut self, stream: &[u8], book: &Book, budget: u64) -> Result<bool, WorkbookError> {
        match self.stage {
            Stage::Listing { at, depth, formula } => {
                self.stage = self.list(stream, budget, at, depth, formula)?;
                Ok(false)
            }
            Stage::Writing(done) => {
                let count = usize::try_from(budget / BYTES_PER_CELL).unwrap_or(usize::MAX).max(1);
                let end = done.saturating_add(count).min(self.cells.len());
                for index in done..end {
                    let Some(cell) = self.cells.get(index).copied() else { break };
                    // Of several records for one cell the last one holds.
                    let again = |next: &Cell| (next.row, next.column) == (cell.row, cell.column);
                    if !self.cells.get(index + 1).is_some_and(again) {
                        write(&mut self.lines, cell, stream, book)?;
                    }
                }
                self.stage = Stage::Writing(end);
                Ok(end == self.cells.len())
            }
        }
    }

    /// Returns the text.
    pub fn finish(self) -> String {
        self.lines.finish()
    }

    fn list(
        &mut self,
        stream: &[u8],
        budget: u64,
        mut at: usize,
        mut depth: usize,
        mut formula: Option<(u16, u16)>,
    ) -> Result<Stage, WorkbookError> {
        let end = at.saturating_add(usize::try_from(budget).unwrap_or(usize::MAX).max(1));
        while at < end {
            let record = Record::at(stream, at).ok_or(WorkbookError::Damaged)?;
            match record.kind {
                BOF => depth += 1,
                _ if depth == 0 => return Err(WorkbookError::Damaged),
                EOF if depth == 1 => {
                    let place = |cell: &Cell| (cell.row, cell.column);
                    if !self.cells.is_sorted_by_key(place) {
                        self.cells.sort_by_key(place);
                    }
                    return Ok(Stage::Writing(0));
                }
                EOF => depth -= 1,
                _ if depth > 1 => {}
                _ => self.take(stream, at, record, &mut formula)?,
            }
            at = record.end;
        }
        Ok(Stage::Listing { at, depth, formula })
    }

    /// Lists the cells of a record, if it has any.
    fn take(
        &mut self,
        stream: &[u8],
        at: usize,
        record: Record,
        formula: &mut Option<(u16, u16)>,
    ) -> Result<(), WorkbookError> {
        let content = record.content(stream);
        let place = || word(content, 0).zip(word(content, 2)).ok_or(WorkbookError::Damaged);
        match record.kind {
            LABEL_SST | LABEL | RICH_LABEL | NUMBER | RK | BOOLEAN_OR_ERROR => {
                self.push(place()?, at, Holds::Record)?;
            }
            FORMULA => {
                let place = place()?;
                // The text result of a formula is in a later record.
                if content.get(12..14) == Some(&[0xff, 0xff]) && content.get(6) == Some(&0) {
                    *formula = Some(place);
                } else {
                    self.push(place, at, Holds::Record)?;
                }
            }
            TEXT => {
                if let Some(place) = formula.take() {
                    self.push(place, at, Holds::Record)?;
                }
            }
            MULTIPLE_RK => {
                let (row, first) = place()?;
                let entries = content.len().saturating_sub(6) / 6;
                for index in 0..entries {
                    let column = first.checked_add(index as u16).ok_or(WorkbookError::Damaged)?;
                    self.push((row, column), record.start + 4 + 6 * index, Holds::Entry)?;
                }
            }
            _ => {}
        }
        Ok(())
    }

    fn push(&mut self, (row, column): (u16, u16), at: usize, holds: Holds) -> Result<(), WorkbookError> {
        let at = u32::try_from(at).map_err(|_| WorkbookError::Damaged)?;
        if column >= MOST_COLUMNS {
            return Err(WorkbookError::Place { cell: format!("R{}C{}", u32::from(row) + 1, u32::from(column) + 1) });
        }
        self.cells.push(Cell { row, column, at, holds });
        Ok(())
    }
}

/// Writes a cell.
fn write(lines: &mut Lines, cell: Cell, stream: &[u8], book: &Book) -> Result<(), WorkbookError> {
    let (row, column, at) = (u32::from(cell.row), u32::from(cell.column), cell.at as usize);
    let go_to = |lines: &mut Lines| lines.go_to(row, column, &String::new);
    let number = |lines: &mut Lines, style: u16, value: f64| {
        if !value.is_finite() {
            return Ok(());
        }
        go_to(lines)?;
        lines.formatted(&format!("{value:?}"), book.style(style), book.from_1904);
        Ok(())
    };
    if cell.holds == Holds::Entry {
        let (style, value) = word(stream, at).zip(rk(stream, at + 2)).ok_or(WorkbookError::Damaged)?;
        return number(lines, style, value);
    }
    let record = Record::at(stream, at).ok_or(WorkbookError::Damaged)?;
    let content = record.content(stream);
    let style = word(content, 4).unwrap_or_default();
    let found = match record.kind {
        NUMBER => float(content, 6).map(Value::Number),
        RK => rk(content, 6).map(Value::Number),
        LABEL_SST => double(content, 6).and_then(|index| book.texts.get(index as usize)).map(Value::Shared),
        LABEL | RICH_LABEL => text(stream, record, 6, book).map(Value::Text),
        TEXT => text(stream, record, 0, book).map(Value::Text),
        BOOLEAN_OR_ERROR => content.get(6).copied().zip(content.get(7).copied()).map(Value::of_code),
        _ => formula(content),
    };
    let found = found.ok_or(WorkbookError::Damaged)?;
    let text = match &found {
        Value::Number(value) => return number(lines, style, *value),
        Value::Shared(text) => text,
        Value::Text(text) => text.as_str(),
    };
    if !text.is_empty() {
        lines.go_to(row, column, &String::new)?;
        lines.word(text);
    }
    Ok(())
}

/// Value of a cell.
#[derive(Debug)]
enum Value<'a> {
    Number(f64),
    Shared(&'a str),
    Text(String),
}

impl Value<'_> {
    /// Boolean or error from its code; the second byte is 0 for a boolean.
    fn of_code((code, is_error): (u8, u8)) -> Self {
        Self::Shared(match (code, is_error) {
            (0, 0) => "FALSE",
            (_, 0) => "TRUE",
            (0x00, _) => "#NULL!",
            (0x07, _) => "#DIV/0!",
            (0x0f, _) => "#VALUE!",
            (0x17, _) => "#REF!",
            (0x1d, _) => "#NAME?",
            (0x24, _) => "#NUM!",
            _ => "#N/A",
        })
    }
}

/// Stored result of a formula that is not a text: a number, or a value encoded in the bits of a NaN.
fn formula(content: &[u8]) -> Option<Value<'static>> {
    if content.get(12..14)? != [0xff, 0xff] {
        return float(content, 6).map(Value::Number);
    }
    let code = *content.get(8)?;
    Some(match content.get(6)? {
        1 => Value::of_code((code, 0)),
        2 => Value::of_code((code, 1)),
        _ => Value::Shared(""),
    })
}

/// Text with its length, after `before` bytes of a record.
fn text(stream: &[u8], record: Record, before: usize, book: &Book) -> Option<String> {
    let mut content = Content::of(stream, record);
    content.skip(before)?;
    let length = content.word()?;
    let mut text = String::new();
    book.text(&mut content, length.into(), &mut text)?;
    Some(text)
}
