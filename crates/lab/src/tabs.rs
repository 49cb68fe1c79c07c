//! The tabs of the laboratory: their names, and which one is shown after the page has been loaded again.

use crate::app::App;
use view::browser;
use view::tabs::{ACTIVITIES, PLAY, THEORY};
use view::views::*;

/// The tab of records and cycles.
pub const MEASURE: &str = "measure";
/// The tab of fits.
pub const FIT: &str = "fit";
/// The tab of the editor.
pub const WRITE: &str = "write";

/// The key of the tab that was shown last.
const SHOWN: &str = "tab";

/// Shows the tab that was shown before the page was loaded again, and remembers from now on which one is shown.
pub fn keep(app: App) {
    let shown = browser::remembered_in_tab(SHOWN);
    let all = [PLAY, ACTIVITIES, THEORY, MEASURE, FIT, WRITE];
    if let Some(tab) = all.into_iter().find(|tab| shown.as_deref() == Some(*tab)) {
        app.tab.set(tab);
    }
    effect(move || browser::remember_in_tab(SHOWN, app.tab.get()));
}
