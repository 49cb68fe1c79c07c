//! Tables of numbers as CSV files, with the separators and decimal signs of [`Dialect`].

use crate::scale_line;
use crate::spreadsheet::Cell;
pub use engine::csv::Dialect;

/// Table of a film as in [`write()`], below a line with the relative standard error of its scale, if there is one.
pub fn write_film(headers: &[&str], columns: &[&[f64]], scale_error: Option<f64>, dialect: Dialect) -> String {
    let mut out = dialect.start().to_owned();
    if let Some(error) = scale_error {
        write_row(&mut out, std::iter::once(Borrowed::Text(&scale_line(error))), dialect);
    }
    add_table(&mut out, headers, columns, dialect);
    out
}

/// Table with one header line. Numbers have all their digits; a number that is not finite is an empty cell. Columns may
/// differ in length.
pub fn write(headers: &[&str], columns: &[&[f64]], dialect: Dialect) -> String {
    let mut out = dialect.start().to_owned();
    add_table(&mut out, headers, columns, dialect);
    out
}

fn add_table(out: &mut String, headers: &[&str], columns: &[&[f64]], dialect: Dialect) {
    write_row(out, headers.iter().map(|header| Borrowed::Text(header)), dialect);
    let rows = columns.iter().map(|column| column.len()).max().unwrap_or(0);
    for row in 0..rows {
        let cells = columns.iter().map(|column| Borrowed::Number(column.get(row).copied().unwrap_or(f64::NAN)));
        write_row(out, cells, dialect);
    }
}

/// Table of rows of cells, including the header.
pub fn write_rows(rows: &[Vec<Cell>], dialect: Dialect) -> String {
    let mut out = dialect.start().to_owned();
    for row in rows {
        let cells = row.iter().map(|cell| match cell {
            Cell::Number(value) => Borrowed::Number(*value),
            Cell::Text(text) => Borrowed::Text(text),
            Cell::Empty => Borrowed::Text(""),
        });
        write_row(&mut out, cells, dialect);
    }
    out
}

enum Borrowed<'a> {
    Number(f64),
    Text(&'a str),
}

fn write_row<'a>(out: &mut String, cells: impl Iterator<Item = Borrowed<'a>>, dialect: Dialect) {
    for (index, cell) in cells.enumerate() {
        if index > 0 {
            out.push(dialect.separator());
        }
        // Writing to a string cannot fail.
        let _ = match cell {
            Borrowed::Number(value) => dialect.number(out, value),
            Borrowed::Text(text) => dialect.text(out, text),
        };
    }
    out.push_str(dialect.line_end());
}
