//! Storage for the next visit: the state of each document in the format of a link, and records, fits and answers as
//! items ([`desk::Item`]). Other pages of this site share the storage: see [`desk::Shelf`].

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

/// Key prefix of document states.
const STATE: &str = "state:";
/// Key prefix of documents written here.
const OWN: &str = "own:";

/// Delay of saving after a change, in milliseconds; all changes until then are saved together.
const DELAY: i32 = 300;

/// Storage key of a document: from its file and title or, if written here, from the name under which it is stored. Own
/// documents are separate from those of the page, whose state a link from a stranger could otherwise replace.
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

/// Storage key of the open document.
pub fn key(lab: &Lab) -> Option<String> {
    lab.desk.as_ref().map(|desk| document_key(&lab.sources, lab.written_as.as_ref(), desk))
}

/// State in which the open document was left.
pub fn state(app: App) -> String {
    let key = app.with(|lab| key(lab)).flatten();
    key.and_then(|key| browser::remembered(&format!("{STATE}{key}"))).unwrap_or_default()
}

/// Called when the open document gets another storage key. Data under the former key stay.
pub fn begin_other(lab: &mut Lab) {
    lab.saved.answers = Shelf::default();
}

/// Called when the storage key of the open document may have changed from `before`: a text can become equal to that of
/// the library.
pub fn rename(lab: &mut Lab, before: Option<String>) {
    if before.is_some() && key(lab) != before {
        begin_other(lab);
    }
}

/// Stored data of a document written here, by its name: state and answers, as (key, text).
pub fn of_own(name: &str) -> Vec<(String, String)> {
    let key = own_key(name);
    let state = format!("{STATE}{key}");
    let kept = browser::remembered(&state).map(|text| (state, text));
    kept.into_iter().chain(browser::all_remembered(&answers_of(&key))).collect()
}

/// Restores records, films and fits. Returns the number of records for which there was no room.
pub fn restore_measured(saved: &mut Saved, desk: &mut Desk) -> usize {
    let records = saved
        .records
        .read(stored(RECORDS, "records"), |_, item| desk.restore_record(item).map(|name| format!("{RECORDS}{name}")));
    // After the records, to which some of them belong.
    let films = browser::all_remembered(FILMS);
    saved.films.read(films, |_, item| desk.restore_film(item).map(|name| format!("{FILMS}{name}")));
    let fits =
        saved.fits.read(stored(FITS, "fits"), |_, item| desk.restore_fit(item).map(|name| format!("{FITS}{name}")));
    if records.refused.is_empty() && records.unreadable.is_empty() {
        // The record of a fit that cannot be restored was removed in another page.
        fits.refused.iter().for_each(|key| browser::forget(key));
    }
    records.refused.len()
}

/// Stored items of a kind, including the single entry of the first versions.
fn stored(prefix: &str, key: &str) -> Vec<(String, String)> {
    let together = browser::remembered(key).map(|text| (key.to_owned(), text));
    together.into_iter().chain(browser::all_remembered(prefix)).collect()
}

/// Restores the answers to the questions of an opened document.
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

/// Saves after a delay; further changes until then are included.
pub fn later(app: App) {
    if app.with(|lab| std::mem::replace(&mut lab.saved.is_due, true)) == Some(false) {
        let save = Closure::once_into_js(move || now(app));
        let _ = window().set_timeout_with_callback_and_timeout_and_arguments_0(save.unchecked_ref(), DELAY);
    }
}

/// Saves everything. A refusal by the browser is reported once.
pub fn now(app: App) {
    if app.with(save) == Some(true) {
        app.complain(app.words().not_saved.to_owned());
    }
}

/// Saves everything. Returns true if a refusal must be reported.
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
