//! Forms of the views of a document: its drawing, its plots, and the order of controls and values.
//!
//! `drawing` shows the scene a second time (`canvas.rs`): `desk` says where elements and grips stand in it, `seen.rs` where
//! that is on the screen (`matrix.rs`), `pointing.rs` and `keys.rs` make ways of it, and `acts.rs` changes of the text.

mod drawing;
mod forms;
mod new_plot;
mod plot;
mod plots;
mod shown;

use super::typing;
use crate::app::App;
use view::views::*;

/// Panel with these forms.
pub fn view(app: App) -> View {
    let words = app.words();
    let section = |id: &'static str, title: &'static str, content: HtmlDiv| {
        div()
            .class("form-section")
            .role("group")
            .attr("aria-labelledby", id)
            .child(h3().id(id).child(title))
            .child(content)
    };
    let forms = div()
        .class("forms")
        .child(section("view-drawing", words.view_drawing, drawing::view(app)))
        .child(section("view-plots", words.view_plots, plots::view(app)))
        .child(section("view-controls", words.view_controls, shown::controls(app)))
        .child(section("view-values", words.view_values, shown::values(app)));
    View::from((typing::undo_buttons(app), forms))
}
