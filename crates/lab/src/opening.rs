//! Opening documents: those that the page carries, and files that the user picks or drops. The state of the last visit
//! comes back with them.

use crate::app::App;
use crate::links::Arrival;
use crate::visited::Visited;
use crate::{film, fit, intake, saved, visited, write};
use desk::Desk;
use document::page::{self, Source};
use view::{browser, messages};
use web_sys::{Event, File, FileList};

/// Opens what a link or the history leads to.
pub fn arrive(app: App, arrival: Arrival) {
    let Arrival { sources, state, refusal, awaited } = arrival;
    let is_open = app.with(|lab| lab.desk.is_some() && lab.sources == sources) == Some(true);
    if is_open && !state.is_empty() {
        let (resized, refusal) = app.act_on_desk(|desk| restored(desk, &state));
        if resized {
            app.rebuild();
        }
        if let Some(refusal) = refusal {
            app.complain(refusal);
        }
    } else if !is_open {
        leave(app);
        open(app, sources, &state);
    }
    app.with(|lab| lab.awaited = awaited);
    visited::note(app, None);
    if let Some(refusal) = refusal {
        app.complain(app.read(|play| play.refusal_text(&refusal)));
    }
}

/// Opens a document from its files. `state` is a shared state; without one the state of the last visit is taken.
pub fn open(app: App, sources: Vec<Source>, state: &str) {
    let texts: Vec<&str> = sources.iter().map(|source| source.text.as_str()).collect();
    let (desk, findings) = match texts.split_first() {
        Some((source, translations)) => {
            let opened = document::open(source, translations);
            (opened.document.map(Desk::open), opened.diagnostics)
        }
        None => (None, Vec::new()),
    };
    let closed = app.with(|lab| {
        let (mut desk, mut closed) = (desk, 0);
        // A document that does not run holds no records; they wait for the next one that does.
        // From there a button leads back to the last one that did.
        if desk.is_some() {
            lab.sources_before.clear();
        } else if lab.desk.is_some() {
            lab.sources_before = std::mem::take(&mut lab.sources);
        }
        let before = lab.desk.take().or_else(|| lab.parked.take());
        match (before, &mut desk) {
            (Some(mut before), Some(desk)) => desk.adopt_records(&mut before),
            (None, Some(desk)) => closed = saved::restore_measured(&mut lab.saved, desk),
            (before, None) => lab.parked = before,
        }
        if let Some(desk) = &mut desk {
            saved::restore_answers(&mut lab.saved, &sources, desk);
        }
        lab.drafts.clear();
        lab.written_as = None;
        lab.editor_is_current = false;
        lab.desk = desk;
        lab.sources = sources;
        lab.findings = findings;
        closed
    });
    let language = app.language.get_untracked();
    let left = saved::state(app);
    let state = if state.is_empty() { left.as_str() } else { state };
    let refusal = app.read_desk(|desk| {
        desk.set_language(language.tag());
        if state.is_empty() { None } else { restored(desk, state).1 }
    });
    write::resume(app, visited::present());
    messages::leave_document(app.page);
    app.rebuild();
    if let Some(refusal) = refusal {
        app.complain(refusal);
    }
    if closed.is_some_and(|closed| closed > 0) {
        app.complain(app.words().records_closed.to_owned());
    }
    if app.read_desk(|desk| desk.has_fits_waiting()) {
        fit::go_on(app);
    }
}

/// Brings back a state: whether families have other sizes now, and what could not be done, in words.
fn restored(desk: &mut Desk, state: &str) -> (bool, Option<String>) {
    let (resized, result) = desk.restore(state);
    (resized, result.err().map(|refusal| desk.play().refusal_text(&refusal)))
}

/// Opens a document of the library, or that of a fit.
pub fn open_sources(app: App, sources: Vec<Source>) {
    go_to(app, sources, "");
}

/// Opens a document as the next step of the visit.
fn go_to(app: App, sources: Vec<Source>, state: &str) {
    leave(app);
    open(app, sources, state);
    visited::step(app);
    // What is wrong with it stands at the top, too.
    browser::scroll_to(0.0);
}

/// Opens what was written earlier.
pub fn open_kept(app: App, kept: Visited) {
    go_to(app, kept.sources.clone(), "");
    write::resume(app, Some(kept));
    visited::note(app, None);
}

/// Opens another theory for the records that are being fitted: the page stays where it is scrolled to.
pub fn change_theory(app: App, sources: Vec<Source>) {
    let place = browser::scrolled();
    leave(app);
    open(app, sources, "");
    visited::step(app);
    browser::scroll_to(place);
}

/// Opens the corrected text of a document that did not run.
pub fn check_again(app: App, sources: Vec<Source>) {
    open(app, sources, "");
    visited::step(app);
    if app.read(|_| true) {
        app.notify(app.words().it_runs);
        browser::focus_later("play".to_owned());
    } else {
        app.say(app.words().broken.to_owned());
        browser::reveal_later("apparatus".to_owned());
    }
}

/// Saves what there is of the open document before another one takes its place.
pub fn leave(app: App) {
    write::flush(app);
    saved::now(app);
}

/// Saves everything for the next visit, whenever the page is about to go out of sight: the only moment that every browser
/// announces.
pub fn save_when_left(app: App) {
    browser::listen("pagehide", move |_: &Event| leave(app));
    browser::listen("visibilitychange", move |_: &Event| {
        leave(app);
        // Back in sight, the frames go on.
        app.page.wake();
    });
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
        let (films, files): (Vec<File>, Vec<File>) = files.into_iter().partition(film::is_film);
        if let Some(file) = films.into_iter().next() {
            film::open(app, file);
        }
        let (documents, records): (Vec<File>, Vec<File>) = files.into_iter().partition(is_document);
        if documents.is_empty() {
            return intake::read(app, records);
        }
        for file in documents {
            let Ok(text) = browser::wait(file.text()).await else {
                app.complain(format!("{} {}", app.words().file_not_read, file.name()));
                continue;
            };
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
            return app.complain(app.words().unreadable.to_owned());
        }
        // A link may have been waiting for this file.
        let name = sources.first().map(|source| source.name.clone());
        let awaited = app.with(|lab| lab.awaited.take_if(|(awaited, _)| Some(&*awaited) == name.as_ref()));
        let state = awaited.flatten().map(|(_, state)| state).unwrap_or_default();
        go_to(app, sources, &state);
        intake::read(app, records);
        browser::focus_later(if app.read(|_| true) { "play" } else { "apparatus" }.to_owned());
    });
}
