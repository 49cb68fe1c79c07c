//! Columns with a decimal sign other than that of the file: `0.020;4,885`.

use super::cells::{COLUMNS, Cells};
use super::clock;
use super::first::First;
use super::format::Format;
use super::number::{self, Cell, Signs};
use super::refusal::{ImportError, Refusal};
use super::rows;
use crate::finding::Finding;

/// First cells of a column that show the meaning of its signs.
#[derive(Clone, Debug, Default)]
struct ColumnSigns {
    /// True if a cell has the decimal sign of the file.
    usual: bool,
    /// Line and text of a number that is only valid with the other decimal sign, `0.020`.
    other: Option<(usize, String)>,
    /// Line and text of a number with that sign between thousands, `1.040`.
    grouped: Option<(usize, String)>,
}

/// Meaning of the signs in each column, collected while the rows are read.
#[derive(Debug, Default)]
pub(super) struct Survey {
    columns: Vec<ColumnSigns>,
    /// Number of lines read.
    lines: usize,
    /// True if a number with groups has shown the meaning of the sign: `1.295,5` or `1.234.567`.
    shown: bool,
}

/// True if there may be columns with the other sign.
pub(super) fn is_open(rows: &str, format: &Format) -> bool {
    let sign = format.other_signs().decimal;
    // If the sign is the delimiter, it only occurs in quotation marks.
    let quoted = format.delimiter.byte() != Some(sign) || rows.as_bytes().contains(&b'"');
    quoted && rows.as_bytes().contains(&sign)
}

impl Survey {
    /// Reads the lines in about `budget` bytes of the rows. Returns the number of bytes read.
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
                self.columns.resize_with(place + 1, ColumnSigns::default);
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

    /// Columns, from 0, with another decimal sign than the file: at least one cell is a number only with the other sign,
    /// and no cell has the sign of the file. A sign between thousands is reported unless the file shows elsewhere that it
    /// is not a decimal sign.
    ///
    /// # Errors
    /// A column has both decimal signs, and one of its numbers can be read with either.
    pub fn settle(self, findings: &mut Vec<Finding>) -> Result<Vec<usize>, ImportError> {
        let mut found = Vec::new();
        // Also true if the meaning of the sign was reported already.
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
