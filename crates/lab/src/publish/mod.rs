//! Publishing: a dialog with all ways in which a document leaves the laboratory.

mod files;
mod frame;
mod link;
mod page;
mod words;

use crate::app::App;
use crate::{visited, write};
use view::views::*;
use view::{browser, icons, views};
use web_sys::HtmlDialogElement;
use words::{Words, words_in};

const DIALOG: &str = "publish";

/// The words of publishing, without tracking: whatever shows them is built again for another language.
fn words(app: App) -> &'static Words {
    words_in(app.language.get_untracked())
}

/// The button in the head of the page.
pub fn button_of(app: App) -> HtmlButton {
    let words = words(app);
    let open = move |_| {
        // What was typed last is published, too.
        write::flush(app);
        app.publishing.set(true);
        if let Some(dialog) = browser::by_id::<HtmlDialogElement>(DIALOG) {
            let _ = dialog.show_modal();
        }
    };
    labelled(icons::link(), words.button)
        .id("share")
        .title(words.button_title)
        .attr("aria-haspopup", "dialog")
        .when(events::click, open)
}

/// The dialog. Its content is there only while it is open.
pub fn dialog(app: App) -> HtmlDialog {
    let words = words(app);
    views::dialog(DIALOG, "publish-title", words.title, words.close)
        .when(events::close, move |_| app.publishing.set(false))
        .child(changing(move || if app.publishing.get() { contents(app) } else { View::new() }))
}

fn contents(app: App) -> View {
    let words = words(app);
    let page = page::Page::prepare(app);
    div()
        .class("publishing")
        .child(section_of(words.link, link::view(app)))
        .child(section_of(words.page, page.view(app)))
        .child(section_of(words.frame, frame::view(app)))
        .child(section_of(words.files, files::view(app)))
        .into()
}

fn section_of(title: &'static str, content: View) -> HtmlSection {
    section().attr("aria-label", title).child(h3().child(title)).child(content)
}

/// What files of the open document are called, without an ending.
fn stem(app: App) -> String {
    let name = visited::sources(app).first().map(|source| source.name.clone()).unwrap_or_default();
    let name = name.rsplit('/').next().unwrap_or_default().trim_end_matches(".md");
    if name.is_empty() { "simulation".to_owned() } else { name.to_owned() }
}

/// Closes the dialog, so that the line of messages can be seen.
fn close() {
    if let Some(dialog) = browser::by_id::<HtmlDialogElement>(DIALOG) {
        dialog.close();
    }
}
