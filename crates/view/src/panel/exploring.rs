//! Tab *Explore*: three parameters, a row of presets and three values; folded, all others, state and method, and the recorded run
//! as a table.

use crate::app::App;
use crate::views::*;
use crate::{controls, panel::data, panel::readouts, stage::tiles};
use play::PagePart;
use web_sys::HtmlDetailsElement;

/// Content of the tab.
pub fn view(app: App) -> HtmlDiv {
    let embedding = app.host().embedding();
    let [adjusts, reads] = [PagePart::Parameters, PagePart::Values].map(|part| !embedding.hides(part));
    div()
        .class("exploring")
        .maybe((embedding.locked && adjusts).then(|| note(app.words().locked)))
        .maybe(adjusts.then(|| controls::view(app)))
        .maybe(reads.then(|| readouts::main(app)))
        .child(more(app, adjusts, reads))
}

/// Further parameters and values, folded, and built when they are first unfolded: a long document has hundreds. The fold stays
/// open when the page is rebuilt in another language.
fn more(app: App, adjusts: bool, reads: bool) -> HtmlDetails {
    let mut details = details();
    let node: HtmlDetailsElement = details.node();
    let open = app.more_open;
    let mut is_needed = false;
    let is_needed = memo(move || {
        is_needed |= open.get();
        is_needed
    });
    let content = move || {
        View::from((
            adjusts.then(|| {
                View::from((controls::further(app), controls::lockable(app, controls::state_and_method(app).into())))
            }),
            tiles::more(app),
            reads.then(|| View::from((readouts::further(app), recorded(app)))),
        ))
    };
    details
        .class("more")
        .id("more")
        .open(open.get_untracked())
        .when(events::toggle, move |_| open.set(node.open()))
        .child(
            summary()
                .child(app.words().more)
                .maybe(holds(app, adjusts, reads).map(|held| span().class("note").child(held))),
        )
        .child(changing(move || if is_needed.get() { content() } else { View::new() }))
}

/// Number of parameters and values in the fold, in words; none if it has neither.
fn holds(app: App, adjusts: bool, reads: bool) -> Option<String> {
    let parameters = if adjusts { controls::further_count(app) } else { 0 };
    let values = if reads { readouts::further_count(app) } else { 0 };
    let language = app.language.get_untracked();
    (parameters + values > 0).then(|| play::words::further(language, parameters, values))
}

/// The recorded values. While folded, they are not updated.
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
