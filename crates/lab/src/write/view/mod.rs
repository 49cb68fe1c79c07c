//! What readers see of the document: its drawing and its plots.

mod drawing;
mod plots;

use crate::app::App;
use view::views::*;

/// The panel.
pub fn view(app: App) -> View {
    let words = app.words();
    let section = |id: &'static str, title: &'static str, content: HtmlDiv| {
        tags::section().class("form-section").attr("aria-labelledby", id).child(h3().id(id).child(title)).child(content)
    };
    div()
        .class("forms")
        .child(section("view-drawing", words.view_drawing, drawing::view(app)))
        .child(section("view-plots", words.view_plots, plots::view(app)))
        .into()
}
