//! Diagnostics of the statements of the model.

use crate::app::App;
use document::form::{CellKind, places};
use model::{Diagnostic, Severity};
use view::views::*;

/// A diagnostic with its cell.
#[derive(Clone, Debug, PartialEq)]
pub struct Fault {
    /// Index of its statement in the form.
    pub part: usize,
    cell: CellKind,
    /// The diagnostic.
    pub found: Diagnostic,
}

impl Fault {
    /// True if it belongs to this cell.
    pub fn is_of(&self, number: usize, kind: CellKind) -> bool {
        self.part == number && (self.cell == kind || kind == CellKind::Text)
    }

    /// True if it prevents the document from running.
    pub fn is_error(&self) -> bool {
        self.found.severity == Severity::Error
    }
}

/// Diagnostics in statements of the model, from the last check.
pub fn of(app: App) -> ReadSignal<Vec<Fault>> {
    memo(move || {
        app.written.track();
        let (text, findings) = app.read_writing(|writing| {
            (writing.texts().first().cloned().unwrap_or_default(), writing.findings().to_vec())
        });
        if findings.is_empty() {
            return Vec::new();
        }
        let form = places(&document::read(&text));
        let fault = |(file, found): (usize, Diagnostic)| {
            let (part, cell) = form.at(found.span().start).filter(|_| file == 0)?;
            Some(Fault { part, cell, found })
        };
        findings.into_iter().filter_map(fault).collect()
    })
}

/// Returns a predicate: true for diagnostics that are shown beside a statement.
pub fn beside(text: &str) -> impl Fn(&Diagnostic) -> bool {
    let form = places(&document::read(text));
    move |found| form.at(found.span().start).is_some()
}

/// Id of the element with the diagnostics of a statement.
pub fn id(number: usize) -> String {
    format!("faults-{number}")
}
