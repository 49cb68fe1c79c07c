//! Ids of the tabs, and the tab shown after a reload.

use crate::app::App;
use crate::browser;
use crate::views::*;

/// Tab of parameters, presets and values.
pub const PLAY: &str = "play";
/// Tab of the questions.
pub const ACTIVITIES: &str = "activities";
/// Tab of prose and equations.
pub const THEORY: &str = "theory";
/// Tab of records and cycles, in the laboratory.
pub const MEASURE: &str = "measure";
/// Tab of fits, in the laboratory.
pub const FIT: &str = "fit";
/// Tab of the editor, in the laboratory.
pub const WRITE: &str = "write";

/// Storage key of the tab shown last.
const SHOWN: &str = "tab";

/// Restores the tab of the laboratory that was shown before a reload, and stores the present one from now on.
pub fn keep(app: App) {
    if let Some(tab) = browser::remembered_in_tab(SHOWN).and_then(|shown| find(&shown)) {
        app.tab.set(tab);
    }
    effect(move || browser::remember_in_tab(SHOWN, app.tab.get()));
}

/// The tab with this id.
pub fn find(id: &str) -> Option<&'static str> {
    [PLAY, ACTIVITIES, THEORY, MEASURE, FIT, WRITE].into_iter().find(|tab| *tab == id)
}
