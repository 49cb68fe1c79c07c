//! Export of the run and the records as one workbook, and of a record as a file.

use crate::fits::reporting::{dialect, export, stem};
use crate::records::record::Record;
use crate::{Desk, Export, ExportKind, RecordView, words};
use analysis::csv;
use analysis::spreadsheet::{Cell, Sheet, Workbook};

/// Workbook with the whole run on the first sheet and one sheet per record.
pub fn workbook(desk: &Desk) -> Vec<u8> {
    let head = desk.play().values().table_header().into_iter().map(Cell::Text).collect();
    let cell = |cell: engine::table::Cell| match cell {
        engine::table::Cell::Number(value) => Cell::Number(value),
        engine::table::Cell::Text(text) => Cell::Text(text.to_string()),
        engine::table::Cell::Truth(value) => Cell::Text(value.to_string()),
    };
    let cells = desk.play().values().table_cells().into_iter();
    let rows = std::iter::once(head).chain(cells.map(|row| row.into_iter().map(cell).collect())).collect();
    let run = Sheet { name: words::run(desk.play().basis().language()).to_owned(), rows, header: true };
    let record = |(view, record): (RecordView, &Record)| {
        let (heads, columns) = columns(&view, record);
        Sheet::of_film(record.name(), &heads, &columns, record.table().scale_error)
    };
    let records = desk.records().list().into_iter().zip(desk.records().records().all()).map(record);
    Workbook { sheets: std::iter::once(run).chain(records).collect() }.xlsx()
}

/// Exports a record: all columns with their units, including computed ones, and the relative error of a film's
/// scale. A workbook has a second sheet about the film. `None` if the record does not exist or `kind` is a report.
pub fn export_record(desk: &Desk, id: u32, kind: ExportKind) -> Option<Export> {
    let record = desk.records().records().get(id)?;
    let view = desk.records().list().into_iter().find(|view| view.id == id)?;
    let (heads, columns) = columns(&view, record);
    let scale_error = record.table().scale_error;
    let bytes = match kind {
        ExportKind::Report => return None,
        ExportKind::Csv => {
            csv::write_film(&heads, &columns, scale_error, dialect(desk.play().basis().style())).into_bytes()
        }
        ExportKind::Workbook => {
            let table = Sheet::of_film(stem(record.name()), &heads, &columns, scale_error);
            let film = film_sheet(desk, id);
            Workbook { sheets: std::iter::once(table).chain(film).collect() }.xlsx()
        }
    };
    Some(export(stem(record.name()), kind, bytes))
}

/// Sheet of facts about the film of a record; `None` if the record is not from a film.
fn film_sheet(desk: &Desk, record: u32) -> Option<Sheet> {
    let film = desk.films().described(record)?;
    let language = desk.play().basis().language();
    let times = language.say("Times count from the beginning of the film.");
    let mut rows = vec![vec![language.say("Film").into(), film.name.into()]];
    rows.extend(film.facts.into_iter().map(|(term, value)| vec![term.into(), value.into()]));
    rows.extend(film.notes.into_iter().map(|note| vec![Cell::Empty, note.into()]));
    rows.push(vec![Cell::Empty, times.into()]);
    Some(Sheet { name: language.say("Film").to_owned(), rows, header: false })
}

/// Names of the data that a link does not contain, in the chosen language.
pub fn missing_in_link(desk: &Desk) -> Vec<&'static str> {
    let language = desk.play().basis().language();
    let own = [
        (!desk.records().is_empty(), language.say("records")),
        (!desk.fits().saved().is_empty(), language.say("fits")),
    ];
    let own = own.into_iter().filter_map(|(missing, name)| missing.then_some(name));
    own.chain(play::missing_in_link(desk.play())).collect()
}

/// Headings and values of the columns of a record.
fn columns<'a>(view: &'a RecordView, record: &'a Record) -> (Vec<&'a str>, Vec<&'a [f64]>) {
    let heads = view.columns.iter().map(|column| column.head.as_str());
    (heads.collect(), record.table().columns.iter().map(|column| column.values.as_slice()).collect())
}
