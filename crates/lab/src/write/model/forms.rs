//! What the views of the forms share.

use super::fault::Fault;
use crate::app::App;
use document::form::{CellKind, Form};
use view::views::*;

/// What the views of the forms share.
#[derive(Clone, Copy)]
pub struct Forms {
    /// The laboratory.
    pub app: App,
    /// The document as it stands in the editor.
    pub form: ReadSignal<Form>,
    /// What was found in it when it was checked last.
    pub faults: ReadSignal<Vec<Fault>>,
    /// Whether the text of a statement is being typed.
    pub typing: Signal<bool>,
}

/// Why the last change of a part was refused.
pub type Refusal = Signal<Option<(CellKind, String)>>;
