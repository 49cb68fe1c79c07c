//! Opening documents: those that the page carries, and files that the user picks or drops. The state of the last visit
//! comes back with them.

use crate::app::App;
use crate::views::*;
use crate::{browser, fitting, frame, library, measurements};
use document::page::{self, Source};
use model::Diagnostic;
use session::Session;
use web_sys::{DragEvent, Event, File, FileList};

/// What was found in the files, each with the number of its file.
pub type Findings = Vec<(usize, Diagnostic)>;

/// Opens what the page was exported with; a page that was not opens with the first document of the library.
pub fn open_embedded(app: App) {
    let sources = document()
        .get_element_by_id("documents")
        .and_then(|element| page::read(&element.outer_html()))
        .unwrap_or_else(library::first);
    let fragment = window().location().hash().unwrap_or_default();
    open(app, sources, fragment.trim_start_matches('#'));
}

/// Opens a document from its files. `state` is a shared state; without one the state of the last visit is taken.
fn open(app: App, sources: Vec<Source>, state: &str) {
    let texts: Vec<&str> = sources.iter().map(|source| source.text.as_str()).collect();
    let (session, findings) = match texts.split_first() {
        Some((source, translations)) => {
            let opened = document::open(source, translations);
            (opened.document.map(Session::open), opened.diagnostics)
        }
        None => (None, Vec::new()),
    };
    app.with(|lab| {
        let mut session = session;
        match (&mut lab.session, &mut session) {
            (Some(before), Some(session)) => session.adopt_records(before),
            (None, Some(session)) => {
                session.restore_records(&browser::remembered("records").unwrap_or_default());
                session.restore_fits(&browser::remembered("fits").unwrap_or_default());
            }
            (_, None) => {}
        }
        lab.session = session;
        lab.sources = sources;
        lab.findings = findings;
    });
    // Nobody is told: what shows the tabs is built anew below.
    app.tab.set_silent(0);
    let language = app.language.get_untracked();
    let remembered = browser::remembered(&key(app)).unwrap_or_default();
    let state = if state.is_empty() { remembered.as_str() } else { state };
    app.read(|session| {
        session.set_language(language.tag());
        if !state.is_empty()
            && let Err(refusal) = session.restore(state)
        {
            // A state of another document or version: what does not fit is left out, and that is said.
            web_sys::console::warn_1(&session.refusal_text(&refusal).into());
        }
    });
    app.rebuild();
    if app.read(|session| session.has_fits_waiting()) {
        fitting::go_on(app);
    }
}

/// Opens a document of the library.
pub fn open_sources(app: App, sources: Vec<Source>) {
    remember_now(app);
    open(app, sources, "");
}

/// Under which name the state of this document is remembered: by its file and title, so that documents keep apart.
fn key(app: App) -> String {
    let name = app.with(|lab| lab.sources.first().map(|source| source.name.clone())).flatten().unwrap_or_default();
    format!("state:{name}:{}", app.read(|session| session.document().title.clone()))
}

/// Remembers the state for the next visit, whenever the page is about to go out of sight: the only moment that every
/// browser announces.
pub fn remember_state(app: App) {
    browser::listen("pagehide", move |_: &Event| remember_now(app));
    browser::listen("visibilitychange", move |_: &Event| {
        remember_now(app);
        // Back in sight, the frames go on.
        frame::wake(app);
    });
}

fn remember_now(app: App) {
    if let Some(state) = app.read(|session| Some(session.share())) {
        browser::remember(&key(app), &state);
    }
    let (records, _) = app.read(|session| session.saved_records());
    browser::remember("records", &records);
    browser::remember("fits", &app.read(|session| session.saved_fits()));
}

/// Opens files that the user picked: a document with its translations, one exported page, or records.
pub fn open_files(app: App, files: &FileList) {
    let files: Vec<File> = (0..files.length()).filter_map(|index| files.get(index)).collect();
    wasm_bindgen_futures::spawn_local(async move {
        let mut sources = Vec::new();
        let is_document = |file: &File| {
            let name = file.name().to_lowercase();
            [".md", ".markdown", ".html", ".htm"].iter().any(|ending| name.ends_with(ending))
        };
        let (documents, records): (Vec<File>, Vec<File>) = files.into_iter().partition(is_document);
        if documents.is_empty() {
            return measurements::read_all(app, records).await;
        }
        for file in documents {
            let Ok(text) = browser::wait(file.text()).await else { continue };
            let (name, text) = (file.name(), text.as_string().unwrap_or_default());
            if let Some(embedded) = page::read(&text) {
                sources = embedded;
                break;
            }
            if !name.to_lowercase().ends_with(".html") {
                sources.push(Source { name, text });
            }
        }
        // `utube.md` before `utube.es.md`: the document before its translations.
        sources.sort_by_key(|source| source.name.matches('.').count());
        if sources.is_empty() {
            return app.say(app.words().unreadable.to_owned());
        }
        remember_now(app);
        open(app, sources, "");
        measurements::read_all(app, records).await;
        browser::focus_later("play".to_owned());
    });
}

/// Files may be dropped anywhere.
pub fn accept_drops(app: App) {
    browser::listen("dragover", |event: &Event| event.prevent_default());
    browser::listen("drop", move |event: &DragEvent| {
        event.prevent_default();
        if let Some(files) = event.data_transfer().and_then(|data| data.files()) {
            open_files(app, &files);
        }
    });
    browser::listen("hashchange", move |_: &Event| {
        let fragment = window().location().hash().unwrap_or_default();
        restore(app, fragment.trim_start_matches('#'));
    });
}

/// A link to another state of the same page was followed. Links to headings are not states.
fn restore(app: App, fragment: &str) {
    let is_heading = document().get_element_by_id(fragment).is_some();
    if !fragment.is_empty() && !is_heading {
        app.attempt(|session| session.restore(fragment));
    }
}
