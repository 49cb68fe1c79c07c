//! HTML code of a frame that shows the page inside another page.

use super::words::{self, Words};
use crate::app::App;
use crate::visited::stem;
use crate::{carried, library, visited};
use play::{Embedding, PagePart, Subject};
use units::Language;
use units::order::sort_by_key;
use view::browser;
use view::views::*;

/// Settings of the frame.
#[derive(Clone)]
struct Frame {
    address: String,
    width: String,
    height: String,
    embedding: Embedding,
    with_state: bool,
}

impl Frame {
    fn code(&self, app: App) -> String {
        let state = if self.with_state { app.read(|play| play.share()) } else { String::new() };
        let title = view::title(app.page);
        let size = [self.width.trim(), self.height.trim()];
        self.embedding.frame(self.address.trim(), &state, &title, size)
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
    let frame = create_signal(Frame {
        address: address(app),
        width: "100%".to_owned(),
        height: "600".to_owned(),
        embedding: Embedding::default(),
        with_state: false,
    });
    let now = frame.get_clone_untracked();
    let part = |part: PagePart| {
        let show = move |frame: &mut Frame, shown: bool| {
            frame.embedding.hidden.retain(|other| *other != part);
            if !shown {
                frame.embedding.hidden.push(part);
                sort_by_key(&mut frame.embedding.hidden, |part| PagePart::ALL.iter().position(|other| other == part));
            }
        };
        box_for(frame, format!("frame-{}", part.name()), true, name(words, part), show)
    };
    let text_for = |id, name, class, value, take| text_field(frame, id, name, class, value, take);
    let tick_for = |id: &str, name, take: fn(&mut Frame, bool)| box_for(frame, id.to_owned(), false, name, take);
    View::from((
        note(words.frame_intro),
        text_for("frame-address", words.frame_address, "address", now.address, |frame, text| frame.address = text),
        div()
            .class("fields")
            .child(text_for("frame-width", words.frame_width, "size", now.width, |frame, text| frame.width = text))
            .child(text_for("frame-height", words.frame_height, "size", now.height, |frame, text| frame.height = text))
            .child(languages(app, frame)),
        tick_for("frame-follows", words.frame_follows, |frame, on| frame.embedding.follows_content = on),
        fieldset()
            .class("ticks")
            .child(legend().child(words.frame_shown))
            .each(PagePart::ALL.into_iter().filter(|part| *part != PagePart::Measure), part),
        tick_for("frame-locked", words.frame_locked, |frame, on| frame.embedding.locked = on),
        tick_for("frame-state", words.frame_state, |frame, on| frame.with_state = on),
        code(app, frame),
    ))
}

/// The present code, with a copy button.
fn code(app: App, frame: Signal<Frame>) -> View {
    let words = words::of(app);
    let code = memo(move || frame.with(|frame| frame.code(app)));
    let copied = create_signal(None::<&'static str>);
    let copy = move |_| {
        browser::copy(&code.get_clone_untracked(), move |allowed| {
            copied.set(Some(if allowed { words.frame_copied } else { words.frame_not_copied }));
        });
    };
    let shown = pre().class("code").id("frame-code").role("region").tabindex("0").attr("aria-label", words.frame_code);
    let said = span().class("note").role("status").child(text(move || copied.get().unwrap_or_default().to_owned()));
    let copy = button().class("action").id("copy-frame").when(events::click, copy).child(words.frame_copy);
    View::from((shown.child(text(move || code.get_clone())), div().class("ways").child(copy).child(said)))
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

fn box_for(
    frame: Signal<Frame>,
    id: String,
    ticked: bool,
    name: &'static str,
    take: impl Fn(&mut Frame, bool) + 'static,
) -> HtmlLabel {
    let tick = input().r#type("checkbox").id(id).prop("checked", ticked);
    switch(tick.when(events::change, move |event| frame.update(|frame| take(frame, is_checked(&event)))), name)
}

fn name(words: &Words, part: PagePart) -> &'static str {
    match part {
        PagePart::Head => words.part_head,
        PagePart::Scene => words.part_scene,
        PagePart::Plots => words.part_plots,
        PagePart::Parameters => words.part_parameters,
        PagePart::Values => words.part_values,
        PagePart::Activities => words.part_activities,
        PagePart::Measure => words.part_measure,
        PagePart::Text => words.part_text,
    }
}

/// Choice of a language of the document.
fn languages(app: App, frame: Signal<Frame>) -> HtmlLabel {
    let words = words::of(app);
    let known: Vec<String> = app.read(|play| play.program().languages().map(str::to_owned).collect());
    let offered = Language::ALL.into_iter().filter(|language| known.iter().any(|tag| tag == language.tag()));
    let choose = move |event| {
        let tag = value_of(&event);
        let language = Language::ALL.into_iter().find(|language| language.tag() == tag);
        frame.update(|frame| frame.embedding.language = language);
    };
    let select = select()
        .id("frame-language")
        .when(events::change, choose)
        .child(option().value("").child(words.frame_any_language))
        .each(offered, |language| option().value(language.tag()).child(language.name()));
    label().class("field").child(span().child(words.frame_language)).child(select)
}
