//! Opening and closing of films.

use super::access::{Player, Source, Trouble};
use super::aim::{Kind, Tool};
use super::now::{now, refresh};
use super::refusals::said;
use super::{frames, tracking, words};
use crate::app::App;
use desk::{Desk, FilmIdentity, FilmOpening, FilmRecipe, FilmTruth, LengthsForm, Refusal};
use film::Plane;
use film::containers::Film;
use std::rc::Rc;
use view::panel::tabs;
use view::views::*;
use view::{browser, page::messages};
use web_sys::File;

/// File name endings of films, and of formats that users take for films.
const ENDINGS: [&str; 12] =
    [".mp4", ".m4v", ".mov", ".webm", ".mkv", ".avi", ".3gp", ".gif", ".wmv", ".flv", ".ts", ".ogv"];

/// Marks the page for the style sheet while a film is on the stage, and tracks the size of the window.
pub fn mark_page(app: App) {
    effect(move || {
        let told = app.films.story.with(Option::is_some);
        let shown = app.films.open.get() && app.films.shown.get() && !told;
        if let Some(root) = document().document_element() {
            let _ = root.class_list().toggle_with_force("with-film", shown);
            let _ = root.class_list().toggle_with_force("whole-film", shown && app.films.whole.get());
        }
    });
    effect(move || {
        let is_recorded = app.films.now.with(|now| now.as_ref().is_some_and(|now| now.record.is_some()));
        // Not while a click is awaited: the film would move away under the pointer.
        if is_recorded && app.films.tool.get() == Tool::Rest {
            app.films.whole.set(false);
        }
    });
    browser::listen("resize", move |_: &web_sys::Event| app.films.resized.update(|count| *count += 1));
}

/// True if a file is treated as a film.
pub fn is_film(file: &File) -> bool {
    let name = file.name().to_lowercase();
    file.type_().starts_with("video/") || ENDINGS.iter().any(|ending| name.ends_with(ending))
}

/// Opens a film in place of the open one.
pub fn open(app: App, file: File) {
    let name = file.name();
    if !app.read(|_| true) {
        return app.complain(words::of(app).no_document.to_owned());
    }
    forget_errors(app);
    app.films.opening.set(Some(name.clone()));
    app.tab.set(tabs::MEASURE);
    wasm_bindgen_futures::spawn_local(async move {
        let opened =
            take(app, file, |desk, identity, film| desk.change_films(|films, play| films.open(play, identity, film)))
                .await;
        app.films.opening.set(None);
        let words = words::of(app);
        match opened {
            Err(why) => app.complain(format!("{} {name}: {why}", words.not_opened)),
            Ok(FilmOpening::New) => app.say(format!("{} {name}", words.film)),
            Ok(FilmOpening::TakenUp) => app.notify(words.taken_up),
            Ok(FilmOpening::SameName) => app.notify(words.same_name),
        }
    });
}

/// Removes messages about other files.
fn forget_errors(app: App) {
    messages::forget(app.page, &messages::errors(app.page));
    app.record_refusal.set(None);
}

/// Reads the description of a film, opens it on the desk by `open`, and shows it.
///
/// # Errors
///
/// A message why that was not possible.
pub async fn take(
    app: App,
    file: File,
    open: impl FnOnce(&mut Desk, FilmIdentity, Film) -> Result<FilmOpening, Refusal>,
) -> Result<FilmOpening, String> {
    let source = Source::open(file).await.map_err(|trouble| said(app, &trouble))?;
    let start = source.beginning().await.map_err(|trouble| said(app, &trouble))?;
    let identity = FilmIdentity::new(&source.name(), source.bytes(), &start);
    let container = source.film.clone();
    let player = Player::new(Rc::new(source)).ok_or_else(|| said(app, &Trouble::Unreadable))?;
    let opened = app.act_on_desk(|desk| Some(open(desk, identity, container).map_err(|why| why.text(desk.play()))));
    let opening = opened.unwrap_or_else(|| Err(said(app, &Trouble::Closed)))?;
    show(app, player, opening);
    Ok(opening)
}

/// Opens a filmed simulation in place of the open film.
///
/// # Errors
///
/// A message why it could not be opened.
pub fn open_filmed(app: App, recipe: FilmRecipe, planes: Vec<Plane>, truth: FilmTruth) -> Result<FilmOpening, String> {
    forget_errors(app);
    let opened = app.act_on_desk(|desk| {
        let opening = desk
            .change_films(|films, play| films.open_filmed(play, recipe, planes.len(), truth))
            .map_err(|why| why.text(desk.play()));
        Some(opening.map(|opening| (opening, desk.films().current().map(|film| film.clip().container().clone()))))
    });
    let (opening, container) = opened.unwrap_or_else(|| Err(said(app, &Trouble::Closed)))?;
    let player = container.and_then(|film| Player::new(Rc::new(Source::drawn(film, planes))));
    show(app, player.ok_or_else(|| said(app, &Trouble::Closed))?, opening);
    Ok(opening)
}

/// Shows a film that the desk has opened, and continues earlier tracking.
fn show(app: App, player: Rc<Player>, opening: FilmOpening) {
    // Removes the views of the previous film first.
    app.films.open.set(false);
    app.with(|lab| lab.player = Some(player));
    begin(app);
    if opening == FilmOpening::TakenUp {
        tracking::take_up(app);
    }
}

/// Initializes the views for a film that the desk has opened.
fn begin(app: App) {
    let films = app.films;
    films.playing.set(false);
    films.truth.set(Vec::new());
    films.painted.set(None);
    films.frame.set(0);
    films.points.set(Vec::new());
    films.aim.set(None);
    films.last.set(None);
    films.selected.set(None);
    films.body.set(0);
    films.lengths_refused.set(None);
    films.intervals_refused.set(None);
    refresh(app);
    let now = now(app);
    let form = now.as_ref().map(|now| now.form.clone()).unwrap_or_default();
    let (mut ruler, mut corners) = (Vec::new(), Vec::new());
    match form.lengths {
        LengthsForm::Pixels => {}
        LengthsForm::Ruler { marks, length, intervals } => {
            ruler = marks.to_vec();
            films.length.set(length);
            films.intervals.set(intervals.to_string());
        }
        LengthsForm::Rectangle { corners: four, size } => {
            corners = four.to_vec();
            films.sides.set(size);
        }
    }
    films.ruler.set(ruler);
    films.corners.set(corners);
    let kind = now.as_ref().and_then(|now| Kind::of(&now.subject));
    films.tool.set(if kind.is_some() { Tool::Rest } else { Tool::Subject });
    films.kind.set(kind.unwrap_or_default());
    films.whole.set(now.as_ref().is_some_and(|now| now.record.is_none()));
    films.open.set(true);
    films.shown.set(true);
    frames::go(app, now.map_or(0, |now| now.ends[0]));
    browser::focus_later("film-frame".to_owned());
    wasm_bindgen_futures::spawn_local(async move {
        // Waits until the film is on the stage.
        browser::breathe().await;
        browser::bring_to_top("film-acts");
    });
}

/// Closes the film. The work on it is kept.
pub fn close(app: App) {
    app.films.open.set(false);
    app.films.shown.set(false);
    app.with(|lab| lab.player = None);
    app.act_on_desk(|desk| desk.change_films(|films, _| films.close()));
}
