//! What was written stays in the browser, also when the tab is closed: the latest documents, each under the time at which it was begun.
//! Two open pages write different documents under different names.

use crate::app::App;
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
    let present = visited::describe(app);
    let known = browser::all_remembered(PREFIX).into_iter().find(|(_, text)| *text == present);
    // Of the same length for centuries, so that names stand in the order of time.
    let name = known.map_or_else(|| format!("{PREFIX}{}", js_sys::Date::now() as u64), |(name, _)| name);
    app.with(|lab| lab.written_as = Some(name));
}

/// Keeps the document as it stands in the editor.
pub fn keep(app: App) {
    let Some(name) = app.with(|lab| lab.written_as.clone()).flatten() else { return };
    let text = visited::describe(app);
    let mut others: Vec<String> = browser::all_remembered(PREFIX).into_iter().map(|(name, _)| name).collect();
    others.retain(|other| *other != name);
    others.sort_unstable();
    let excess = (others.len() + 1).saturating_sub(MOST);
    others.drain(..excess).for_each(|other| browser::forget(&other));
    if !browser::remember(&name, &text)
        && app.with(|lab| std::mem::replace(&mut lab.saved.refused, true)) == Some(false)
    {
        app.complain(app.words().not_saved.to_owned());
    }
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
