//! What the views of the plots share.

use crate::app::App;
use document::form::PlotPart;
use model::Diagnostic;
use view::views::*;

/// What the views of the plots share.
#[derive(Clone, Copy)]
pub struct Plots {
    /// The laboratory.
    pub app: App,
    /// The plots as they stand in the editor.
    pub all: ReadSignal<Vec<PlotPart>>,
    /// What was found in them when the document was checked last, each with the number of its plot.
    pub faults: ReadSignal<Vec<(usize, Diagnostic)>>,
    /// Whether the text of a whole plot is being typed.
    pub typing: Signal<bool>,
}
