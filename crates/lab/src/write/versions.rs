//! Versions of written documents: texts before a change, stored in the browser beside the draft.

use crate::app::App;
use crate::documents::visited;
use desk::superfluous_versions;
use document::page::{self, Source};
use js_sys::Date;
use units::order::sort_by_key;
use view::browser;

const PREFIX: &str = "version:";
/// Maximum number of versions of one document.
const MOST: usize = 50;
/// Maximum length of the versions of all documents together, in bytes; the rest of the storage is for records and
/// drafts.
const LONGEST: usize = 1_000_000;
/// Minimum age of the last version before a new one is made, in milliseconds.
const BETWEEN: f64 = 60_000.0;
/// Minimum pause in typing before a change that makes a new version, in milliseconds.
const REST: f64 = 15_000.0;

/// A stored version.
pub struct Version {
    key: String,
    /// Time at which it was made, in milliseconds.
    pub time: u64,
    /// Texts of the files.
    pub texts: Vec<String>,
}

/// Called before a change: stores the present text as a version if the conditions above are met.
pub fn before_change(app: App) {
    let now = Date::now();
    let times = app.with(|lab| {
        let before = lab.version_times;
        lab.version_times.change = now;
        before
    });
    if times.is_some_and(|times| now - times.version >= BETWEEN || now - times.change >= REST) {
        make(app);
    }
}

/// Stores the present text as a version, unless it equals the last one. Returns the name of the version with this text.
pub fn make(app: App) -> Option<String> {
    let document = document_key(app)?;
    let now = Date::now();
    app.with(|lab| lab.version_times.version = now);
    let files = visited::written(app);
    let mut versions = of_document(&document);
    let same = |version: &Version| version.texts.iter().eq(files.iter().map(|file| &file.text));
    if files.is_empty() {
        return None;
    }
    if let Some(last) = versions.pop_if(|last| same(last)) {
        return Some(last.key);
    }
    let key = format!("{document}{}", now as u64);
    browser::remember(&key, &page::write_list(&files));
    versions.push(Version { key: key.clone(), time: now as u64, texts: Vec::new() });
    let times: Vec<u64> = versions.iter().map(|version| version.time).collect();
    for place in superfluous_versions(&times, now as u64, MOST) {
        if let Some(version) = versions.get(place) {
            browser::forget(&version.key);
        }
    }
    make_room();
    Some(key)
}

/// Deletes the oldest versions of all documents until the total length is within the limit.
fn make_room() {
    let mut all = browser::all_remembered(PREFIX);
    let mut length: usize = all.iter().map(|(_, text)| text.len()).sum();
    sort_by_key(&mut all, |(key, _)| time_of(key));
    for (key, text) in all {
        if length <= LONGEST {
            return;
        }
        browser::forget(&key);
        length -= text.len();
    }
}

/// Stored versions of a draft: (key, text).
pub fn kept(draft: &str) -> Vec<(String, String)> {
    browser::all_remembered(&key_of(draft))
}

/// Key prefix of the versions of a draft.
fn key_of(draft: &str) -> String {
    format!("{PREFIX}{}:", draft.rsplit(':').next().unwrap_or_default())
}

fn document_key(app: App) -> Option<String> {
    app.with(|lab| lab.written_as.as_ref().map(|written| key_of(&written.name))).flatten()
}

fn time_of(key: &str) -> u64 {
    key.rsplit(':').next().and_then(|time| time.parse().ok()).unwrap_or(0)
}

/// Versions of the open document, the oldest first.
pub fn all(app: App) -> Vec<Version> {
    document_key(app).map_or_else(Vec::new, |document| of_document(&document))
}

/// Texts of the version with this name, if it belongs to the open document.
pub fn texts(app: App, key: &str) -> Option<Vec<String>> {
    let is_own = key.starts_with(&document_key(app)?);
    read(&browser::remembered(key).filter(|_| is_own)?)
}

fn read(list: &str) -> Option<Vec<String>> {
    Some(page::read_list(list)?.into_iter().map(|Source { text, .. }| text).collect())
}

/// Versions whose keys have this prefix, the oldest first.
fn of_document(document: &str) -> Vec<Version> {
    let version = |(key, text): (String, String)| Some(Version { time: time_of(&key), texts: read(&text)?, key });
    let mut versions: Vec<Version> = browser::all_remembered(document).into_iter().filter_map(version).collect();
    sort_by_key(&mut versions, |version| version.time);
    versions
}
