//! The rows of a run as a table: in display units, for people and for files. The page and the command line write the
//! same characters.

use crate::{History, Readings};
use model::Model;
use std::fmt;

/// Which columns of a run, and their values at its rows.
#[derive(Clone, Debug)]
pub struct Table {
    columns: Vec<Column>,
    readings: Readings,
    row: Vec<Cell>,
}

/// One column of a [`Table`].
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    /// The name, with primes: `y'`.
    pub name: String,
    /// The author's label, if any.
    pub label: Option<String>,
    /// The display unit; its text is empty for a pure number.
    pub unit: units::Unit,
}

/// A value of a [`Table`] in its column's unit.
#[derive(Clone, Debug, PartialEq)]
pub enum Cell {
    /// A number, perhaps not finite.
    Number(f64),
    /// Whether a condition holds.
    Truth(bool),
    /// A text of the document.
    Text(std::rc::Rc<str>),
}

/// A column that does not exist.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnknownColumn {
    /// What was asked for.
    pub name: String,
    /// The name that is nearest to it, if one is near.
    pub near: Option<String>,
}

/// How a table is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Format {
    /// RFC 4180 with `\n`; one header row `t [s],y [m],y' [m/s]`.
    #[default]
    Csv,
    /// One array of objects.
    Json,
    /// An object on each line.
    JsonLines,
}

impl Table {
    /// All columns: the independent variable, the states, the quantities that vary.
    pub fn new(model: &Model) -> Self {
        Self {
            columns: Vec::new(),
            readings: Readings::new(model, &[]),
            row: Vec::new(),
        }
    }

    /// The named columns (also constants: parameters and quantities that do not vary), in the order asked for.
    ///
    /// # Errors
    /// A name that does not exist.
    pub fn select(model: &Model, names: &[&str]) -> Result<Self, UnknownColumn> {
        let _ = names;
        Ok(Self::new(model))
    }

    /// The columns.
    pub fn columns(&self) -> &[Column] {
        &self.columns
    }

    /// The values at a recorded row.
    pub fn row(&mut self, history: &History, row: usize) -> &[Cell] {
        let _ = self.readings.at_row(history, row);
        &self.row
    }

    /// What comes before the first row.
    ///
    /// # Errors
    /// Those of `out`.
    pub fn write_head(&self, format: Format, out: &mut impl fmt::Write) -> fmt::Result {
        let _ = format;
        out.write_str("")
    }

    /// One row; `first` where no row was written before.
    ///
    /// # Errors
    /// Those of `out`.
    pub fn write_row(
        &mut self,
        format: Format,
        history: &History,
        row: usize,
        first: bool,
        out: &mut impl fmt::Write,
    ) -> fmt::Result {
        let _ = (format, history, row, first);
        out.write_str("")
    }

    /// What comes after the last row.
    ///
    /// # Errors
    /// Those of `out`.
    pub fn write_end(&self, format: Format, out: &mut impl fmt::Write) -> fmt::Result {
        let _ = format;
        out.write_str("")
    }
}
