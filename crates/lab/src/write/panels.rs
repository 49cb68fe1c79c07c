//! Tabs inside *Write*: the document as text, as forms of its model and its views, as questions, and beside its
//! translation.

use super::panel::Panel;
use crate::app::App;
use view::browser;
use view::views::*;
use web_sys::KeyboardEvent;

/// The tabs.
pub fn tabs(app: App) -> HtmlDiv {
    let tab = |panel: Panel| {
        let selected = move || app.writing_panel.get() == panel;
        button()
            .role("tab")
            .id(format!("writing-tab-{}", panel.id()))
            .attr("aria-controls", format!("writing-{}", panel.id()))
            .attr("aria-selected", move || selected().to_string())
            .tabindex(move || if selected() { "0" } else { "-1" })
            .when(events::click, move |_| show(app, panel))
            .child(title(app, panel))
    };
    let turn = move |event: KeyboardEvent| turn(app, &event);
    div()
        .class("writing-tabs")
        .role("tablist")
        .attr("aria-label", app.words().writing_panels)
        .when(events::keydown, turn)
        .each(Panel::ALL, tab)
}

/// Container of the content of a tab.
pub fn body(app: App, panel: Panel) -> HtmlDiv {
    div()
        .class("writing-panel")
        .role("tabpanel")
        .id(format!("writing-{}", panel.id()))
        .attr("aria-labelledby", format!("writing-tab-{}", panel.id()))
        .hidden(move || app.writing_panel.get() != panel)
}

/// Link back to the tab, after a long form.
pub fn way_back(app: App, panel: Panel) -> HtmlButton {
    let back = move |_| browser::focus(&format!("writing-tab-{}", panel.id()));
    button().class("quiet way-back").when(events::click, back).child(app.words().writing_way_back)
}

/// Opens a tab, after checking the text typed last.
pub fn show(app: App, panel: Panel) {
    super::flush(app);
    app.writing_panel.set(panel);
    if panel == Panel::Text
        && let Some(editor) = app.with(|lab| lab.editor.clone()).flatten()
    {
        editor.measure();
    }
}

/// Arrow keys switch between tabs, cyclically.
fn turn(app: App, event: &KeyboardEvent) {
    let count = Panel::ALL.len();
    let now = Panel::ALL.iter().position(|panel| *panel == app.writing_panel.get_untracked()).unwrap_or(0);
    let next = match event.key().as_str() {
        "ArrowRight" => (now + 1) % count,
        "ArrowLeft" => (now + count - 1) % count,
        "Home" => 0,
        "End" => count - 1,
        _ => return,
    };
    event.prevent_default();
    if let Some(&panel) = Panel::ALL.get(next) {
        show(app, panel);
        browser::focus(&format!("writing-tab-{}", panel.id()));
    }
}

/// Title of a tab.
fn title(app: App, panel: Panel) -> &'static str {
    let words = app.words();
    match panel {
        Panel::Text => words.panel_text,
        Panel::Model => words.panel_model,
        Panel::View => words.panel_view,
        Panel::Questions => words.panel_questions,
        Panel::Translation => words.panel_translation,
    }
}
