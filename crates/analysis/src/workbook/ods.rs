//! OpenDocument spreadsheets (ISO/IEC 26300): all sheets are in one part, one after the other.

use super::moment::{Meaning, Moment};
use super::refusal::WorkbookError;
use super::sheet::{LONGEST_VALUE, Lines, MOST_COLUMNS};
use super::source::{Progress, SheetSource, SheetText};
use super::styles::NumberFormat;
use packed::{Tag, Token, Xml};

/// Path of the part with the sheets.
pub(super) const CONTENT: &str = "content.xml";

/// Reader of the sheets, one after the other.
#[derive(Debug)]
pub(super) struct SheetsReader {
    xml: Xml,
    most: usize,
    sheet: Option<Sheet>,
    /// Depth of nesting in an element that is not part of the table, such as a remark or a drawing; 0 outside.
    skipping: usize,
}

/// Sheet being read.
#[derive(Debug)]
struct Sheet {
    name: String,
    lines: Lines,
    row: u32,
    column: u32,
    /// Number of repetitions of the present row, and true if it has a filled cell.
    repeated: u32,
    filled: bool,
    cell: Option<Cell>,
}

#[derive(Debug, Default)]
struct Cell {
    repeated: u32,
    kind: String,
    /// Value of a cell that is not a text.
    value: String,
    /// Text shown by the cell.
    text: String,
    in_paragraph: bool,
}

impl SheetsReader {
    pub fn new(xml: Xml, most: usize) -> Self {
        Self { xml, most, sheet: None, skipping: 0 }
    }
}

impl SheetSource for SheetsReader {
    fn progress(&self) -> f64 {
        self.xml.progress()
    }

    fn has_more(&mut self) -> bool {
        while self.sheet.is_none() {
            match self.xml.next_token() {
                Ok(Token::End) | Err(_) => return false,
                Ok(Token::Open(tag)) if tag.name() == "table" => {
                    self.sheet = Some(Sheet::new(tag.attribute("name").unwrap_or_default(), self.most));
                }
                Ok(_) => {}
            }
        }
        true
    }

    fn advance(&mut self, budget: u64) -> Result<Progress, WorkbookError> {
        let end = self.xml.position().saturating_add(budget);
        while self.xml.position() < end {
            let token = self.xml.next_token()?;
            if self.skipping > 0 {
                match token {
                    Token::Open(_) => self.skipping += 1,
                    Token::Close(_) => self.skipping -= 1,
                    Token::End => return Ok(Progress::End),
                    _ => {}
                }
                continue;
            }
            match (&token, &mut self.sheet) {
                (Token::End, _) => return Ok(Progress::End),
                (Token::Open(tag), None) if tag.name() == "table" => {
                    self.sheet = Some(Sheet::new(tag.attribute("name").unwrap_or_default(), self.most));
                }
                (Token::Open(tag), Some(_)) if matches!(tag.name(), "annotation" | "table" | "shapes" | "forms") => {
                    self.skipping = 1;
                }
                (Token::Close(_), Some(_)) if token.closes("table") => {
                    if let Some(sheet) = self.sheet.take() {
                        let text = SheetText { name: sheet.name, text: sheet.lines.finish() };
                        return Ok(Progress::Sheet(text));
                    }
                }
                (_, Some(sheet)) => sheet.take(&token)?,
                _ => {}
            }
        }
        Ok(Progress::More)
    }
}

impl Sheet {
    fn new(name: String, most: usize) -> Self {
        Self { name, lines: Lines::new(most), row: 0, column: 0, repeated: 1, filled: false, cell: None }
    }

    fn take(&mut self, token: &Token<'_>) -> Result<(), WorkbookError> {
        match token {
            Token::Open(tag) => match (tag.name(), &mut self.cell) {
                ("table-row", None) => {
                    self.repeated = tag.number("number-rows-repeated").unwrap_or(1).max(1);
                    (self.column, self.filled) = (0, false);
                }
                ("table-cell" | "covered-table-cell", None) => self.cell = Some(Cell::of(tag)),
                ("p", Some(cell)) => {
                    cell.in_paragraph = true;
                    if !cell.text.is_empty() {
                        cell.text.push(' ');
                    }
                }
                ("s" | "tab" | "line-break", Some(cell)) => cell.text.push(' '),
                _ => {}
            },
            Token::Text(text) => {
                if let Some(cell) = self.cell.as_mut().filter(|cell| cell.in_paragraph) {
                    cell.text.push_str(text);
                    if cell.text.len() > LONGEST_VALUE {
                        return Err(WorkbookError::Damaged);
                    }
                }
            }
            _ if token.closes("p") => {
                if let Some(cell) = &mut self.cell {
                    cell.in_paragraph = false;
                }
            }
            _ if token.closes("table-cell") || token.closes("covered-table-cell") => {
                if let Some(cell) = self.cell.take() {
                    self.write(&cell)?;
                }
            }
            _ if token.closes("table-row") => {
                if self.filled && self.repeated > 1 {
                    self.lines.repeat_row(self.repeated - 1)?;
                }
                self.row = self.row.saturating_add(self.repeated);
            }
            _ => {}
        }
        Ok(())
    }

    fn write(&mut self, cell: &Cell) -> Result<(), WorkbookError> {
        let next = self.column.saturating_add(cell.repeated);
        if !cell.is_empty() {
            // Repeated empty cells may extend beyond the last column; a repeated value there means a damaged file.
            let (row, first) = (self.row, self.column);
            for column in first..next.min(MOST_COLUMNS + 1) {
                self.lines.go_to(row, column, &|| format!("R{}C{}", row.saturating_add(1), column + 1))?;
                cell.write(&mut self.lines);
            }
            self.filled = true;
        }
        self.column = next;
        Ok(())
    }
}

impl Cell {
    fn of(tag: &Tag<'_>) -> Self {
        let kind = tag.attribute("value-type").unwrap_or_default();
        let value = match kind.as_str() {
            "float" | "percentage" | "currency" => "value",
            "date" => "date-value",
            "time" => "time-value",
            "boolean" => "boolean-value",
            _ => "string-value",
        };
        Self {
            repeated: tag.number("number-columns-repeated").unwrap_or(1).max(1),
            value: tag.attribute(value).unwrap_or_default(),
            kind,
            ..Self::default()
        }
    }

    fn is_empty(&self) -> bool {
        self.value.is_empty() && self.text.is_empty()
    }

    fn write(&self, lines: &mut Lines) {
        let moment = match self.kind.as_str() {
            "date" => Moment::of_iso(&self.value).map(|moment| Moment { meaning: Meaning::Date, ..moment }),
            "time" => Moment::of_duration(&self.value),
            _ => None,
        };
        match (moment, self.kind.as_str()) {
            (Some(moment), _) => lines.moment(moment),
            (None, "percentage") if !self.value.is_empty() => lines.percent(&self.value),
            (None, "float" | "currency") if !self.value.is_empty() => {
                lines.formatted(&self.value, NumberFormat::shown(&self.text), false);
            }
            (None, "boolean") => lines.word(if self.value == "true" { "TRUE" } else { "FALSE" }),
            _ if self.text.is_empty() => lines.word(&self.value),
            _ => lines.word(&self.text),
        }
    }
}
