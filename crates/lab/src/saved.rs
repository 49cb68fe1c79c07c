//! What is there again at the next visit: the state of each document as a link would have it, and records, fits and answers
//! as items ([`desk::Item`]). Other pages of this site share the storage: see [`desk::Shelf`].

use crate::app::{App, Lab};
use crate::library;
use crate::stored::{Kept, Saved};
use desk::{Change, Desk, Item, Shelf};
use document::page::Source;
use play::Subject;
use view::browser;
use view::views::window;
use wasm_bindgen::JsCast;
use wasm_bindgen::closure::Closure;

const RECORDS: &str = "record:";
const FITS: &str = "fit:";
const FILMS: &str = "film:";

/// What the state of a document is stored under begins with.
const STATE: &str = "state:";
/// What the names of documents that are written here begin with.
const OWN: &str = "own:";

/// Changes are saved so many milliseconds later, all of them at once.
const DELAY: i32 = 300;

/// A document's name in the storage: by its file and title, one that is written here by the name under which it is kept. Own
/// documents keep apart from those of the page, which a link from a stranger could otherwise give another state.
fn document_key(sources: &[Source], written_as: Option<&Kept>, desk: &Desk) -> String {
    let (name, title) = (sources.first().map_or("", |file| &file.name), &desk.document().program.title);
    match written_as {
        _ if !matches!(library::subject(sources), Subject::File(_)) => format!("{name}:{title}"),
        Some(Kept { name, .. }) => own_key(name),
        None => desk::own_document_key(name, title),
    }
}

fn own_key(name: &str) -> String {
    format!("{OWN}{name}")
}

/// The name of the open document in the storage.
pub fn key(lab: &Lab) -> Option<String> {
    lab.desk.as_ref().map(|desk| document_key(&lab.sources, lab.written_as.as_ref(), desk))
}

/// The state in which a document was left.
pub fn state(app: App) -> String {
    let key = app.with(|lab| key(lab)).flatten();
    key.and_then(|key| browser::remembered(&format!("{STATE}{key}"))).unwrap_or_default()
}

/// The open document has another name in the storage from now on. What is stored under the former one stays there.
pub fn begin_other(lab: &mut Lab) {
    lab.saved.answers = Shelf::default();
}

/// The open document had the name `before` in the storage and may have another now: a text may become that of the library.
pub fn rename(lab: &mut Lab, before: Option<String>) {
    if before.is_some() && key(lab) != before {
        begin_other(lab);
    }
}

/// What is stored of a document that is written here, by its name: its state and its answers.
pub fn of_own(name: &str) -> Vec<(String, String)> {
    let key = own_key(name);
    let state = format!("{STATE}{key}");
    let kept = browser::remembered(&state).map(|text| (state, text));
    kept.into_iter().chain(browser::all_remembered(&answers_of(&key))).collect()
}

/// Brings back records and fits. How many records there was no room for.
pub fn restore_measured(saved: &mut Saved, desk: &mut Desk) -> usize {
    let records = saved
        .records
        .read(stored(RECORDS, "records"), |_, item| desk.restore_record(item).map(|name| format!("{RECORDS}{name}")));
    // After the records, which belong to some of them.
    let films = browser::all_remembered(FILMS);
    saved.films.read(films, |_, item| desk.restore_film(item).map(|name| format!("{FILMS}{name}")));
    let fits =
        saved.fits.read(stored(FITS, "fits"), |_, item| desk.restore_fit(item).map(|name| format!("{FITS}{name}")));
    if records.refused.is_empty() && records.unreadable.is_empty() {
        // A fit that cannot be made again has lost its record, in another page.
        fits.refused.iter().for_each(|key| browser::forget(key));
    }
    records.refused.len()
}

/// The items of a kind, and what the first versions kept of all of them under one key.
fn stored(prefix: &str, key: &str) -> Vec<(String, String)> {
    let together = browser::remembered(key).map(|text| (key.to_owned(), text));
    together.into_iter().chain(browser::all_remembered(prefix)).collect()
}

/// Brings back the answers to the questions of a document that has been opened.
pub fn restore_answers(saved: &mut Saved, sources: &[Source], written_as: Option<&Kept>, desk: &mut Desk) {
    let prefix = answers_of(&document_key(sources, written_as, desk));
    saved.answers = Shelf::default();
    saved.answers.read(browser::all_remembered(&prefix), |key, item| {
        let question = key.strip_prefix(&prefix).unwrap_or_default();
        desk.restore_answer(question, item).then(|| key.to_owned())
    });
}

fn answers_of(document: &str) -> String {
    format!("answer:{document}:")
}

/// Saves soon: what changes again until then is saved once.
pub fn later(app: App) {
    if app.with(|lab| std::mem::replace(&mut lab.saved.is_due, true)) == Some(false) {
        let save = Closure::once_into_js(move || now(app));
        let _ = window().set_timeout_with_callback_and_timeout_and_arguments_0(save.unchecked_ref(), DELAY);
    }
}

/// Saves everything. What the browser refuses to store is said once.
pub fn now(app: App) {
    if app.with(save) == Some(true) {
        app.complain(app.words().not_saved.to_owned());
    }
}

/// Whether it has to be said that something was refused.
fn save(lab: &mut Lab) -> bool {
    let Lab { desk: Some(desk), saved, sources, written_as, .. } = lab else { return false };
    saved.is_due = false;
    let key = document_key(sources, written_as.as_ref(), desk);
    let mut stored = browser::remember(&format!("{STATE}{key}"), &desk.play().share());
    let now = js_sys::Date::now() as u64;
    for (shelf, prefix, items) in [
        (&mut saved.records, RECORDS.to_owned(), desk.saved_records()),
        (&mut saved.films, FILMS.to_owned(), desk.saved_films()),
        (&mut saved.fits, FITS.to_owned(), desk.saved_fits()),
        (&mut saved.answers, answers_of(&key), desk.saved_answers()),
    ] {
        let items: Vec<(String, Item)> =
            items.into_iter().map(|(name, item)| (format!("{prefix}{name}"), item)).collect();
        for change in shelf.keep(items, now, |key| browser::remembered(key).is_some()) {
            match change {
                Change::Write(key, text) if !browser::remember(&key, &text) => {
                    shelf.has_failed(&key);
                    stored = false;
                }
                Change::Write(..) => {}
                Change::Remove(key) => browser::forget(&key),
            }
        }
    }
    !stored && !std::mem::replace(&mut saved.refused, true)
}
