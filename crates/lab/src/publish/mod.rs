//! Publishing dialog, with all ways to export a document from the laboratory.
//!
//! Link and QR code, page, frame, files. The player without a simulation and without its module stands in the page deflated
//! (`document::page::PLAYER`), or in a site in a file of its own; `page.rs` fills it as `meniscus export` does. The published
//! page gets the player's module from the element `#module`.

mod files;
mod frame;
mod hand_in;
mod lesson;
mod link;
mod options;
mod page;
mod sheet;
mod window;
mod words;
mod worksheet;

pub use hand_in::made;
pub use sheet::Sheet;
pub use worksheet::solutions;

use crate::app::App;
use crate::write;
use view::views::*;
use view::{page::header, views};

/// The button in the header of the page.
pub fn button_of(app: App) -> HtmlButton {
    let open = move |_| {
        // Publishes also the text typed last.
        write::flush(app);
        app.publishing.set(true);
        window::open();
    };
    header::publish(app.page).title(app.words().publish_title).when(events::click, open)
}

/// The dialog. Its content exists only while it is open.
pub fn dialog(app: App) -> HtmlDialog {
    let words = words::of(app);
    views::dialog(window::ID, "publish-title", words.title, words.close)
        .when(events::close, move |_| app.publishing.set(false))
        .child(changing(move || if app.publishing.get() { contents(app) } else { View::new() }))
}

fn contents(app: App) -> View {
    let words = words::of(app);
    let page = page::Page::prepare(app);
    div()
        .class("publishing")
        .child(section_of(words.link, link::view(app)))
        .child(section_of(words.lesson, lesson::view(app)))
        .child(section_of(app.page.words().hand_in, hand_in::view(app)))
        .child(section_of(words.sheet, worksheet::view(app)))
        .child(section_of(words.page, page.view(app)))
        .child(section_of(words.course, page.course(app)))
        .child(section_of(words.frame, frame::view(app)))
        .child(section_of(words.files, files::view(app)))
        .into()
}

fn section_of(title: &'static str, content: View) -> HtmlSection {
    section().attr("aria-label", title).child(h3().child(title)).child(content)
}
