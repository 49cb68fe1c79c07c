//! What a person plays with: parameters and presets, the values, state and method, the recorded run as a table.

use crate::app::App;
use crate::views::*;
use crate::{controls, data, readouts};
use web_sys::HtmlDetailsElement;

/// The tab.
pub fn view(app: App) -> HtmlDiv {
    div()
        .class("playing")
        .child(controls::view(app))
        .child(readouts::view(app))
        .child(controls::state_and_method(app))
        .child(recorded(app))
}

/// The recorded values. While they are folded they cost nothing.
fn recorded(app: App) -> HtmlDetails {
    let words = app.words();
    let mut details = details();
    let node: HtmlDetailsElement = details.node();
    let open = app.table_open;
    details
        .class("card fold")
        .id("recorded")
        .open(open.get_untracked())
        .when(events::toggle, move |_| open.set(node.open()))
        .child(summary().child(h3().child(words.table)))
        .child(data::view(app))
}
