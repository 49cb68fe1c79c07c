//! HTML code of a frame that shows the page inside another page.

use super::options::Options;
use super::words;
use crate::app::App;
use crate::documents::visited::stem;
use crate::{documents::carried, documents::visited, library};
use play::{Embedding, PagePart, Subject};
use view::browser;
use view::views::*;

/// Settings of the frame beside its options.
#[derive(Clone)]
struct Frame {
    address: String,
    width: String,
    height: String,
    with_state: bool,
}

impl Frame {
    fn code(&self, app: App, embedding: &Embedding) -> String {
        let state = if self.with_state { app.read(|play| play.share()) } else { String::new() };
        let title = view::title(app.page);
        let size = [self.width.trim(), self.height.trim()];
        embedding.frame(self.address.trim(), &state, &title, size)
    }
}

/// Probable address of the page: in a site its own page, otherwise a file beside the surrounding page.
fn address(app: App) -> String {
    let Subject::Library(name) = library::subject(&visited::sources(app)) else { return format!("{}.html", stem(app)) };
    let laboratory = browser::address("");
    let folder = laboratory.split('?').next().and_then(|address| address.rsplit_once('/')).map(|(folder, _)| folder);
    match folder.filter(|_| carried::is_in_site()) {
        Some(folder) => format!("{folder}/{}.html", name.trim_end_matches(".md")),
        None => format!("{}.html", stem(app)),
    }
}

/// Section of the dialog: settings and code of the frame.
pub fn view(app: App) -> View {
    let words = words::of(app);
    let options = Options::new(app, "frame");
    let frame = create_signal(Frame {
        address: address(app),
        width: "100%".to_owned(),
        height: "600".to_owned(),
        with_state: false,
    });
    let now = frame.get_clone_untracked();
    let text_for = |id, name, class, value, take| text_field(frame, id, name, class, value, take);
    let follow = move |on| options.chosen.update(|chosen| chosen.follows_content = on);
    let keep = move |on| frame.update(|frame| frame.with_state = on);
    let code = memo(move || options.chosen.with(|chosen| frame.with(|frame| frame.code(app, chosen))));
    View::from((
        note(words.frame_intro),
        text_for("frame-address", words.frame_address, "address", now.address, |frame, text| frame.address = text),
        div()
            .class("fields")
            .child(text_for("frame-width", words.frame_width, "size", now.width, |frame, text| frame.width = text))
            .child(text_for("frame-height", words.frame_height, "size", now.height, |frame, text| frame.height = text))
            .child(options.language()),
        switch(tick("frame-follows".to_owned(), false, follow), words.frame_follows),
        // The exported page measures nothing.
        options.parts(PagePart::ALL.into_iter().filter(|part| *part != PagePart::Measure)),
        options.locked(),
        switch(tick("frame-state".to_owned(), false, keep), words.frame_state),
        options.result(code, words.frame_code, words.frame_copy),
    ))
}

fn text_field(
    frame: Signal<Frame>,
    id: &'static str,
    name: &'static str,
    class: &'static str,
    value: String,
    take: fn(&mut Frame, String),
) -> HtmlLabel {
    let input = input().r#type("text").id(id).class(class).value(value).attr("spellcheck", "false");
    let input = input.when(events::input, move |event| frame.update(|frame| take(frame, value_of(&event))));
    label().class("field").child(span().child(name)).child(input)
}
