//! HTML code of a frame that shows the page inside another page.

use super::options::Options;
use super::words;
use crate::app::App;
use crate::documents::visited::stem;
use crate::{documents::carried, documents::visited, library};
use play::{Embedding, PagePart, Subject};
use units::number::Style;
use units::number::typed::{NotRead, counted, whole};
use view::browser;
use view::views::*;

/// Largest width or height of a frame, px.
const MOST_PIXELS: i64 = 10_000;

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
        embedding.frame(self.address.trim(), &state, &title, [&self.width, &self.height])
    }
}

/// A width or height for the attributes of the frame: a percentage, or a number of pixels.
fn size(typed: &str, style: Style) -> Result<String, NotRead> {
    let typed = typed.trim();
    if typed.ends_with('%') {
        return counted(typed, "%", style).map(|percent| format!("{percent}%"));
    }
    let pixels = typed.strip_suffix("px").unwrap_or(typed);
    whole(pixels, 1..=MOST_PIXELS, style).map(|pixels| pixels.to_string())
}

/// Field of a width or height. A refused text leaves the frame as it is.
fn size_field(
    app: App,
    frame: Signal<Frame>,
    id: &'static str,
    name: &'static str,
    value: String,
    take: fn(&mut Frame, String),
) -> View {
    let refused = create_signal(None);
    let input = number_field(id, refused).class("size").value(value).when(events::input, move |event| {
        let language = app.language.get_untracked();
        let read = size(&value_of(&event), language.style());
        refused.set(read.as_ref().err().map(|why| why.words().text(language).into_owned()));
        if let Ok(size) = read {
            frame.update(|frame| take(frame, size));
        }
    });
    View::from((label().class("field").child(span().child(name)).child(input), why_refused(id, refused)))
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
    let follow = move |on| options.chosen.update(|chosen| chosen.follows_content = on);
    let keep = move |on| frame.update(|frame| frame.with_state = on);
    let code = memo(move || options.chosen.with(|chosen| frame.with(|frame| frame.code(app, chosen))));
    View::from((
        note(words.frame_intro),
        address_field(frame, "frame-address", words.frame_address, now.address),
        div()
            .class("fields")
            .child(size_field(app, frame, "frame-width", words.frame_width, now.width, |frame, text| {
                frame.width = text
            }))
            .child(size_field(app, frame, "frame-height", words.frame_height, now.height, |frame, text| {
                frame.height = text;
            }))
            .child(options.language()),
        switch(tick("frame-follows".to_owned(), false, follow), words.frame_follows),
        // The exported page measures nothing.
        options.parts(PagePart::ALL.into_iter().filter(|part| *part != PagePart::Measure)),
        options.locked(),
        switch(tick("frame-state".to_owned(), false, keep), words.frame_state),
        options.result(code, words.frame_code, words.frame_copy),
    ))
}

fn address_field(frame: Signal<Frame>, id: &'static str, name: &'static str, value: String) -> HtmlLabel {
    let input = input().r#type("text").id(id).class("address").value(value).attr("spellcheck", "false");
    let input = input.when(events::input, move |event| frame.update(|frame| frame.address = value_of(&event)));
    label().class("field").child(span().child(name)).child(input)
}
