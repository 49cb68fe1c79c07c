//! Stores written documents in the browser, also after the tab is closed: a limited number of documents, each under the
//! time at which it was begun. Two open pages store different documents under different names.

use super::versions;
use crate::app::App;
use crate::documents::saved;
use crate::documents::stored::Kept;
use crate::documents::visited::{self, Visited};
use crate::library;
use play::Subject;
use units::order::sort_by_key;
use view::browser;

const PREFIX: &str = "written:";
/// Prefix of the key for the time of the last change, in milliseconds.
const CHANGED: &str = "changed:";
/// Maximum number of documents. Beyond it nothing is deleted automatically; the user decides.
const MOST: usize = 50;

/// A written document.
pub struct Document {
    /// Name in the storage.
    pub name: String,
    /// Time of the last change, in milliseconds.
    pub changed: u64,
    /// Title.
    pub title: String,
    /// Texts.
    pub kept: Visited,
}

/// Entries removed from the storage, for restoring them.
pub struct Removed(Vec<(String, String)>);

/// Determines the storage name of the document about to be changed: that of an identical stored document, otherwise a
/// new one.
pub fn begin(app: App) {
    if app.with(|lab| lab.written_as.is_some()) == Some(true) {
        return;
    }
    let text = visited::describe(app);
    let known = browser::all_remembered(PREFIX).into_iter().find(|(_, kept)| *kept == text);
    let name = known.map_or_else(new_name, |(name, _)| name);
    app.with(|lab| {
        lab.written_as = Some(Kept { name, text });
        // From now on, data are saved under the name of this document; data of the file or of the library stay.
        saved::begin_other(lab);
    });
}

/// Stored document that equals an opened one, if any.
pub fn find(opened: &Visited) -> Option<Kept> {
    if !matches!(library::subject(&opened.sources), Subject::File(_)) {
        return None;
    }
    let mut all = browser::all_remembered(PREFIX).into_iter();
    let (name, text) = all.find(|(_, text)| visited::read(text).as_ref() == Some(opened))?;
    Some(Kept { name, text })
}

/// An unused name. Names are times of equal length (for centuries), so that they sort by time.
fn new_name() -> String {
    let mut time = js_sys::Date::now() as u64;
    while browser::remembered(&format!("{PREFIX}{time}")).is_some() {
        time += 1;
    }
    format!("{PREFIX}{time}")
}

/// Stores the written text in the history entry and in the storage.
pub fn now(app: App) {
    let description = visited::describe(app);
    visited::note_described(&description);
    keep(app, description);
}

/// Stores the document, given by its description. If another page has changed the stored document meanwhile, that one
/// stays and this one is stored under a new name.
fn keep(app: App, text: String) {
    let Some(Kept { name, text: before }) = app.with(|lab| lab.written_as.clone()).flatten() else { return };
    let is_changed = browser::remembered(&name).is_some_and(|stored| stored != before);
    let name = if is_changed { new_name() } else { name };
    // Called at each change of a text, so the texts of the others are not read.
    let mut others = browser::remembered_keys(PREFIX);
    others.retain(|other| *other != name);
    if others.len() >= MOST && browser::remembered(&name).is_none() {
        if app.with(|lab| std::mem::replace(&mut lab.saved.is_full, true)) == Some(false) {
            app.complain(app.words().own_full.replace('#', &MOST.to_string()));
        }
        return;
    }
    app.with(|lab| lab.saved.is_full = false);
    if !browser::remember(&name, &text)
        && app.with(|lab| std::mem::replace(&mut lab.saved.refused, true)) == Some(false)
    {
        app.complain(app.words().not_saved.to_owned());
    }
    browser::remember(&changed_key(&name), &(js_sys::Date::now() as u64).to_string());
    app.with(|lab| lab.written_as = Some(Kept { name, text }));
}

fn changed_key(name: &str) -> String {
    format!("{CHANGED}{name}")
}

/// Time of the last change of a document, in milliseconds; 0 if it is not known.
fn changed(name: &str) -> u64 {
    browser::remembered(&changed_key(name)).and_then(|time| time.parse().ok()).unwrap_or(0)
}

/// Stored documents with titles in a language, the last changed first. Excludes texts that were changed back to those
/// of the library.
pub fn documents(language: &str) -> Vec<Document> {
    let read = |(name, text): (String, String)| {
        let kept = visited::read(&text)
            .filter(|kept| kept.draft.is_some() || matches!(library::subject(&kept.sources), Subject::File(_)))?;
        let entry = library::Entry { files: kept.files() };
        entry.files.first()?;
        let title = entry.title(language);
        Some(Document { changed: changed(&name), name, title, kept })
    };
    let mut documents: Vec<Document> = browser::all_remembered(PREFIX).into_iter().filter_map(read).collect();
    sort_by_key(&mut documents, |document| std::cmp::Reverse(document.changed));
    documents
}

/// Removes a document from the storage, with its versions, state and answers.
pub fn remove(name: &str) -> Removed {
    let own = [name.to_owned(), changed_key(name)].into_iter();
    let own = own.filter_map(|key| browser::remembered(&key).map(|text| (key, text)));
    let removed: Vec<(String, String)> = own.chain(versions::kept(name)).chain(saved::of_own(name)).collect();
    removed.iter().for_each(|(key, _)| browser::forget(key));
    Removed(removed)
}

/// Restores removed entries. Returns true if the browser has accepted them.
pub fn put_back(removed: &Removed) -> bool {
    removed.0.iter().all(|(key, text)| browser::remember(key, text))
}
