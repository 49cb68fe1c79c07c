//! Data shared by the views of the plots.

use crate::app::App;
use document::form::PlotPart;
use model::Diagnostic;
use view::views::*;

/// Data shared by the views of the plots.
#[derive(Clone, Copy)]
pub struct Plots {
    /// Handle of the laboratory.
    pub app: App,
    /// Plots of the document in the editor.
    pub all: ReadSignal<Vec<PlotPart>>,
    /// Diagnostics of the last check: (plot index, diagnostic).
    pub faults: ReadSignal<Vec<(usize, Diagnostic)>>,
    /// True while the text of a whole plot is being typed.
    pub typing: Signal<bool>,
}
