//! A table as CSV, row by row.

use super::{Cell, Table};
use crate::History;
use crate::record::csv::Dialect;
use std::fmt::{self, Write};

impl Table {
    /// Writes the headings: `t [s],y [m],y' [m/s]`.
    ///
    /// # Errors
    /// Errors of `out`.
    pub fn write_head(&self, dialect: Dialect, out: &mut impl Write) -> fmt::Result {
        out.write_str(dialect.start())?;
        for (index, column) in self.columns.iter().enumerate() {
            separate(index, dialect, out)?;
            dialect.text(out, &column.heading())?;
        }
        out.write_str(dialect.line_end())
    }

    /// Writes one row.
    ///
    /// # Errors
    /// Errors of `out`.
    pub fn write_row(&mut self, dialect: Dialect, history: &History, row: usize, out: &mut impl Write) -> fmt::Result {
        for (index, cell) in self.row(history, row).iter().enumerate() {
            separate(index, dialect, out)?;
            match cell {
                Cell::Number(value) => dialect.number(out, *value)?,
                Cell::Truth(value) => write!(out, "{value}")?,
                Cell::Text(text) => dialect.text(out, text)?,
            }
        }
        out.write_str(dialect.line_end())
    }
}

fn separate(index: usize, dialect: Dialect, out: &mut impl Write) -> fmt::Result {
    if index > 0 { out.write_char(dialect.separator()) } else { Ok(()) }
}
