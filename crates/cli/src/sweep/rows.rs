//! The rows of a sweep as CSV, or as a file of Arrow's format.

use crate::failure::Failure;
use crate::terminal::output::Output;
use arrow_array::{ArrayRef, BooleanArray, Float64Array, RecordBatch, StringArray};
use arrow_ipc::writer::FileWriter;
use arrow_schema::{ArrowError, DataType, Field, Schema};
use engine::csv::Dialect;
use runner::{ColumnValues, Table, TableColumn};
use std::collections::HashMap;
use std::io::{Error, Write};
use std::path::Path;
use std::sync::Arc;

/// Writer of the tables of a sweep, one after the other.
pub enum Rows {
    /// Text with a line of headings.
    Csv(Output),
    /// Record batches with units in the metadata of the columns.
    Arrow(Box<FileWriter<Output>>),
}

impl Rows {
    /// Begins with the headings of `table`, whose rows are not written. The file name decides the format: `.arrow`,
    /// otherwise CSV.
    ///
    /// # Errors
    /// Errors of writing.
    pub fn begin(mut output: Output, path: Option<&Path>, table: &Table) -> Result<Self, Failure> {
        if path.and_then(Path::extension).is_some_and(|ending| ending.eq_ignore_ascii_case("arrow")) {
            let writer = FileWriter::try_new(output, &schema(table));
            return writer.map(|writer| Self::Arrow(Box::new(writer))).map_err(|error| not_written(path, &error));
        }
        let mut text = String::new();
        for (place, column) in table.columns.iter().enumerate() {
            text.push_str(if place > 0 { "," } else { "" });
            // Writing to a string cannot fail.
            let _ = Dialect::Lines.text(&mut text, &column.head.heading());
        }
        text.push('\n');
        output.write_all(text.as_bytes()).map_err(|error| output.failure(&error))?;
        Ok(Self::Csv(output))
    }

    /// Writes the rows of a table with the same columns.
    ///
    /// # Errors
    /// Errors of writing.
    pub fn write(&mut self, table: &Table, path: Option<&Path>) -> Result<(), Failure> {
        match self {
            Self::Csv(output) => output.write_all(text(table).as_bytes()).map_err(|error| output.failure(&error)),
            Self::Arrow(writer) => {
                let columns = table.columns.iter().map(array).collect();
                let batch = RecordBatch::try_new(Arc::new(schema(table)), columns);
                batch.and_then(|batch| writer.write(&batch)).map_err(|error| not_written(path, &error))
            }
        }
    }

    /// Gives the file its name.
    ///
    /// # Errors
    /// Errors of writing.
    pub fn finish(self, path: Option<&Path>) -> Result<(), Failure> {
        match self {
            Self::Csv(output) => output.finish(),
            Self::Arrow(writer) => writer.into_inner().map_err(|error| not_written(path, &error))?.finish(),
        }
    }
}

fn not_written(path: Option<&Path>, error: &ArrowError) -> Failure {
    Failure::file("write", path.unwrap_or(Path::new("-")), &Error::other(error.to_string()))
}

/// Rows as lines.
fn text(table: &Table) -> String {
    let mut text = String::new();
    for row in 0..table.rows() {
        for (place, column) in table.columns.iter().enumerate() {
            text.push_str(if place > 0 { "," } else { "" });
            // Writing to a string cannot fail.
            let _ = match &column.values {
                ColumnValues::Numbers(values) => Dialect::Lines.number(&mut text, values[row]),
                ColumnValues::Truths(values) => Dialect::Lines.text(&mut text, &values[row].to_string()),
                ColumnValues::Texts(values) => {
                    Dialect::Lines.text(&mut text, values[row].as_deref().unwrap_or_default())
                }
            };
        }
        text.push('\n');
    }
    text
}

/// Names of the columns, with their units.
fn schema(table: &Table) -> Schema {
    let field = |column: &TableColumn| {
        let unit = &column.head.unit.text;
        let metadata = (!unit.is_empty()).then(|| ("unit".to_owned(), unit.clone()));
        let kind = match &column.values {
            ColumnValues::Numbers(_) => DataType::Float64,
            ColumnValues::Truths(_) => DataType::Boolean,
            ColumnValues::Texts(_) => DataType::Utf8,
        };
        Field::new(&column.head.name, kind, true).with_metadata(metadata.into_iter().collect::<HashMap<_, _>>())
    };
    Schema::new(table.columns.iter().map(field).collect::<Vec<_>>())
}

/// Values of a column, null where there is none.
fn array(column: &TableColumn) -> ArrayRef {
    match &column.values {
        ColumnValues::Numbers(values) => {
            Arc::new(values.iter().map(|value| Some(*value).filter(|value| !value.is_nan())).collect::<Float64Array>())
        }
        ColumnValues::Truths(values) => Arc::new(BooleanArray::from(values.clone())),
        ColumnValues::Texts(values) => Arc::new(values.iter().map(Option::as_deref).collect::<StringArray>()),
    }
}
