//! Columns with another decimal sign than the rest of the file: `0.020;4,885`.

use super::cells::{COLUMNS, Cells};
use super::clock;
use super::first::First;
use super::format::Format;
use super::number::{self, Cell, Signs};
use super::refusal::{ImportError, Refusal};
use super::rows;
use crate::finding::Finding;

/// The first cells of a column that show what its signs mean.
#[derive(Clone, Debug, Default)]
struct Column {
    /// Whether one has the decimal sign of the file.
    usual: bool,
    /// A number only with the other decimal sign, `0.020`: line and text.
    other: Option<(usize, String)>,
    /// A number with that sign between thousands, `1.040`: line and text.
    grouped: Option<(usize, String)>,
}

/// What the signs in each column mean, while the rows are read.
#[derive(Debug, Default)]
pub(super) struct Survey {
    columns: Vec<Column>,
    /// How many lines have been read.
    lines: usize,
    /// Whether a number with groups has shown what the sign means: `1.295,5` or `1.234.567`.
    shown: bool,
}

/// Whether there can be columns with the other sign.
pub(super) fn is_open(rows: &str, format: &Format) -> bool {
    let sign = format.other_signs().decimal;
    // Between delimiters that are the sign itself it stands in quotation marks alone.
    let quoted = format.delimiter.byte() != Some(sign) || rows.as_bytes().contains(&b'"');
    quoted && rows.as_bytes().contains(&sign)
}

impl Survey {
    /// Reads the lines in about `budget` bytes of the rows; how many bytes that were.
    pub fn read(&mut self, rows: &str, budget: usize, first: First, format: &Format) -> usize {
        let mut at = 0;
        for line in rows.split_inclusive('\n') {
            if at >= budget {
                break;
            }
            at += line.len();
            self.line(line.trim_end_matches(['\n', '\r']), first.line, format);
            self.lines += 1;
        }
        at
    }

    fn line(&mut self, line: &str, header_lines: usize, format: &Format) {
        let others = format.other_signs();
        let sign = others.decimal;
        let is_number = |cell: &str, signs: Signs| matches!(number::cell(cell, signs), Cell::Number(_));
        for (place, cell) in Cells::of(line, format.delimiter).enumerate().take(COLUMNS) {
            let has = |sign: u8| cell.as_bytes().contains(&sign);
            if !has(sign) && !has(format.decimal) {
                continue;
            }
            if self.columns.len() <= place {
                self.columns.resize_with(place + 1, Column::default);
            }
            let Some(column) = self.columns.get_mut(place) else { continue };
            let here = || (header_lines + self.lines + 1, rows::excerpt(cell));
            if is_number(cell, format.signs()) {
                self.shown |= has(sign) && !number::could_be_grouped(cell, sign);
                if has(format.decimal) {
                    column.usual = true;
                } else {
                    column.grouped.get_or_insert_with(here);
                }
            } else if is_number(cell, others) && !number::could_be_grouped(cell, sign) && clock::read(cell).is_none() {
                column.other.get_or_insert_with(here);
            }
        }
    }

    /// The columns, from 0, whose decimal sign is not that of the file: one cell is a number with the other sign only, and no cell
    /// has the sign of the file. Of a sign between thousands it is said where nothing in the file shows that it is none of decimals.
    ///
    /// # Errors
    /// When a column has both decimal signs, and one of its numbers could be read with either.
    pub fn settle(self, findings: &mut Vec<Finding>) -> Result<Vec<usize>, ImportError> {
        let mut found = Vec::new();
        // Or the sign has been settled, and that was said.
        let mut shown = self.shown || !findings.is_empty();
        for (index, column) in self.columns.into_iter().enumerate() {
            let Some((_, beside)) = column.other else {
                if let Some((line, text)) = column.grouped.filter(|_| !shown && !column.usual) {
                    findings.push(Finding::GroupSign { line, text });
                    shown = true;
                }
                continue;
            };
            match column.grouped {
                Some((line, text)) if column.usual => {
                    return Err(ImportError::new(Some(line), Refusal::Separator { column: index + 1, text, beside }));
                }
                _ if !column.usual => found.push(index),
                _ => {}
            }
        }
        Ok(found)
    }
}
