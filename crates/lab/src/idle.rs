//! Content of the stage if nothing can run: no document is open, or its model has errors.

use crate::app::App;
use crate::{documents::opening, library::list as library_list};
use view::views::*;

/// Replaces scene, plots and transport. It is also the target of the skip link.
pub fn stage(app: App) -> HtmlSection {
    let words = app.words();
    let is_empty = app.with(|lab| lab.sources.is_empty()) == Some(true);
    let (title, intro) = match is_empty {
        true => (words.nothing, words.nothing_intro),
        false => (words.nothing_runs, words.nothing_runs_intro),
    };
    section()
        .class("stage idle")
        .id("apparatus")
        .tabindex("-1")
        .attr("aria-labelledby", "idle-title")
        .child(h2().id("idle-title").child(title))
        .child(p().child(intro))
        .child(ways_on(app))
}

/// Buttons to the previous document and to the list of documents.
fn ways_on(app: App) -> HtmlDiv {
    let words = app.words();
    let before = app.with(|lab| lab.sources_before.clone()).unwrap_or_default();
    let back = (!before.is_empty()).then(|| {
        button()
            .class("quiet outlined")
            .id("previous-document")
            .when(events::click, move |_| opening::open_sources(app, before.clone()))
            .child(words.previous_document)
    });
    let browse = button()
        .class("quiet outlined")
        .attr("aria-haspopup", "dialog")
        .when(events::click, move |_| library_list::choose(app))
        .child(words.other_documents);
    div().class("actions").maybe(back).child(browse)
}
