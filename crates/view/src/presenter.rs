//! Presentation size: larger type and figures, for a projector.

use crate::app::App;
use crate::views::*;
use crate::{browser, icons};

/// Font sizes of the figures in CSS pixels: normal, and for a projector.
const FONT_SIZES: [f64; 2] = [13.0, 18.0];

/// Applies the choice of the last visit.
pub fn remembered(app: App) {
    apply(app, browser::remembered("size").is_some());
}

fn apply(app: App, large: bool) {
    if let Some(root) = document().document_element() {
        let _ = if large { root.set_attribute("data-size", "large") } else { root.remove_attribute("data-size") };
    }
    app.nodes(|nodes| {
        nodes.font_size = FONT_SIZES[usize::from(large)];
        for plot in nodes.plots.iter_mut().flatten() {
            plot.invalidate();
        }
    });
    app.wake();
}

/// Button that switches the presentation size on and off.
pub fn button_of(app: App) -> HtmlButton {
    let words = app.words();
    let large = create_signal(browser::remembered("size").is_some());
    let turn = move |_| {
        let now = !large.get_untracked();
        browser::remember("size", if now { "large" } else { "" });
        large.set(now);
        apply(app, now);
    };
    button()
        .class("icon")
        .id("presenter")
        .called(words.presenter)
        .attr("aria-pressed", move || large.get().to_string())
        .when(events::click, turn)
        .child(icons::type_size())
}
