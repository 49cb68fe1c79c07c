//! What was written stays in the browser, also when the tab is closed: the latest documents, each under the time at which it was begun.
//! Two open pages write different documents under different names.

use super::versions;
use crate::app::App;
use crate::stored::Kept;
use crate::visited::{self, Visited};
use view::browser;

const PREFIX: &str = "written:";
/// More of them are not kept; the oldest go.
const MOST: usize = 50;

/// Finds the name for what is about to be written: that of the document as it is, if it was written before.
pub fn begin(app: App) {
    if app.with(|lab| lab.written_as.is_some()) == Some(true) {
        return;
    }
    let text = visited::describe(app);
    let known = browser::all_remembered(PREFIX).into_iter().find(|(_, kept)| *kept == text);
    let name = known.map_or_else(new_name, |(name, _)| name);
    app.with(|lab| lab.written_as = Some(Kept { name, text }));
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
    others.sort_unstable();
    let excess = (others.len() + 1).saturating_sub(MOST);
    for other in others.drain(..excess) {
        browser::forget(&other);
        versions::forget(&other);
    }
    if !browser::remember(&name, &text)
        && app.with(|lab| std::mem::replace(&mut lab.saved.refused, true)) == Some(false)
    {
        app.complain(app.words().not_saved.to_owned());
    }
    app.with(|lab| lab.written_as = Some(Kept { name, text }));
}

/// What was written, the latest first, with its title.
pub fn documents() -> Vec<(String, Visited)> {
    let mut kept = browser::all_remembered(PREFIX);
    kept.sort_unstable_by(|one, other| other.0.cmp(&one.0));
    let titled = |(_, text): (String, String)| {
        let kept = visited::read(&text)?;
        let title = document::card(&kept.sources.first()?.text).title;
        Some((title, kept))
    };
    kept.into_iter().filter_map(titled).collect()
}
