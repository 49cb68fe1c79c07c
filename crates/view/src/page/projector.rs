//! Projector's view: the stage alone, with larger type and figures.

use crate::app::App;
use crate::pieces::icons;
use crate::views::*;

/// Font sizes of the figures in CSS pixels: normal, and for a projector.
const FONT_SIZES: [f64; 2] = [13.0, 18.0];

/// Shows the page as `app.projecting` says, now and whenever it changes.
pub fn follow(app: App) {
    effect(move || {
        let on = app.projecting.get();
        if let Some(root) = document().document_element() {
            let _ = if on { root.set_attribute("data-view", "projector") } else { root.remove_attribute("data-view") };
        }
        app.nodes(|nodes| {
            nodes.font_size = FONT_SIZES[usize::from(on)];
            for plot in nodes.plots.iter_mut().flatten() {
                plot.invalidate();
            }
        });
        app.wake();
    });
}

/// Button that enters and leaves the projector's view.
pub fn button_of(app: App) -> HtmlButton {
    button()
        .class("icon")
        .id("projector")
        .called(app.words().projector)
        .attr("aria-pressed", move || app.projecting.get().to_string())
        .when(events::click, move |_| app.projecting.update(|on| *on = !*on))
        .child(icons::full_screen())
}
