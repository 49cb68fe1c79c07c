//! The list of the documents that the page carries, as a dialog.

use crate::app::App;
use crate::library::{Entry, THEORIES, entries, find};
use crate::opening;
use view::views::*;
use view::{browser, views};
use web_sys::HtmlDialogElement;

/// Opens the entry of this file. Whether there is one.
pub fn open(app: App, file: &str) -> bool {
    let Some(files) = find(file) else { return false };
    opening::open_sources(app, files);
    true
}

/// Opens the list.
pub fn choose(app: App) {
    app.library_asked_for.set(true);
    if let Some(dialog) = browser::by_id::<HtmlDialogElement>("library-list") {
        let _ = dialog.show_modal();
    }
}

/// The list of documents. It is made when it is first asked for: the page opens without reading them all for titles.
pub fn dialog(app: App) -> HtmlDialog {
    let words = app.words();
    views::dialog("library-list", "library-title", words.library, words.close)
        .child(p().child(words.library_intro))
        .child(changing(move || if app.library_asked_for.get() { groups(app) } else { View::new() }))
}

fn close() {
    if let Some(dialog) = browser::by_id::<HtmlDialogElement>("library-list") {
        dialog.close();
    }
}

fn groups(app: App) -> View {
    let words = app.words();
    let (theories, simulations): (Vec<Entry>, Vec<Entry>) =
        entries().into_iter().partition(|entry| entry.file().starts_with(THEORIES));
    View::from((group(app, words.library_simulations, simulations), group(app, words.library_theories, theories)))
}

fn group(app: App, title: &'static str, entries: Vec<Entry>) -> View {
    let language = app.language.get_untracked().tag();
    let item = |entry: Entry| {
        let (file, title) = (entry.file().to_owned(), entry.title(language));
        let choose = move |_| {
            close();
            open(app, &file);
            browser::focus_later("browse".to_owned());
        };
        li().child(button().class("entry").when(events::click, choose).child(title))
    };
    View::from((h3().child(title), ul().class("entries").each(entries, item)))
}
