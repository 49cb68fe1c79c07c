//! Turns *Everything* on when something is opened that needs a hidden part of the page, and shows the tab *Measure* for records and
//! films where the address hides it.

use crate::app::App;
use play::PagePart;
use view::browser;
use view::page::message::Message;
use view::panel::tabs::{CLASS, MEASURE, WRITE};
use view::views::*;

/// Watches the open tab and the document: a document with errors is corrected in the tab *Write*.
pub fn follow(app: App) {
    effect(move || {
        app.changes.program.track();
        app.changes.document.track();
        let is_hidden = [WRITE, CLASS].contains(&app.tab.get());
        if is_hidden || app.with(|lab| lab.desk.is_none() && !lab.sources.is_empty()) == Some(true) {
            turn_on(app, app.words().everything_for_write);
        }
        if app.tab.get() == MEASURE && app.bring_back(PagePart::Measure) {
            wasm_bindgen_futures::spawn_local(async move {
                // The panel cannot be rebuilt while the tab is being set.
                browser::breathe().await;
                app.rebuild();
                // The message that a record has been read would replace this one.
                while app.with(|lab| lab.reading) == Some(true) {
                    browser::pause(50).await;
                }
                app.report(Message::notice(app.words().measure_shown.to_owned()));
            });
        }
    });
}

/// Turns *Everything* on, with a message that says why, if it is off. The choice of the user stays as it is stored.
pub fn turn_on(app: App, why: &'static str) {
    if !app.everything.get_untracked() {
        app.everything.set(true);
        app.report(Message::notice(why.to_owned()));
    }
}
