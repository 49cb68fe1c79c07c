//! What was written stays in the browser, also when the tab is closed: a limited number of documents, each under the time at which it was begun.
//! Two open pages write different documents under different names.

use super::versions;
use crate::app::App;
use crate::library;
use crate::saved;
use crate::stored::Kept;
use crate::visited::{self, Visited};
use play::Subject;
use view::browser;

const PREFIX: &str = "written:";
/// What stands before the name of a document where the time of its last change is kept, in milliseconds.
const CHANGED: &str = "changed:";
/// More of them are not kept: a person decides which one goes.
const MOST: usize = 50;

/// A document that was written.
pub struct Document {
    /// Its name in the storage.
    pub name: String,
    /// When it was changed last, in milliseconds.
    pub changed: u64,
    /// What it is called.
    pub title: String,
    /// Its texts.
    pub kept: Visited,
}

/// What was removed from the storage, to be put back.
pub struct Removed(Vec<(String, String)>);

/// Finds the name for what is about to be written: that of the document as it is, if it was written before.
pub fn begin(app: App) {
    if app.with(|lab| lab.written_as.is_some()) == Some(true) {
        return;
    }
    let text = visited::describe(app);
    let known = browser::all_remembered(PREFIX).into_iter().find(|(_, kept)| *kept == text);
    let name = known.map_or_else(new_name, |(name, _)| name);
    app.with(|lab| {
        lab.written_as = Some(Kept { name, text });
        // What is saved from now on has the name of this document; what is saved of the file or of the library stays there.
        saved::begin_other(lab);
    });
}

/// The document of the storage that is opened here, if it is one.
pub fn find(opened: &Visited) -> Option<Kept> {
    if !matches!(library::subject(&opened.sources), Subject::File(_)) {
        return None;
    }
    let mut all = browser::all_remembered(PREFIX).into_iter();
    let (name, text) = all.find(|(_, text)| visited::read(text).as_ref() == Some(opened))?;
    Some(Kept { name, text })
}

/// A name that no document has. Names have the same length for centuries, so that they stand in the order of time.
fn new_name() -> String {
    let mut time = js_sys::Date::now() as u64;
    while browser::remembered(&format!("{PREFIX}{time}")).is_some() {
        time += 1;
    }
    format!("{PREFIX}{time}")
}

/// Keeps what was written: in the step of the history and in the storage.
pub fn now(app: App) {
    let description = visited::describe(app);
    visited::note_described(&description);
    keep(app, description);
}

/// Keeps the document as it stands in the editor, by its description. Where another page has changed it in the storage meanwhile, that stays, and this
/// one is kept beside it.
fn keep(app: App, text: String) {
    let Some(Kept { name, text: before }) = app.with(|lab| lab.written_as.clone()).flatten() else { return };
    let is_changed = browser::remembered(&name).is_some_and(|stored| stored != before);
    let name = if is_changed { new_name() } else { name };
    // At each change of a text: the texts of the others are not read.
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

/// When a document was changed last; of one that an earlier version of the page has kept, when it was begun.
fn changed(name: &str) -> u64 {
    let known = browser::remembered(&changed_key(name)).and_then(|time| time.parse().ok());
    known.or_else(|| name.strip_prefix(PREFIX)?.parse().ok()).unwrap_or(0)
}

/// What was written, with titles in a language, what was changed last first. A text that was changed back into that of the library is not among it.
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
    documents.sort_by_key(|document| std::cmp::Reverse(document.changed));
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

/// Puts back what was removed. Whether the browser has taken it.
pub fn put_back(removed: &Removed) -> bool {
    removed.0.iter().all(|(key, text)| browser::remember(key, text))
}
