//! Turns *Everything* on when something is opened that needs a hidden part of the page.

use crate::app::App;
use view::message::Message;
use view::tabs::{CLASS, WRITE};
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
    });
}

/// Turns *Everything* on, with a message that says why, if it is off. The choice of the user stays as it is stored.
pub fn turn_on(app: App, why: &'static str) {
    if !app.everything.get_untracked() {
        app.everything.set(true);
        app.report(Message::notice(why.to_owned()));
    }
}
