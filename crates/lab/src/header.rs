//! Header of the page: logo, title of the document, and controls for the whole page.

use crate::app::App;
use crate::{library, library::list as library_list, measuring::files, publish, welcome};
use view::views::*;
use view::{browser, page::everything, page::header, pieces::icons};
use web_sys::HtmlInputElement;

/// The header.
pub fn view(app: App) -> HtmlHeader {
    let browse = header::browse(app.page)
        .title(app.words().library_title)
        .when(events::click, move |_| library_list::choose(app));
    let everything = header::everything(app.page).title(app.words().everything_title);
    let everything = everything.when(events::click, move |_| everything::turn(app.page));
    let own = View::from((browse, publish::button_of(app), everything));
    let published = labelled(icons::books(), app.words().published).id("published");
    let published = published.when(events::click, move |_| {
        library_list::open(app, library::PUBLISHED);
        browser::focus_later("menu".to_owned());
    });
    header::view(app.page, welcome::view(app), own, View::from((open_button(app), published)))
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
    let open = header::open(app.page).title(words.open_title).when(events::click, move |_| node.click());
    let input = input
        .id("open-file")
        .hidden(true)
        .multiple(true)
        .accept(".md,.markdown,.html,.htm,.meniscus,.hand-in,.ejss,.json,.zip,text/markdown,text/html")
        .attr("aria-label", words.open_title)
        .when(events::change, read);
    View::from((open, input))
}
