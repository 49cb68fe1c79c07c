//! The row of tabs inside *Write*: one document, shown as text, as forms of its model, as its questions, beside its translation.

use crate::app::App;
use view::browser;
use view::views::*;
use web_sys::KeyboardEvent;

/// In which form the document is written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Panel {
    /// Its text.
    #[default]
    Text,
    /// Forms of its model.
    Model,
    /// Its questions with their answers.
    Questions,
    /// Its texts beside those of a translation.
    Translation,
}

impl Panel {
    /// All of them in the order of the tabs.
    pub const ALL: [Self; 4] = [Self::Text, Self::Model, Self::Questions, Self::Translation];

    /// The name in ids.
    fn id(self) -> &'static str {
        match self {
            Self::Text => "text",
            Self::Model => "model",
            Self::Questions => "questions",
            Self::Translation => "translation",
        }
    }

    fn title(self, app: App) -> &'static str {
        let words = app.words();
        match self {
            Self::Text => words.panel_text,
            Self::Model => words.panel_model,
            Self::Questions => words.panel_questions,
            Self::Translation => words.panel_translation,
        }
    }
}

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
            .child(panel.title(app))
    };
    let turn = move |event: KeyboardEvent| turn(app, &event);
    div()
        .class("writing-tabs")
        .role("tablist")
        .attr("aria-label", app.words().writing_panels)
        .when(events::keydown, turn)
        .each(Panel::ALL, tab)
}

/// The place of what a tab shows.
pub fn body(app: App, panel: Panel) -> HtmlDiv {
    div()
        .class("writing-panel")
        .role("tabpanel")
        .id(format!("writing-{}", panel.id()))
        .attr("aria-labelledby", format!("writing-tab-{}", panel.id()))
        .hidden(move || app.writing_panel.get() != panel)
}

/// Shows the document in another form; what was typed last is checked before.
pub fn show(app: App, panel: Panel) {
    super::flush(app);
    app.writing_panel.set(panel);
    if panel == Panel::Text
        && let Some(editor) = app.with(|lab| lab.editor.clone()).flatten()
    {
        editor.measure();
    }
}

/// Arrow keys go from tab to tab, around the ends.
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
