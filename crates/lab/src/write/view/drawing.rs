//! The drawing.

use crate::app::App;
use view::views::*;

/// The drawing, as its author changes it.
pub fn view(_app: App) -> HtmlDiv {
    div().class("drawing-form")
}
