//! Common parts of the steps: buttons that select the effect of the next click, and folds.

use crate::app::App;
use crate::film::aim::Tool;
use view::browser;
use view::views::*;

/// Button that selects the effect of the next click on the film.
pub fn tool_button(app: App, id: &'static str, tool: Tool, name: &'static str) -> HtmlButton {
    let on = move || app.films.tool.get() == tool;
    let take = move |_| {
        let now = app.films.tool.get_untracked();
        take_tool(app, if now == tool { Tool::Rest } else { tool });
        browser::focus("film-frame");
    };
    button().class("chip").id(id).attr("aria-pressed", move || on().to_string()).when(events::click, take).child(name)
}

/// Fold with a summary.
pub fn fold(summary_words: &'static str) -> HtmlDetails {
    details().class("more-of-act").child(summary().child(summary_words))
}

/// Selects the effect of the next click, and shows the film.
pub fn take_tool(app: App, tool: Tool) {
    app.films.points.set(Vec::new());
    app.films.shown.set(true);
    app.films.tool.set(tool);
}
