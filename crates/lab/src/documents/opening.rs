//! Opening documents, with the state of the last visit.

use crate::app::{App, Findings, Lab};
use crate::documents::links::Arrival;
use crate::documents::stored::VersionTimes;
use crate::documents::visited::Visited;
use crate::{documents::saved, documents::visited, fit, library, write};
use desk::{Desk, Writing};
use document::page::Source;
use document::{Document, Opened, Opening};
use std::rc::Rc;
use units::Language;
use view::page::opening::Handed;
use view::{browser, page::messages};
use web_sys::Event;

/// Opens the document of a link or history entry.
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
        app.complain(app.read(|play| play.basis().refusal_text(&refusal)));
    }
}

/// Opens a document from its files with a shared state; if `state` is empty, with the state of the last visit.
pub fn open(app: App, sources: Vec<Source>, state: &str) {
    let present = visited::present().filter(|visited| visited.sources == sources);
    open_visited(app, present.unwrap_or(Visited { sources, draft: None }), state);
}

/// The page's own document, made for a page in this language. `turn` is awaited before each part of the work.
pub async fn home(language: Language, turn: impl AsyncFn()) -> Home {
    let visited = visited::present().filter(|visited| visited.sources == library::home());
    let visited = visited.unwrap_or_else(|| Visited { sources: library::home(), draft: None });
    let made = made_in_portions(&visited.sources, language, turn).await;
    Home { visited, made }
}

/// The page's own document, on a desk that is not shown yet.
pub struct Home {
    visited: Visited,
    made: Made,
}

impl Home {
    /// Places the document, as it is at first.
    pub fn place(self, app: App) {
        place_visited(app, self.visited, self.made, |_, _| None);
    }
}

/// Continues the simulation of the player, whose document is open.
pub fn take_over(app: App, handed: &mut Handed) {
    handed.prepare(app.page);
    app.act_on_desk(|desk| handed.continue_in(desk.play_mut()));
    visited::note(app, None);
}

/// Opens a document of a history entry, with its draft.
fn open_visited(app: App, visited: Visited, state: &str) {
    let made = Made::of(app.language.get_untracked(), opened(&visited.sources));
    place_made(app, visited, made, state);
}

/// Texts of a document: its own and those of its translations. An empty text if there is none.
fn texts_of(sources: &[Source]) -> (&str, Vec<&str>) {
    let mut texts = sources.iter().map(|source| source.text.as_str());
    (texts.next().unwrap_or_default(), texts.collect())
}

/// Reads and checks the texts of a document.
fn opened(sources: &[Source]) -> Opened {
    if sources.is_empty() {
        return Opened { document: None, diagnostics: Vec::new() };
    }
    let (source, translations) = texts_of(sources);
    document::open(source, &translations)
}

/// A document that is read, on a desk of its own that is not shown yet.
struct Made {
    /// `None` if the document does not run.
    desk: Option<Desk>,
    findings: Findings,
}

impl Made {
    /// Places a read document on a desk whose texts are in this language.
    fn of(language: Language, opened: Opened) -> Self {
        let mut desk = opened.document.map(Desk::open);
        if let Some(desk) = &mut desk {
            prepare(desk, language);
        }
        Self { desk, findings: opened.diagnostics }
    }
}

/// Reads and checks the texts of a document and places it on a desk. `turn` is awaited before each part of the work.
async fn made_in_portions(sources: &[Source], language: Language, turn: impl AsyncFn()) -> Made {
    turn().await;
    let (source, translations) = texts_of(sources);
    let mut opening = Opening::begin(source, &translations);
    turn().await;
    while opening.advance() {
        turn().await;
    }
    let Opened { document, diagnostics } = opening.finish();
    turn().await;
    let mut desk = document.map(Desk::open);
    turn().await;
    if let Some(desk) = &mut desk {
        prepare(desk, language);
    }
    Made { desk, findings: diagnostics }
}

/// Lets a desk compile its steps, and puts its texts into this language.
fn prepare(desk: &mut Desk, language: Language) {
    compile_steps(desk);
    desk.set_language(language.tag());
}

/// Makes the steps of the run, and of later ones, in WebAssembly that is emitted for them.
fn compile_steps(desk: &mut Desk) {
    desk.play_mut().change_run(|line, _| line.use_compiler(Rc::<host::Compiler>::default()));
}

fn place_made(app: App, visited: Visited, made: Made, state: &str) {
    place_visited(app, visited, made, |desk, left| {
        let state = if state.is_empty() { left } else { state };
        if state.is_empty() { None } else { restored(desk, state).1 }
    });
}

/// Places a document that was made from the sources of `visited`. `restore` gets the state of the last visit, and returns the text of the refusal, if any.
fn place_visited(
    app: App,
    visited: Visited,
    Made { desk, findings }: Made,
    restore: impl FnOnce(&mut Desk, &str) -> Option<String>,
) {
    app.with(Lab::ask_for_document);
    let (sources, written_as) = (visited.sources.clone(), write::kept::find(&visited));
    let closed = app.with(|lab| {
        // If the new document does not run, a button leads back to the last one that did.
        if desk.is_some() {
            lab.sources_before.clear();
        } else if lab.desk.is_some() {
            lab.sources_before = std::mem::take(&mut lab.sources);
        }
        lab.sources = sources;
        lab.findings = findings;
        lab.written_as = written_as;
        lab.version_times = VersionTimes::default();
        lab.editor_is_current = false;
        place(lab, desk)
    });
    let left = saved::state(app);
    let refusal = app.read_desk(|desk| restore(desk, &left));
    messages::leave_document(app.page);
    write::resume(app, Some(visited));
    app.rebuild();
    if let Some(refusal) = refusal {
        app.complain(refusal);
    }
    placed(app, closed.unwrap_or_default());
}

/// Replaces the desk; the new one takes over the records. If the document does not run, the records wait for the next
/// one that does. Returns the number of stored records that could not be restored for lack of room.
fn place(lab: &mut Lab, mut desk: Option<Desk>) -> usize {
    let before = lab.desk.take().or_else(|| lab.parked.take());
    let mut closed = 0;
    match (before, &mut desk) {
        (Some(mut before), Some(desk)) => desk.adopt(&mut before),
        (None, Some(desk)) => closed = saved::restore_measured(&mut lab.saved, desk),
        (before, None) => lab.parked = before,
    }
    lab.faulty = match &mut desk {
        Some(desk) => {
            saved::restore_answers(&mut lab.saved, &lab.sources, lab.written_as.as_ref(), desk);
            Writing::default()
        }
        None => {
            let texts = lab.sources.iter().map(|source| source.text.clone()).collect();
            Writing::of_faulty(texts, lab.findings.clone())
        }
    };
    lab.desk = desk;
    closed
}

/// Follow-up actions after placing a desk.
fn placed(app: App, closed: usize) {
    if closed > 0 {
        app.complain(app.words().records_closed.to_owned());
    }
    // Also ends what was computed for the desk before.
    fit::go_on(app);
}

/// Changes the texts of a document that does not run, and its files. Once it runs, the stage and the other tabs show
/// it.
pub fn mend(app: App, change: impl FnOnce(&mut Writing, &mut Vec<Source>) -> Option<Document>) {
    let language = app.language.get_untracked();
    let closed = app.with(|lab| {
        let document = change(&mut lab.faulty, &mut lab.sources);
        for (source, text) in lab.sources.iter_mut().zip(lab.faulty.texts()) {
            source.text.clone_from(text);
        }
        lab.findings = lab.faulty.findings().to_vec();
        let mut desk = Desk::open(document?);
        desk.set_writing(std::mem::take(&mut lab.faulty));
        prepare(&mut desk, language);
        lab.sources_before.clear();
        Some(place(lab, Some(desk)))
    });
    visited::note(app, None);
    if let Some(closed) = closed.flatten() {
        app.rebuild_program();
        placed(app, closed);
    }
}

/// Restores a state. Returns true if sizes of families have changed, and the text of the refusal, if any.
fn restored(desk: &mut Desk, state: &str) -> (bool, Option<String>) {
    let (resized, result) = desk::restore(desk, state);
    (resized, result.err().map(|refusal| desk.play().basis().refusal_text(&refusal)))
}

/// Opens a document of the library or of a fit.
pub fn open_sources(app: App, sources: Vec<Source>) {
    go_to(app, sources, "");
}

/// Opens a document as a new history entry. `state` may be empty.
pub fn go_to(app: App, sources: Vec<Source>, state: &str) {
    go_to_visited(app, Visited { sources, draft: None }, state);
}

/// [`go_to`] in several tasks of the browser, for a document of any length. If another one is opened meanwhile, that one stays.
pub async fn go_to_in_portions(app: App, sources: Vec<Source>, state: &str) {
    let Some(own) = app.with(Lab::ask_for_document) else { return };
    let made = made_in_portions(&sources, app.language.get_untracked(), browser::breathe).await;
    let is_latest = || app.with(|lab| lab.asked_for) == Some(own);
    browser::breathe().await;
    if !is_latest() {
        return;
    }
    leave(app);
    browser::breathe().await;
    if !is_latest() {
        return;
    }
    place_made(app, Visited { sources, draft: None }, made, state);
    visited::step(app);
    // Scrolling has the browser lay the page out.
    browser::breathe().await;
    browser::scroll_to(0.0);
}

fn go_to_visited(app: App, visited: Visited, state: &str) {
    leave(app);
    open_visited(app, visited, state);
    visited::step(app);
    // Its diagnostics are also at the top.
    browser::scroll_to(0.0);
}

/// Opens a document written earlier in this browser.
pub fn open_kept(app: App, kept: Visited) {
    go_to_visited(app, kept, "");
    visited::note(app, None);
}

/// Opens another theory for the records being fitted. The step of the theory keeps its place in the window: the content above it
/// has its full height only when the browser has drawn it.
pub fn change_theory(app: App, sources: Vec<Source>) {
    let step = "theory-step";
    let before = browser::top_of(step);
    leave(app);
    open(app, sources, "");
    visited::step(app);
    if let (Some(before), Some(now)) = (before, browser::top_of(step)) {
        browser::scroll_to(browser::scrolled() + now - before);
    }
}

/// Saves the open document before it is replaced.
pub fn leave(app: App) {
    write::flush(app);
    saved::now(app);
}

/// Saves everything for the next visit whenever the page becomes hidden: the only moment that every browser reports.
pub fn save_when_left(app: App) {
    browser::listen("pagehide", move |_: &Event| leave(app));
    browser::listen("visibilitychange", move |_: &Event| {
        leave(app);
        // Visible again: the frames continue.
        app.page.wake();
    });
}
