//! Texts with a table in another form than delimited rows: JSON, HTML and LaTeX, annotated CSV of InfluxDB, labelled
//! numbers. Each is rewritten as rows with tabs.

mod influx;
mod json;
mod labelled;
mod markup;

pub use markup::Markup;
pub(super) use markup::is_html;

use super::device::Remark;
use super::refusal::Refusal;
use crate::finding::Finding;

/// Rows of a text in another form.
#[derive(Debug)]
pub(super) struct Form {
    /// Rows with tabs between the cells.
    pub rows: String,
    /// True if the numbers have a decimal point and no other sign; else they are written as in the text.
    pub is_plain: bool,
    /// Note on the form for the user.
    pub finding: Finding,
}

/// Rewrites a text in one of the forms; `None` for any other text.
///
/// # Errors
/// JSON or markup without a table.
pub(super) fn read(text: &str) -> Option<Result<Form, Refusal>> {
    if let Some(json) = json::read(text) {
        let form =
            |table: json::JsonTable| Form { rows: table.cells, is_plain: true, finding: Finding::Json(table.left_out) };
        return Some(json.map(form));
    }
    if let Some(table) = markup::read(text) {
        let finding = Finding::Markup { markup: table.markup, others: table.others };
        let form = Form { rows: table.cells, is_plain: false, finding };
        return Some(if form.rows.is_empty() { Err(Refusal::Markup) } else { Ok(form) });
    }
    if let Some(rows) = influx::read(text) {
        let finding = Finding::Device(Remark::Recognised { name: "InfluxDB" });
        return Some(Ok(Form { rows, is_plain: true, finding }));
    }
    let table = labelled::read(text)?;
    let finding = Finding::Labelled { left_out: table.left_out };
    Some(Ok(Form { rows: table.rows, is_plain: false, finding }))
}
