//! First things to do, on the opening document: the guided start, a film of one's own.

use crate::app::App;
use crate::{documents::visited, film, guide, library};
use play::Subject;
use view::page::welcome::{FILM, GUIDE, OPENING, SEE_IN_LINE};
use view::views::*;
use view::{browser, page::welcome, panel::tabs};
use web_sys::HtmlElement;

/// True if the document is the one with which the laboratory opens. Tracked.
fn is_opening(app: App) -> bool {
    app.changes.program.track();
    let sources = visited::sources(app);
    library::subject_of_state(&sources) == Subject::Library(OPENING.to_owned())
}

/// Door to the sample film, on the first screen of the opening document.
pub fn door(app: App) -> View {
    let stands = memo(move || {
        app.records.track();
        let is_empty = app.read_desk(|desk| desk.records().list().is_empty());
        is_empty && is_opening(app) && app.tab.get() == tabs::EXPLORE && !app.films.open.get()
    });
    changing(move || match stands.get() {
        true => welcome::door(app.page, move || film::see_measured(app)).into(),
        false => View::new(),
    })
}

/// The line in the header; empty unless the document is the one with which the laboratory opens.
pub fn view(app: App) -> View {
    let is_opening = memo(move || is_opening(app));
    let is_guided = memo(move || app.guide.with(Option::is_some));
    effect(move || {
        if is_opening.get() {
            welcome::end_first_visit();
        } else {
            app.guide.set(None);
        }
    });
    let line = move || welcome::line(app.page, app.is_first_visit.get(), move |id| press(app, id)).into();
    changing(move || match (is_opening.get(), is_guided.get()) {
        (false, _) => View::new(),
        (true, false) => line(),
        (true, true) => guide::view(app).into(),
    })
}

fn press(app: App, id: &str) {
    match id {
        GUIDE => {
            app.is_first_visit.set(false);
            guide::begin(app);
        }
        SEE_IN_LINE => film::see_measured(app),
        FILM => own_film(app),
        _ => {}
    }
}

/// Opens the tab with the film that is open, or otherwise a chooser for one.
fn own_film(app: App) {
    app.tab.set(tabs::MEASURE);
    let is_open = app.films.open.get_untracked();
    browser::reveal_later(if is_open { "film-acts" } else { "choose-record" }.to_owned());
    if !is_open && let Some(chooser) = browser::by_id::<HtmlElement>("record-file") {
        chooser.click();
    }
}
