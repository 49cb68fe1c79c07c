//! Storage for the next visit: the state of each document in the format of a link, and records, films, fits and answers
//! ([`desk::Visit`]). Other pages of this site share the storage.

use crate::app::{App, Lab};
use crate::documents::stored::{Kept, Saved};
use crate::library;
use desk::saved::own_document_key;
use desk::{Desk, Visit};
use document::page::Source;
use play::Subject;
use view::browser;
use view::views::window;
use wasm_bindgen::JsCast;
use wasm_bindgen::closure::Closure;

/// Key prefix of documents written here.
const OWN: &str = "own:";

/// Delay of saving after a change, in milliseconds; all changes until then are saved together.
const DELAY: i32 = 300;

/// The local storage of the browser.
pub struct Storage;

impl desk::saved::Storage for Storage {
    fn get(&self, key: &str) -> Option<String> {
        browser::remembered(key)
    }

    fn keys(&self, prefix: &str) -> Vec<String> {
        browser::remembered_keys(prefix)
    }

    fn set(&mut self, key: &str, text: &str) -> bool {
        browser::remember(key, text)
    }

    fn remove(&mut self, key: &str) {
        browser::forget(key);
    }
}

/// Storage key of a document: from its file and title or, if written here, from the name under which it is stored. Own
/// documents are separate from those of the page, whose state a link from a stranger could otherwise replace.
fn document_key(sources: &[Source], written_as: Option<&Kept>, desk: &Desk) -> String {
    let (name, title) = (sources.first().map_or("", |file| &file.name), &desk.document().program.title);
    match written_as {
        _ if !matches!(library::subject(sources), Subject::File(_)) => format!("{name}:{title}"),
        Some(Kept { name, .. }) => own_key(name),
        None => own_document_key(name, title),
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
    key.map(|key| Visit::state(&Storage, &key)).unwrap_or_default()
}

/// Called when the open document gets another storage key. Data under the former key stay.
pub fn begin_other(lab: &mut Lab) {
    lab.saved.visit.leave_document();
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
    desk::document_data(&Storage, &own_key(name))
}

/// Restores records, films and fits. Returns the number of records for which there was no room.
pub fn restore_measured(saved: &mut Saved, desk: &mut Desk) -> usize {
    saved.visit.restore_measured(desk, &mut Storage)
}

/// Restores the answers to the questions of an opened document.
pub fn restore_answers(saved: &mut Saved, sources: &[Source], written_as: Option<&Kept>, desk: &mut Desk) {
    let key = document_key(sources, written_as, desk);
    saved.visit.restore_answers(desk, &Storage, &key);
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
    let is_stored = saved.visit.save(desk, &mut Storage, &key, js_sys::Date::now() as u64);
    !is_stored && !std::mem::replace(&mut saved.refused, true)
}
