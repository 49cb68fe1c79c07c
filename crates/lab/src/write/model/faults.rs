//! What is wrong with a statement, beside it.

use super::cell::{Forms, Refusal};
use crate::app::App;
use crate::diagnostics::{self, CarryOut};
use crate::write::typing;
use document::form::{CellKind, read};
use model::{Diagnostic, Severity};
use std::rc::Rc;
use view::views::*;

/// A finding with its cell.
#[derive(Clone, Debug, PartialEq)]
pub struct Fault {
    part: usize,
    cell: CellKind,
    found: Diagnostic,
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
        let form = read(&document::read(&text));
        let fault = |(file, found): (usize, Diagnostic)| {
            let (part, cell) = form.at(found.span().start).filter(|_| file == 0)?;
            Some(Fault { part, cell, found })
        };
        findings.into_iter().filter_map(fault).collect()
    })
}

/// Whether a finding is shown beside a statement.
pub fn is_beside(text: &str, found: &Diagnostic) -> bool {
    read(&document::read(text)).at(found.span().start).is_some()
}

/// The id of what is said of a statement.
pub fn id(number: usize) -> String {
    format!("faults-{number}")
}

/// What is wrong with a statement, with its remedies, and why its last change was refused.
pub fn view(forms: Forms, number: usize, refusal: Refusal) -> HtmlDiv {
    let own = memo(move || {
        forms.faults.with(|faults| faults.iter().filter(|fault| fault.part == number).cloned().collect::<Vec<_>>())
    });
    let carry_out: CarryOut = Rc::new(move |_, fix| {
        let app = forms.app;
        let checked = app.read_writing(|writing| writing.texts().first().cloned().unwrap_or_default());
        // A text that has changed since is checked first.
        if checked == typing::text(app, 0) {
            let _ = typing::change(app, 0, &checked, |_| Ok(fix.edits.clone()));
        }
        crate::write::flush(app);
    });
    let list = move || {
        let text = forms.app.read_writing(|writing| writing.texts().first().cloned().unwrap_or_default());
        each(own.get_clone(), |fault| diagnostics::brief(forms.app, &text, &fault.found, carry_out.clone()))
    };
    let refused =
        move || refusal.with(|refusal| refusal.as_ref().map(|(_, why)| format!("{why}.")).unwrap_or_default());
    div()
        .class("faults")
        .id(id(number))
        .child(changing(list))
        .child(p().class("refusal").role("alert").child(text(refused)))
}

/// Whether there is anything to say of a statement.
pub fn any(forms: Forms, number: usize, refusal: Refusal) -> ReadSignal<bool> {
    memo(move || {
        refusal.with(Option::is_some) || forms.faults.with(|faults| faults.iter().any(|fault| fault.part == number))
    })
}
