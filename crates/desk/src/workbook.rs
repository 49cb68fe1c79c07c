//! The run and the records as one workbook.

use crate::records::record::Record;
use crate::{Desk, RecordView, words};
use analysis::spreadsheet::{Cell, Sheet, Workbook};

impl Desk {
    /// The whole run and the records as a workbook, each on a sheet of its own.
    pub fn workbook(&self) -> Vec<u8> {
        let head = self.play.table_header().into_iter().map(Cell::Text).collect();
        let cell = |cell: engine::table::Cell| match cell {
            engine::table::Cell::Number(value) => Cell::Number(value),
            engine::table::Cell::Text(text) => Cell::Text(text.to_string()),
            engine::table::Cell::Truth(value) => Cell::Text(value.to_string()),
        };
        let cells = self.play.table_cells().into_iter();
        let rows = std::iter::once(head).chain(cells.map(|row| row.into_iter().map(cell).collect())).collect();
        let run = Sheet { name: words::run(self.play.language()).to_owned(), rows, header: true };
        let record = |(view, record): (RecordView, &Record)| {
            let heads: Vec<&str> = view.columns.iter().map(|column| column.head.as_str()).collect();
            let columns: Vec<&[f64]> = record.table.columns.iter().map(|column| column.values.as_slice()).collect();
            Sheet::of_columns(&record.name, &heads, &columns)
        };
        let records = self.records().into_iter().zip(&self.data.records).map(record);
        Workbook { sheets: std::iter::once(run).chain(records).collect() }.xlsx()
    }

    /// What of the laboratory a link does not hold, in the chosen language.
    pub fn missing_in_link(&self) -> Vec<&'static str> {
        let pick = |english, spanish| self.play.language().pick(english, spanish);
        let own = [
            (!self.data.records.is_empty(), pick("records", "registros")),
            (!self.saved_fits().is_empty(), pick("fits", "ajustes")),
        ];
        let own = own.into_iter().filter_map(|(missing, name)| missing.then_some(name));
        own.chain(self.play.missing_in_link()).collect()
    }
}
