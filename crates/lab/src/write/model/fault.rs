//! What was found in the statements of the model.

use crate::app::App;
use document::form::{CellKind, places};
use model::{Diagnostic, Severity};
use view::views::*;

/// A finding with its cell.
#[derive(Clone, Debug, PartialEq)]
pub struct Fault {
    /// The number of its statement in the form.
    pub part: usize,
    cell: CellKind,
    /// What was found.
    pub found: Diagnostic,
}

impl Fault {
    /// Whether it is in this cell.
    pub fn is_of(&self, number: usize, kind: CellKind) -> bool {
        self.part == number && (self.cell == kind || kind == CellKind::Text)
    }

    /// Whether it keeps the document from running.
    pub fn is_error(&self) -> bool {
        self.found.severity == Severity::Error
    }
}

/// The findings that lie in statements of the model, as the last check left them.
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

/// Which findings in a text are shown beside a statement.
pub fn beside(text: &str) -> impl Fn(&Diagnostic) -> bool {
    let form = places(&document::read(text));
    move |found| form.at(found.span().start).is_some()
}

/// The id of what is said of a statement.
pub fn id(number: usize) -> String {
    format!("faults-{number}")
}
