//! Numbers as a CSV file, for programs and for spreadsheets of both kinds.

use crate::spreadsheet::Cell;
use std::fmt::Write;

/// How a CSV file is written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Dialect {
    /// Commas between the cells, decimal points: RFC 4180, what programs read.
    #[default]
    Commas,
    /// Semicolons between the cells, decimal commas, and a byte-order mark: what a spreadsheet opens correctly where the
    /// decimal sign is a comma.
    Semicolons,
}

/// A table with one header line. Numbers have all their digits; what is not finite is an empty cell. Columns may be of
/// different lengths.
pub fn write(headers: &[&str], columns: &[&[f64]], dialect: Dialect) -> String {
    let mut out = start(dialect);
    for (index, header) in headers.iter().enumerate() {
        separate(&mut out, index, dialect);
        write_text(&mut out, header);
    }
    out.push_str("\r\n");
    let rows = columns.iter().map(|column| column.len()).max().unwrap_or(0);
    for row in 0..rows {
        for (index, column) in columns.iter().enumerate() {
            separate(&mut out, index, dialect);
            if let Some(value) = column.get(row).filter(|value| value.is_finite()) {
                write_number(&mut out, *value, dialect);
            }
        }
        out.push_str("\r\n");
    }
    out
}

/// Rows of cells, those of the header among them.
pub fn write_rows(rows: &[Vec<Cell>], dialect: Dialect) -> String {
    let mut out = start(dialect);
    for row in rows {
        for (index, cell) in row.iter().enumerate() {
            separate(&mut out, index, dialect);
            match cell {
                Cell::Number(value) if value.is_finite() => write_number(&mut out, *value, dialect),
                Cell::Text(text) => write_text(&mut out, text),
                Cell::Number(_) | Cell::Empty => {}
            }
        }
        out.push_str("\r\n");
    }
    out
}

/// What a file begins with.
fn start(dialect: Dialect) -> String {
    match dialect {
        Dialect::Commas => String::new(),
        Dialect::Semicolons => "\u{feff}".to_owned(),
    }
}

/// The sign before every cell of a row but the first.
fn separate(out: &mut String, index: usize, dialect: Dialect) {
    if index > 0 {
        out.push(match dialect {
            Dialect::Commas => ',',
            Dialect::Semicolons => ';',
        });
    }
}

/// The shortest text that reads back as the same number.
fn write_number(out: &mut String, value: f64, dialect: Dialect) {
    let start = out.len();
    let size = value.abs();
    // Writing to a string cannot fail.
    let _ = if size == 0.0 || (1e-5..1e16).contains(&size) { write!(out, "{value}") } else { write!(out, "{value:E}") };
    if dialect == Dialect::Semicolons
        && let Some(point) = out[start..].find('.')
    {
        out.replace_range(start + point..=start + point, ",");
    }
}

/// A text, in quotation marks where it needs them. A spreadsheet must not take a name for a formula.
fn write_text(out: &mut String, text: &str) {
    let guarded = text.starts_with(['=', '+', '-', '@', '\t', '\r']);
    let quoted = guarded || text.contains([',', ';', '"', '\n', '\r']);
    if !quoted {
        out.push_str(text);
        return;
    }
    out.push('"');
    if guarded {
        out.push('\'');
    }
    out.push_str(&text.replace('"', "\"\""));
    out.push('"');
}
