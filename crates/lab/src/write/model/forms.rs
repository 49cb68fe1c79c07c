//! Data shared by the views of the forms.

use super::fault::Fault;
use crate::app::App;
use document::form::{CellKind, Form};
use view::views::*;

/// Data shared by the views of the forms.
#[derive(Clone, Copy)]
pub struct Forms {
    /// Handle of the laboratory.
    pub app: App,
    /// The document in the editor, as a form.
    pub form: ReadSignal<Form>,
    /// Diagnostics of the last check.
    pub faults: ReadSignal<Vec<Fault>>,
    /// True while the text of a statement is being typed.
    pub typing: Signal<bool>,
}

/// Reason why the last change of a cell was refused, with the cell.
pub type Refusal = Signal<Option<(CellKind, String)>>;
