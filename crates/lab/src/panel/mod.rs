//! The panel beside the stage: what a person sets, answers, measures, fits and reads, one tab for each.

mod play;
pub mod reading;

use crate::app::App;
use crate::views::*;
use crate::{browser, fit, measurements};
use sycamore_reactive::untrack;
use web_sys::KeyboardEvent;

/// The tabs, in their order.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Tab {
    /// Parameters, presets and values.
    #[default]
    Play,
    /// The questions of the document.
    Activities,
    /// Records and cycles.
    Measure,
    /// Fits.
    Fit,
    /// Prose and equations.
    Theory,
}

impl Tab {
    const ALL: [Self; 5] = [Self::Play, Self::Activities, Self::Measure, Self::Fit, Self::Theory];

    /// The name in ids: `tab-play` belongs to `panel-play`.
    fn id(self) -> &'static str {
        match self {
            Self::Play => "play",
            Self::Activities => "activities",
            Self::Measure => "measure",
            Self::Fit => "fit",
            Self::Theory => "theory",
        }
    }

    fn title(self, app: App) -> &'static str {
        let words = app.words();
        match self {
            Self::Play => words.tab_play,
            Self::Activities => words.tab_activities,
            Self::Measure => words.tab_measure,
            Self::Fit => words.tab_fit,
            Self::Theory => words.tab_theory,
        }
    }

    fn content(self, app: App) -> View {
        match self {
            Self::Play => play::view(app).into(),
            Self::Activities => reading::activities(app).into(),
            Self::Measure => measurements::view(app).into(),
            Self::Fit => fit::view(app),
            Self::Theory => reading::theory(app).into(),
        }
    }
}

/// The panel. A document without questions has no activities.
pub fn view(app: App) -> HtmlSection {
    let words = app.words();
    let asks = reading::asks(app);
    let tabs: Vec<Tab> = Tab::ALL.into_iter().filter(|tab| asks || *tab != Tab::Activities).collect();
    if !tabs.contains(&app.tab.get_untracked()) {
        app.tab.set(Tab::Play);
    }
    let all = tabs.clone();
    let turn = move |event: KeyboardEvent| turn(app, &all, &event);
    let buttons = div().class("tabs").role("tablist").attr("aria-label", words.panel).when(events::keydown, turn);
    let buttons = buttons.each(&tabs, |tab| head(app, *tab));
    part("panel", "panel", words.panel)
        .child(buttons)
        .each(tabs, |tab| body(app, tab))
        .child(footer().child(p().child(words.footer)))
}

fn head(app: App, tab: Tab) -> HtmlButton {
    let selected = move || app.tab.get() == tab;
    button()
        .role("tab")
        .id(format!("tab-{}", tab.id()))
        .attr("aria-controls", format!("panel-{}", tab.id()))
        .attr("aria-selected", move || selected().to_string())
        .tabindex(move || if selected() { "0" } else { "-1" })
        .when(events::click, move |_| show(app, tab))
        .child(tab.title(app))
}

/// Built when it is first looked at.
fn body(app: App, tab: Tab) -> HtmlDiv {
    let selected = move || app.tab.get() == tab;
    let mut seen = false;
    let seen = memo(move || {
        seen = seen || selected();
        seen
    });
    let content = move || if seen.get() { untrack(|| tab.content(app)) } else { View::new() };
    div()
        .role("tabpanel")
        .id(format!("panel-{}", tab.id()))
        .attr("aria-labelledby", format!("tab-{}", tab.id()))
        .tabindex("0")
        .hidden(move || !selected())
        .child(changing(content))
}

/// Shows a tab from its top: another one may have been scrolled.
pub fn show(app: App, tab: Tab) {
    app.tab.set(tab);
    browser::scroll_back_to("panel");
}

/// Arrow keys go from tab to tab, around the ends.
fn turn(app: App, tabs: &[Tab], event: &KeyboardEvent) {
    let now = tabs.iter().position(|tab| *tab == app.tab.get_untracked()).unwrap_or(0);
    let next = match event.key().as_str() {
        "ArrowRight" => (now + 1) % tabs.len(),
        "ArrowLeft" => (now + tabs.len() - 1) % tabs.len(),
        "Home" => 0,
        "End" => tabs.len() - 1,
        _ => return,
    };
    event.prevent_default();
    if let Some(&tab) = tabs.get(next) {
        show(app, tab);
        browser::focus(&format!("tab-{}", tab.id()));
    }
}
