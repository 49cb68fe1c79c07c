//! Tables in replies.

use crate::diagnostic::Diagnostic;
use crate::fault::Fault;
use crate::reply::{Buffer, Reply};
use runner::ColumnValues;
use serde::Serialize;

/// A column as Python has it: name, unit, label, kind of values, and the values if they are texts.
#[derive(Serialize)]
struct Column(String, String, String, &'static str, Option<Vec<Option<Box<str>>>>);

/// Columns of a table.
#[derive(Serialize)]
#[serde(transparent)]
pub struct Columns(Vec<Column>);

impl Columns {
    /// Takes a table apart. Numbers and truths are added to the buffers.
    pub fn new(table: runner::Table, buffers: &mut Vec<Buffer>) -> Self {
        let columns = table.columns.into_iter().map(|column| {
            let (kind, texts) = match column.values {
                ColumnValues::Numbers(numbers) => {
                    buffers.push(Buffer::Numbers(numbers));
                    ("numbers", None)
                }
                ColumnValues::Truths(truths) => {
                    buffers.push(Buffer::Truths(truths.into_iter().map(u8::from).collect()));
                    ("truths", None)
                }
                ColumnValues::Texts(texts) => ("texts", Some(texts)),
            };
            let head = column.head;
            Column(head.name, head.unit.text, head.label.unwrap_or_default(), kind, texts)
        });
        Self(columns.collect())
    }
}

/// A table with what there is to say about it.
#[derive(Serialize)]
struct Answer {
    columns: Columns,
    notices: Vec<Diagnostic>,
    ended: Option<String>,
}

/// Reply with a table. `ended`: message of the event that ended the run before its time.
pub fn reply(table: runner::Table, notices: Vec<Diagnostic>, ended: Option<String>) -> Result<Reply, Fault> {
    let mut buffers = Vec::new();
    let columns = Columns::new(table, &mut buffers);
    Ok(Reply::with_buffers(&Answer { columns, notices, ended }, buffers)?)
}
