//! What acts have in common: buttons that give the next click on the film a meaning, and folds.

use crate::app::App;
use crate::film::aim::Tool;
use view::browser;
use view::views::*;

/// A button that makes the next click on the film mean something.
pub fn tool_button(app: App, id: &'static str, tool: Tool, name: &'static str) -> HtmlButton {
    let on = move || app.films.tool.get() == tool;
    let take = move |_| {
        let now = app.films.tool.get_untracked();
        take_tool(app, if now == tool { Tool::Rest } else { tool });
        browser::focus("film-frame");
    };
    button().class("chip").id(id).attr("aria-pressed", move || on().to_string()).when(events::click, take).child(name)
}

/// A fold with its summary.
pub fn fold(summary_words: &'static str) -> HtmlDetails {
    details().class("more-of-act").child(summary().child(summary_words))
}

/// Chooses what the next click sets, and shows the film for it.
pub fn take_tool(app: App, tool: Tool) {
    app.films.points.set(Vec::new());
    app.films.shown.set(true);
    app.films.tool.set(tool);
}
