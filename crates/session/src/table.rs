//! The recorded run as a table.

use crate::symbol::symbol;
use crate::{Session, number, words};
use analysis::spreadsheet;
use engine::table::{Cell, Format, Table};
use std::ops::Range;

/// Significant digits in a cell.
const DIGITS: usize = 6;

impl Session {
    /// `t [s]`, `y [m]`, ...: the heads of the columns.
    pub fn table_header(&self) -> Vec<String> {
        let table = Table::new(self.model());
        let head = |column: &engine::table::Column| {
            let name = symbol(&column.name);
            match column.unit.text.as_str() {
                "" => name,
                unit => format!("{name} [{}]", number::unit_text(unit)),
            }
        };
        table.columns().iter().map(head).collect()
    }

    /// How many rows are recorded.
    pub fn table_length(&self) -> usize {
        self.course.rows()
    }

    /// Some rows, their cells in the session's language. What lies beyond the last row is left out.
    pub fn table_rows(&self, rows: Range<usize>) -> Vec<Vec<String>> {
        let Some(history) = self.course.history() else {
            return Vec::new();
        };
        let mut table = Table::new(self.model());
        let rows = rows.start..rows.end.min(self.course.rows());
        rows.map(|row| table.row(history, row).iter().map(|cell| self.cell_text(cell)).collect()).collect()
    }

    /// The last row at or before the time shown.
    pub fn table_row_now(&self) -> usize {
        self.course.rows_until_shown().saturating_sub(1)
    }

    /// The whole run as CSV, the same bytes as the command line writes for the same run.
    pub fn csv(&self) -> String {
        let mut out = String::new();
        let mut table = Table::new(self.model());
        // Writing to a string does not fail.
        let _ = table.write_head(Format::Csv, &mut out);
        if let Some(history) = self.course.history() {
            for row in 0..self.course.rows() {
                let _ = table.write_row(Format::Csv, history, row, row == 0, &mut out);
            }
        }
        let _ = table.write_end(Format::Csv, &mut out);
        out
    }

    /// The whole run and the records as a workbook, each on a sheet of its own.
    pub fn workbook(&self) -> Vec<u8> {
        let mut table = Table::new(self.model());
        let head = self.table_header().into_iter().map(spreadsheet::Cell::Text).collect();
        let mut rows: Vec<Vec<spreadsheet::Cell>> = vec![head];
        if let Some(history) = self.course.history() {
            let cell = |cell: &Cell| match cell {
                Cell::Number(value) => spreadsheet::Cell::Number(*value),
                other => spreadsheet::Cell::Text(self.cell_text(other)),
            };
            rows.extend((0..self.course.rows()).map(|row| table.row(history, row).iter().map(cell).collect()));
        }
        let run = spreadsheet::Sheet { name: words::run(self.language).to_owned(), rows, header: true };
        let record = |(view, record): (crate::RecordView, &crate::record::Record)| {
            let heads: Vec<&str> = view.columns.iter().map(|column| column.head.as_str()).collect();
            let columns: Vec<&[f64]> = record.table.columns.iter().map(|column| column.values.as_slice()).collect();
            spreadsheet::Sheet::of_columns(&record.name, &heads, &columns)
        };
        let records = self.records().into_iter().zip(&self.data.records).map(record);
        spreadsheet::Workbook { sheets: std::iter::once(run).chain(records).collect() }.xlsx()
    }

    fn cell_text(&self, cell: &Cell) -> String {
        match cell {
            Cell::Number(value) => number::plain(*value, DIGITS, self.style),
            Cell::Truth(value) => words::truth(self.language, *value).to_owned(),
            Cell::Text(text) => self.text(text).to_owned(),
        }
    }
}
