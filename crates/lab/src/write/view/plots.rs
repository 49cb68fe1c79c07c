//! The plots.

use crate::app::App;
use view::views::*;

/// The plots of the document.
pub fn view(_app: App) -> HtmlDiv {
    div().class("plots-form")
}
