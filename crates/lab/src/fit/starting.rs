//! Starting fits by a button: what has to be computed before is divided into tasks of the browser.

use super::go_on;
use super::theories::Suitability;
use crate::app::App;
use crate::library;
use view::browser;
use view::views::*;

/// Starting of fits, with what the views show about it.
#[derive(Clone, Copy)]
pub struct Starting {
    /// Number of fits that were started or cancelled: only the last wish counts.
    presses: Signal<u32>,
    /// Reason why the last fit was refused.
    pub refusal: Signal<Option<String>>,
    /// Id of the result that the user has chosen.
    pub chosen: Signal<Option<u32>>,
    /// Result shown unless the user chooses: the best one after a ranking, otherwise the last one.
    pub ranked: Signal<bool>,
}

impl Starting {
    /// Nothing has been started.
    pub fn new() -> Self {
        Self {
            presses: create_signal(0),
            refusal: create_signal(None),
            chosen: create_signal(None),
            ranked: create_signal(true),
        }
    }

    /// Drops what has not begun yet. Returns the number of the wish.
    pub fn press(self) -> u32 {
        self.presses.update(|count| *count += 1);
        self.presses.get_untracked()
    }

    /// Fits the open document, as soon as it is known whether it can hold the record.
    pub async fn fit(self, app: App, suitability: Suitability) {
        let press = self.press();
        if !suitability.known().await || self.presses.get_untracked() != press {
            return;
        }
        let objection = suitability.objection();
        if objection.is_some() {
            return self.refusal.set(objection);
        }
        self.show(false);
        let file = app.with(|lab| lab.sources.first().map(|file| file.name.clone())).flatten().unwrap_or_default();
        self.refusal.set(app.attempt_on_desk(|desk| desk.change_fits(|fits, data| fits.begin(data, &file))));
        go_on(app);
    }

    /// Opens the theories, one in each task, and fits them all.
    pub async fn rank(self, app: App) {
        let press = self.press();
        self.show(true);
        let mut theories = Vec::new();
        for entry in library::theories() {
            browser::breathe().await;
            theories.extend(entry.open().map(|document| (entry.file().to_owned(), document)));
        }
        browser::breathe().await;
        // The views may have been built again for another document; the records are the same.
        let is_shown = self.presses.is_alive();
        if is_shown && self.presses.get_untracked() != press {
            return;
        }
        let refused = app.attempt_on_desk(|desk| desk.change_fits(|fits, data| fits.begin_ranking(data, theories)));
        if is_shown {
            self.refusal.set(refused);
        }
        go_on(app);
    }

    fn show(self, ranked: bool) {
        self.ranked.set(ranked);
        self.chosen.set(None);
    }
}
