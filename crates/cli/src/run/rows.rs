//! Formats of the rows of a run: CSV, an array of JSON objects, or one JSON object per line.

use crate::arguments::Format;
use engine::History;
use engine::csv::Dialect;
use engine::table::{Cell, Column, Table};
use serde::ser::SerializeMap;
use serde::{Serialize, Serializer};
use serde_json::ser::Formatter;
use std::io::{self, Write};
use units::number::shortest;

/// Writer of the rows of a table.
pub struct Rows {
    table: Table,
    format: Format,
    /// Keys of the objects: the headings of the columns.
    keys: Vec<String>,
    /// True if a row has been written.
    any: bool,
}

impl Rows {
    /// Writer of the rows of `table`.
    pub fn new(table: Table, format: Format) -> Self {
        let keys = table.columns().iter().map(Column::heading).collect();
        Self { table, format, keys, any: false }
    }

    /// Writes the text before the first row.
    pub fn head(&self, out: &mut String) {
        match self.format {
            // Writing to a string cannot fail.
            Format::Csv => drop(self.table.write_head(Dialect::Lines, out)),
            Format::Json => out.push('['),
            Format::Jsonl => {}
        }
    }

    /// Writes a row.
    pub fn row(&mut self, history: &History, row: usize, out: &mut String) {
        let first = !std::mem::replace(&mut self.any, true);
        match self.format {
            Format::Csv => drop(self.table.write_row(Dialect::Lines, history, row, out)),
            Format::Json => {
                out.push_str(if first { "\n" } else { ",\n" });
                out.push_str(&object(&self.keys, self.table.row(history, row)));
            }
            Format::Jsonl => {
                out.push_str(&object(&self.keys, self.table.row(history, row)));
                out.push('\n');
            }
        }
    }

    /// Writes the text after the last row.
    pub fn end(&self, out: &mut String) {
        if self.format == Format::Json {
            out.push_str("\n]\n");
        }
    }
}

/// A row as a JSON object.
fn object(keys: &[String], cells: &[Cell]) -> String {
    let mut bytes = Vec::new();
    let mut serializer = serde_json::Serializer::with_formatter(&mut bytes, ShortestNumbers);
    // Texts and numbers can always be serialised.
    let _ = Row { keys, cells }.serialize(&mut serializer);
    String::from_utf8(bytes).unwrap_or_default()
}

/// A row with the headings of its columns.
struct Row<'a> {
    keys: &'a [String],
    cells: &'a [Cell],
}

impl Serialize for Row<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut object = serializer.serialize_map(Some(self.keys.len()))?;
        for (key, cell) in self.keys.iter().zip(self.cells) {
            match cell {
                // NaN and infinities become null.
                Cell::Number(value) => object.serialize_entry(key, value)?,
                Cell::Truth(value) => object.serialize_entry(key, value)?,
                Cell::Text(text) => object.serialize_entry(key, &**text)?,
            }
        }
        object.end()
    }
}

/// JSON formatter with the same digits as the CSV of the run: `5`, not `5.0`.
struct ShortestNumbers;

impl Formatter for ShortestNumbers {
    fn write_f64<W: ?Sized + Write>(&mut self, out: &mut W, value: f64) -> io::Result<()> {
        out.write_all(shortest(value).as_bytes())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn objects_have_the_headings_as_keys() {
        let keys = ["t [s]", "kind", "late", "w \"1\"", "b"].map(str::to_owned);
        let cells = |w: f64, b: f64| {
            [
                Cell::Number(0.1),
                Cell::Text("\u{1}late,\n\"é\"\\\u{7f}".into()),
                Cell::Truth(true),
                Cell::Number(w),
                Cell::Number(b),
            ]
        };
        let text = r#""t [s]":0.1,"kind":"\u0001late,\n\"é\"\\"#.to_owned() + "\u{7f}\",\"late\":true";
        for (w, b, numbers) in [
            (f64::NAN, f64::INFINITY, r#""w \"1\"":null,"b":null"#),
            (5.0, -0.0, r#""w \"1\"":5,"b":-0"#),
            (1e-7, 1e16, r#""w \"1\"":1e-7,"b":1e16"#),
            (0.1 + 0.2, 1e15, r#""w \"1\"":0.30000000000000004,"b":1000000000000000"#),
        ] {
            assert_eq!(object(&keys, &cells(w, b)), format!("{{{text},{numbers}}}"));
        }
    }
}
