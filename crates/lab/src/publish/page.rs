//! Standalone page that plays the document, and packages of it for courses, identical to the files written by `meniscus export`.

use super::words;
use crate::app::App;
use crate::documents::visited::{files, stem};
use crate::{documents::carried, documents::packing};
use class::course::{Kind, package};
use document::page::{self, Source};
use program::{Program, bundle};
use std::rc::Rc;
use view::browser;
use view::page::opening::Opening;
use view::views::*;

/// The page, while the dialog is open.
#[derive(Clone, Copy)]
pub struct Page(Signal<State>);

#[derive(Clone)]
enum State {
    Preparing,
    Ready(Rc<Made>),
    Refused(&'static str),
}

/// A finished page.
struct Made {
    html: String,
    program: Program,
}

impl Page {
    /// Starts building the page of the open document, with the texts in the editor.
    pub fn prepare(app: App) -> Self {
        let state = create_signal(State::Preparing);
        let words = words::of(app);
        let sources = files(app);
        wasm_bindgen_futures::spawn_local(async move {
            let made = match made(&sources).await {
                Ok(page) => State::Ready(Rc::new(page)),
                Err(Refused::Faulty) => State::Refused(words.faulty),
                Err(Refused::TooLarge) => State::Refused(words.page_too_large),
                Err(Refused::PlayerMissing) => State::Refused(words.page_missing),
            };
            // The dialog may have been closed meanwhile.
            if state.is_alive() {
                state.set(made);
            }
        });
        Self(state)
    }

    /// The section, with a button that saves the page and shows its size.
    pub fn view(self, app: App) -> View {
        let words = words::of(app);
        let Self(state) = self;
        let save = move |_| {
            if let State::Ready(page) = state.get_clone_untracked() {
                browser::save_text(&format!("{}.html", stem(app)), "text/html", &page.html);
            }
        };
        let waits = move || (!matches!(state.get_clone(), State::Ready(_))).then_some("true");
        let save = button().class("action").id("save-page").attr("aria-disabled", waits).when(events::click, save);
        let size = move || match state.get_clone() {
            State::Preparing => words.page_preparing.to_owned(),
            State::Ready(page) => format!("{} kB", page.html.len().div_ceil(1000)),
            State::Refused(why) => why.to_owned(),
        };
        let size = span().class("note").role("status").id("page-size").child(text(size));
        View::from((note(words.page_intro), div().class("ways").child(save.child(words.page_save)).child(size)))
    }

    /// The section of courses, with a button for each kind of package.
    pub fn course(self, app: App) -> View {
        let words = words::of(app);
        let Self(state) = self;
        let waits = move || (!matches!(state.get_clone(), State::Ready(_))).then_some("true");
        let kinds = [
            (Kind::Scorm12, "SCORM 1.2"),
            (Kind::Scorm2004, "SCORM 2004"),
            (Kind::Cmi5, "cmi5"),
            (Kind::Web, words.course_web),
        ];
        let button_of = |(kind, name): (Kind, &'static str)| {
            let save = move |_| {
                if let State::Ready(page) = state.get_clone_untracked() {
                    let archive = package(kind, &page.html, &page.program);
                    browser::save_bytes(&format!("{}.{}.zip", stem(app), kind.name()), "application/zip", &archive);
                }
            };
            let id = format!("save-{}", kind.name());
            button().class("quiet outlined").id(id).attr("aria-disabled", waits).when(events::click, save).child(name)
        };
        View::from((note(words.course_intro), div().class("ways").each(kinds, button_of), note(words.course_scores)))
    }
}

/// Reason why there is no page.
enum Refused {
    Faulty,
    TooLarge,
    PlayerMissing,
}

/// Builds the page of these sources.
async fn made(sources: &[Source]) -> Result<Made, Refused> {
    let texts: Vec<&str> = sources.iter().map(|source| source.text.as_str()).collect();
    let (base, translations) = texts.split_first().ok_or(Refused::Faulty)?;
    let document = document::open(base, translations).sound().ok_or(Refused::Faulty)?;
    let bundle = bundle::write(&document.program).map_err(|_| Refused::TooLarge)?;
    let gzipped = packing::gzip(&bundle).await.ok_or(Refused::PlayerMissing)?;
    let player = player().await.ok_or(Refused::PlayerMissing)?;
    let html = page::played(&player, sources, &document.program, gzipped).ok_or(Refused::PlayerMissing)?;
    Ok(Made { html, program: document.program })
}

/// HTML of the player without a simulation. Its module is the one with which this page has opened.
async fn player() -> Option<String> {
    let part = carried::part("player")?;
    if let Some(address) =
        part.get_attribute("data-script").filter(|_| part.text_content().is_none_or(|text| text.is_empty()))
    {
        carried::run_file(&address).await?;
    }
    let (template, opening) = (carried::inflated(&part).await?, Opening::of_page()?);
    let mut texts = Vec::new();
    for id in page::part_ids(&template) {
        let text = browser::wait(opening.part(&id)?).await.ok()?.as_string()?;
        texts.push((id, text));
    }
    Some(page::with_parts(&template, &texts))
}
