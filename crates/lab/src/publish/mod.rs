//! Publishing dialog, with all ways to export a document from the laboratory.
//!
//! It has three parts: a student hands in, anybody sends a link or a file, a teacher publishes. The player without a simulation and without its module stands in the page deflated
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
use crate::documents::links;
use crate::write;
use view::views::*;
use view::{browser, page::header, views};

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
    // The title of the part is that of its section.
    let hand_in = section().attr("aria-label", words.part_hand_in).child(hand_in::view(app));
    // A link to a page of this computer alone leads nobody else anywhere: the files come first there.
    let mut send = [section_of(words.link, link::view(app)), section_of(words.files, files::view(app))];
    if links::is_local(&browser::address("")) {
        send.reverse();
    }
    let publish = [
        section_of(words.page, page.view(app)),
        section_of(words.frame, frame::view(app)),
        section_of(words.course, page.course(app)),
        section_of(words.lesson, lesson::view(app)),
        section_of(words.sheet, worksheet::view(app)),
    ];
    div()
        .class("publishing")
        .child(part_of(words.part_hand_in, words.part_hand_in_note, [hand_in]))
        .child(part_of(words.part_send, words.part_send_note, send))
        .child(part_of(words.part_publish, words.part_publish_note, publish))
        .into()
}

/// Part of the dialog for one reader. `who`: for whom it is, and what for.
fn part_of<const COUNT: usize>(title: &'static str, who: &'static str, sections: [HtmlSection; COUNT]) -> HtmlDiv {
    div().class("publishing-part").child(h3().child(title)).child(note(who)).each(sections, |section| section)
}

fn section_of(title: &'static str, content: View) -> HtmlSection {
    section().attr("aria-label", title).child(h4().child(title)).child(content)
}
