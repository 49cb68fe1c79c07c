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

/// The columns, from 0, whose decimal sign is not that of the file: one cell is a number with the other sign only, and no cell
/// has the sign of the file. Of a sign between thousands it is said where nothing in the file shows that it is none of decimals.
///
/// # Errors
/// When a column has both decimal signs, and one of its numbers could be read with either.
pub(super) fn columns(
    text: &str,
    first: First,
    format: &Format,
    findings: &mut Vec<Finding>,
) -> Result<Vec<usize>, ImportError> {
    let rows = text.get(first.offset..).unwrap_or_default();
    let others = format.other_signs();
    let sign = others.decimal;
    if !rows.as_bytes().contains(&sign) {
        return Ok(Vec::new());
    }
    let is_number = |cell: &str, signs: Signs| matches!(number::cell(cell, signs), Cell::Number(_));
    let mut columns: Vec<Column> = Vec::new();
    // `1.295,5` or `1.234.567`, or `settle` has said it.
    let mut shown = !findings.is_empty();
    for (index, line) in rows.lines().enumerate() {
        for (place, cell) in Cells::of(line, format.delimiter).enumerate().take(COLUMNS) {
            let has = |sign: u8| cell.as_bytes().contains(&sign);
            if !has(sign) && !has(format.decimal) {
                continue;
            }
            if columns.len() <= place {
                columns.resize_with(place + 1, Column::default);
            }
            let Some(column) = columns.get_mut(place) else { continue };
            let here = || (first.line + index + 1, rows::excerpt(cell));
            if is_number(cell, format.signs()) {
                shown |= has(sign) && !number::could_be_grouped(cell, sign);
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
    let mut found = Vec::new();
    for (index, column) in columns.into_iter().enumerate() {
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
