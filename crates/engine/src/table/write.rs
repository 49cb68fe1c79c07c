//! A table as text, row by row.

use super::{Cell, Table};
use crate::History;
use crate::csv::Dialect;
use std::fmt::{self, Write};
use units::number::shortest;

/// How a table is written. Numbers have the fewest digits that read back exactly; those that are not finite are empty in
/// CSV and null in JSON.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Format {
    /// RFC 4180, but with lines that end in `\n`; the first line is `t [s],y [m],y' [m/s]`.
    #[default]
    Csv,
    /// The same for a spreadsheet where the decimal sign is a comma: [`Dialect::Semicolons`].
    CsvSemicolons,
    /// An array of objects with the same headings as keys.
    Json,
    /// An object on each line.
    JsonLines,
}

impl Format {
    fn dialect(self) -> Option<Dialect> {
        match self {
            Self::Csv => Some(Dialect::Lines),
            Self::CsvSemicolons => Some(Dialect::Semicolons),
            Self::Json | Self::JsonLines => None,
        }
    }
}

impl Table {
    /// Writes what comes before the first row.
    ///
    /// # Errors
    /// Those of `out`.
    pub fn write_head(&self, format: Format, out: &mut impl Write) -> fmt::Result {
        let Some(dialect) = format.dialect() else {
            return if format == Format::Json { out.write_char('[') } else { Ok(()) };
        };
        out.write_str(dialect.start())?;
        for (index, column) in self.columns.iter().enumerate() {
            separate(index, dialect.separator(), out)?;
            dialect.text(out, &column.heading())?;
        }
        out.write_str(dialect.line_end())
    }

    /// Writes one row; `first` where no row was written before.
    ///
    /// # Errors
    /// Those of `out`.
    pub fn write_row(
        &mut self,
        format: Format,
        history: &History,
        row: usize,
        first: bool,
        out: &mut impl Write,
    ) -> fmt::Result {
        self.row(history, row);
        if let Some(dialect) = format.dialect() {
            for (index, cell) in self.cells.iter().enumerate() {
                separate(index, dialect.separator(), out)?;
                match cell {
                    Cell::Number(value) => dialect.number(out, *value)?,
                    Cell::Truth(value) => write!(out, "{value}")?,
                    Cell::Text(text) => dialect.text(out, text)?,
                }
            }
            return out.write_str(dialect.line_end());
        }
        if format == Format::Json {
            out.write_str(if first { "\n" } else { ",\n" })?;
        }
        out.write_char('{')?;
        for (index, (column, cell)) in self.columns.iter().zip(&self.cells).enumerate() {
            separate(index, ',', out)?;
            json_text(&column.heading(), out)?;
            out.write_char(':')?;
            match cell {
                Cell::Number(value) if value.is_finite() => out.write_str(&shortest(*value))?,
                Cell::Number(_) => out.write_str("null")?,
                Cell::Truth(value) => write!(out, "{value}")?,
                Cell::Text(text) => json_text(text, out)?,
            }
        }
        out.write_str(if format == Format::JsonLines { "}\n" } else { "}" })
    }

    /// Writes what comes after the last row.
    ///
    /// # Errors
    /// Those of `out`.
    pub fn write_end(&self, format: Format, out: &mut impl Write) -> fmt::Result {
        if format == Format::Json { out.write_str("\n]\n") } else { Ok(()) }
    }
}

fn separate(index: usize, separator: char, out: &mut impl Write) -> fmt::Result {
    if index > 0 { out.write_char(separator) } else { Ok(()) }
}

/// A text as a string of JSON (RFC 8259).
fn json_text(text: &str, out: &mut impl Write) -> fmt::Result {
    out.write_char('"')?;
    for character in text.chars() {
        match character {
            '"' => out.write_str("\\\"")?,
            '\\' => out.write_str("\\\\")?,
            '\n' => out.write_str("\\n")?,
            '\r' => out.write_str("\\r")?,
            '\t' => out.write_str("\\t")?,
            control if u32::from(control) < 0x20 => write!(out, "\\u{:04x}", u32::from(control))?,
            other => out.write_char(other)?,
        }
    }
    out.write_char('"')
}
