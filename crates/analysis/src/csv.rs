//! Tables of numbers as CSV files, for programs and for spreadsheets of both kinds.

use crate::spreadsheet::Cell;
pub use engine::csv::Dialect;

/// A table with one header line. Numbers have all their digits; what is not finite is an empty cell. Columns may be of
/// different lengths.
pub fn write(headers: &[&str], columns: &[&[f64]], dialect: Dialect) -> String {
    let mut out = dialect.start().to_owned();
    write_row(&mut out, headers.iter().map(|header| Borrowed::Text(header)), dialect);
    let rows = columns.iter().map(|column| column.len()).max().unwrap_or(0);
    for row in 0..rows {
        let cells = columns.iter().map(|column| Borrowed::Number(column.get(row).copied().unwrap_or(f64::NAN)));
        write_row(&mut out, cells, dialect);
    }
    out
}

/// Rows of cells, those of the header among them.
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
