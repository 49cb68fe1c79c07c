//! The panel beside the stage, with tabs to explore, for questions, for theory, and for further content of the page.

mod choice;
mod claims;
mod data;
mod exploring;
pub mod question;
pub mod reading;
pub(crate) mod readouts;
mod survey;
pub mod tabs;
pub mod worksheet;

use crate::app::App;
use crate::browser;
use crate::page::class;
use crate::panel::tabs::{EXPLORE, MEASURE, QUESTIONS, THEORY};
use crate::views::*;
use play::PagePart;
use sycamore_reactive::untrack;
use web_sys::KeyboardEvent;

/// A tab of the panel.
#[derive(Clone)]
pub struct Tab {
    /// Name in ids: `tab-explore` belongs to `panel-explore`.
    pub id: &'static str,
    /// Title.
    pub title: &'static str,
    /// Builds the content: when the tab is first opened, and again for another program.
    pub content: std::rc::Rc<dyn Fn() -> View>,
    /// True if the tab has content for the present program.
    offered: fn(App) -> bool,
    /// True if the content stays when the program is replaced.
    lasting: bool,
    /// True if the content is not there yet.
    waits: bool,
}

impl Tab {
    /// A tab that is offered only if there is a simulation.
    pub fn new(id: &'static str, title: &'static str, content: impl Fn() -> View + 'static) -> Self {
        Self { id, title, content: std::rc::Rc::new(content), offered: runs, lasting: false, waits: false }
    }

    /// A tab for teachers and authors, whose content follows program changes itself. Without a simulation it is always
    /// offered.
    pub fn lasting(id: &'static str, title: &'static str, content: impl Fn() -> View + 'static) -> Self {
        Self { lasting: true, offered: |app| app.everything.get() || !runs(app), ..Self::new(id, title, content) }
    }

    /// Tab of parameters, presets and values.
    pub fn explore(app: App) -> Self {
        Self::new(EXPLORE, app.words().tab_explore, move || exploring::view(app).into())
    }

    /// Tab of questions and survey; not offered if the document contains neither questions nor a survey.
    pub fn questions(app: App) -> Self {
        let content = move || reading::questions(app).into();
        Self { offered: reading::asks, ..Self::new(QUESTIONS, app.words().tab_questions, content) }
    }

    /// Tab of prose and equations; with everything shown, also of the claims of the author and of additional content (`besides`).
    pub fn theory(app: App, besides: impl Fn() -> View + Clone + 'static) -> Self {
        let content = move || {
            let besides = besides.clone();
            reading::theory(app, Box::new(move || View::from((claims::view(app), besides())))).into()
        };
        Self::new(THEORY, app.words().tab_theory, content)
    }

    /// The tab while its content is not there yet. Opening it asks for the content (`ask`).
    #[must_use]
    pub fn waiting(self, app: App, ask: impl Fn() + 'static) -> Self {
        let content = move || {
            ask();
            p().class("note").child(app.words().tab_waits).into()
        };
        Self { content: std::rc::Rc::new(content), waits: true, ..self }
    }

    fn is_offered(&self, app: App) -> bool {
        (self.offered)(app)
    }

    /// True if the address of the page leaves out everything in this tab.
    fn is_left_out(&self, app: App) -> bool {
        let parts: &[PagePart] = match self.id {
            EXPLORE => &[PagePart::Parameters, PagePart::Values],
            QUESTIONS => &[PagePart::Activities],
            MEASURE => &[PagePart::Measure],
            THEORY => &[PagePart::Text],
            _ => return false,
        };
        let embedding = app.host().embedding();
        parts.iter().all(|part| embedding.hides(*part))
    }
}

/// True if there is a simulation.
fn runs(app: App) -> bool {
    app.read(|_| true)
}

/// The tabs that the address of the page does not leave out.
pub fn shown(app: App, mut tabs: Vec<Tab>) -> Vec<Tab> {
    tabs.retain(|tab| !tab.is_left_out(app));
    tabs
}

/// The panel.
pub fn view(app: App, tabs: Vec<Tab>) -> HtmlSection {
    let words = app.words();
    let all = tabs.clone();
    effect(move || {
        app.changes.program.track();
        app.everything.track();
        let mut offered = all.iter().filter(|tab| tab.is_offered(app)).map(|tab| tab.id).peekable();
        let first = offered.peek().copied().unwrap_or(EXPLORE);
        if !offered.any(|id| id == app.tab.get_untracked()) {
            app.tab.set(first);
        }
    });
    let all = tabs.clone();
    let turn = move |event: KeyboardEvent| {
        let offered: Vec<&'static str> = all.iter().filter(|tab| tab.is_offered(app)).map(|tab| tab.id).collect();
        turn(app, &offered, &event);
    };
    let buttons = div().class("tabs").role("tablist").attr("aria-label", words.panel).when(events::keydown, turn);
    let buttons = buttons.each(&tabs, |tab| head(app, tab));
    part("panel", "panel", words.panel)
        .child(buttons)
        .each(tabs, |tab| body(app, tab))
        .child(footer().child(p().child(if class::is_here() { words.footer_of_class } else { words.footer })))
}

fn head(app: App, tab: &Tab) -> HtmlButton {
    let (id, offered, waits) = (tab.id, tab.offered, tab.waits);
    let selected = move || app.tab.get() == id;
    let hidden = move || {
        app.changes.program.track();
        !offered(app)
    };
    button()
        .role("tab")
        .id(format!("tab-{id}"))
        .attr("aria-controls", format!("panel-{id}"))
        .attr("aria-selected", move || selected().to_string())
        .attr("aria-busy", waits.then_some("true"))
        .tabindex(move || if selected() { "0" } else { "-1" })
        .hidden(hidden)
        .when(events::click, move |_| show(app, id))
        .child(tab.title)
}

/// Content of a tab. Built when it is first opened, and when it is first opened with another program.
fn body(app: App, tab: Tab) -> HtmlDiv {
    let Tab { id, content, lasting, waits, .. } = tab;
    let selected = move || app.tab.get() == id;
    let mut seen = None;
    // Program counter for which the content was built.
    let seen = memo(move || {
        let program = if lasting { 0 } else { app.changes.program.get() };
        seen = if selected() { Some(program) } else { seen.filter(|seen| *seen == program) };
        seen
    });
    let built = move || if seen.get().is_some() { untrack(|| content()) } else { View::new() };
    div()
        .role("tabpanel")
        .id(format!("panel-{id}"))
        .attr("aria-labelledby", format!("tab-{id}"))
        .attr("aria-busy", waits.then_some("true"))
        // A panel that begins with controls needs no stop of its own.
        .tabindex(if id == EXPLORE { "-1" } else { "0" })
        .hidden(move || !selected())
        .child(changing(built))
}

/// Opens a tab and scrolls to its top, since the previous one may have been scrolled.
pub fn show(app: App, tab: &'static str) {
    app.tab.set(tab);
    browser::bring_into_sight("panel");
}

/// Arrow keys switch between tabs, cyclically.
fn turn(app: App, tabs: &[&'static str], event: &KeyboardEvent) {
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
        browser::focus(&format!("tab-{tab}"));
    }
}
