//! Starting fits by a button: what has to be computed before is divided into tasks of the browser.

use super::{go_on, suitability};
use crate::app::App;
use crate::library;
use view::browser;
use view::views::*;

/// A button that fits the open document, or with `rank` every theory.
pub fn button_of(app: App, rank: bool) -> HtmlButton {
    let busy = memo(move || app.fit_progress.with(Option::is_some));
    let begin = move |_| {
        wasm_bindgen_futures::spawn_local(
            async move { if rank { start_ranking(app).await } else { start(app).await } },
        );
    };
    button().attr("aria-disabled", move || busy.get().to_string()).when(events::click, begin)
}

/// Fits the open document, as soon as it is known whether it can hold the record.
pub async fn start(app: App) {
    let (fit, opened) = (app.fit, opened(app));
    let press = fit.press();
    suitability::known(app).await;
    if fit.presses.get_untracked() != press || self::opened(app) != opened {
        return;
    }
    let objection = fit.objection();
    if objection.is_some() {
        return fit.refusal.set(objection);
    }
    fit.show(false);
    let file = app.with(|lab| lab.sources.first().map(|file| file.name.clone())).flatten().unwrap_or_default();
    fit.refusal.set(app.attempt_on_desk(|desk| desk.change_fits(|fits, data| fits.begin(data, &file))));
    go_on(app);
}

/// Documents that have been opened so far, and programs.
fn opened(app: App) -> (u64, u64) {
    (app.changes.document.get_untracked(), app.changes.program.get_untracked())
}

/// Opens the theories, one in each task, and fits them all, whatever document is opened meanwhile: the records are the same.
async fn start_ranking(app: App) {
    let fit = app.fit;
    let press = fit.press();
    fit.show(true);
    let mut theories = Vec::new();
    for entry in library::theories() {
        browser::breathe().await;
        theories.extend(entry.open().map(|document| (entry.file().to_owned(), document)));
    }
    browser::breathe().await;
    if fit.presses.get_untracked() == press {
        fit.refusal.set(app.attempt_on_desk(|desk| desk.change_fits(|fits, data| fits.begin_ranking(data, theories))));
        go_on(app);
    }
}
