//! Tabs of the laboratory: their ids, and the tab shown after a reload.

use crate::app::App;
use view::browser;
use view::tabs::{ACTIVITIES, PLAY, THEORY};
use view::views::*;

/// Tab of records and cycles.
pub const MEASURE: &str = "measure";
/// Tab of fits.
pub const FIT: &str = "fit";
/// Tab of the editor.
pub const WRITE: &str = "write";

/// Storage key of the tab shown last.
const SHOWN: &str = "tab";

/// Restores the tab shown before a reload, and stores the present one from now on.
pub fn keep(app: App) {
    let shown = browser::remembered_in_tab(SHOWN);
    let all = [PLAY, ACTIVITIES, THEORY, MEASURE, FIT, WRITE];
    if let Some(tab) = all.into_iter().find(|tab| shown.as_deref() == Some(*tab)) {
        app.tab.set(tab);
    }
    effect(move || browser::remember_in_tab(SHOWN, app.tab.get()));
}
