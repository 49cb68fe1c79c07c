//! Header of the page: logo, title of the document, and controls for the whole page.

use crate::app::App;
use crate::{files, library_list, publish};
use view::icons;
use view::views::*;
use web_sys::HtmlInputElement;

/// The header.
pub fn view(app: App) -> HtmlHeader {
    let words = app.words();
    let browse = labelled(icons::books(), words.library)
        .id("browse")
        .title(words.library_title)
        .attr("aria-haspopup", "dialog")
        .when(events::click, move |_| library_list::choose(app));
    let own = View::from((browse, publish::button_of(app)));
    view::header::view(app.page, own, open_button(app))
}

fn open_button(app: App) -> View {
    let words = app.words();
    let mut input = input().r#type("file");
    let node: HtmlInputElement = input.node();
    let chosen = node.clone();
    let read = move |_| {
        if let Some(files) = chosen.files() {
            files::open(app, &files);
        }
        chosen.set_value("");
    };
    let open = labelled(icons::folder(), words.open)
        .id("open")
        .title(words.open_title)
        .when(events::click, move |_| node.click());
    let input = input
        .id("open-file")
        .hidden(true)
        .multiple(true)
        .accept(".md,.markdown,.html,.htm,.meniscus,.hand-in,text/markdown,text/html")
        .attr("aria-label", words.open_title)
        .when(events::change, read);
    View::from((open, input))
}
