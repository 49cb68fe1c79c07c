//! Films in the page: decoding, the film on the stage, and what a person says of it in the panel. What is found in a film is the
//! desk's business.

mod codecs;
mod decoder;
mod doubts;
mod picture;
mod player;
mod source;
pub mod stage;
mod trouble;
mod words;

pub use player::Player;

use crate::app::App;
use crate::tabs;
use source::Source;
use std::rc::Rc;
use trouble::Trouble;
use view::views::*;
use web_sys::File;
use words::Words;

/// Endings of the names of films, and of what is taken for one.
const ENDINGS: [&str; 12] =
    [".mp4", ".m4v", ".mov", ".webm", ".mkv", ".avi", ".3gp", ".gif", ".wmv", ".flv", ".ts", ".ogv"];

/// What views of the film track.
#[derive(Clone, Copy)]
pub struct Films {
    /// Whether a film is open.
    pub open: Signal<bool>,
    /// Whether it stands on the stage, in the place of the scene.
    pub shown: Signal<bool>,
    /// The frame that is looked at.
    pub frame: Signal<usize>,
    /// The frame that is painted: the other one, a moment later.
    pub painted: Signal<Option<usize>>,
    /// The file that is being opened.
    pub opening: Signal<Option<String>>,
}

impl Films {
    /// Without a film.
    pub fn new() -> Self {
        Self {
            open: create_signal(false),
            shown: create_signal(false),
            frame: create_signal(0),
            painted: create_signal(None),
            opening: create_signal(None),
        }
    }

    /// The words of films, without tracking.
    pub fn words(self, app: App) -> &'static Words {
        words::words_in(app.language.get_untracked())
    }
}

/// Marks the page while a film stands on the stage, for the style sheet.
pub fn mark_page(app: App) {
    effect(move || {
        let shown = app.films.open.get() && app.films.shown.get();
        if let Some(root) = document().document_element() {
            let _ = root.class_list().toggle_with_force("with-film", shown);
        }
    });
}

/// Whether a file is taken for a film.
pub fn is_film(file: &File) -> bool {
    let name = file.name().to_lowercase();
    file.type_().starts_with("video/") || ENDINGS.iter().any(|ending| name.ends_with(ending))
}

/// What went wrong, in words.
fn said(app: App, trouble: &Trouble) -> String {
    trouble.words().text(app.language.get_untracked()).to_owned()
}

/// Opens a film in place of the one that is open.
pub fn open(app: App, file: File) {
    let name = file.name();
    app.films.opening.set(Some(name.clone()));
    app.tab.set(tabs::MEASURE);
    wasm_bindgen_futures::spawn_local(async move {
        let opened = take(app, file).await;
        app.films.opening.set(None);
        if let Err(why) = opened {
            app.complain(format!("{} {name}: {why}", app.films.words(app).not_opened));
        }
    });
}

async fn take(app: App, file: File) -> Result<(), String> {
    let source = Source::open(file).await.map_err(|trouble| said(app, &trouble))?;
    let player = Player::new(Rc::new(source)).ok_or_else(|| said(app, &Trouble::Unreadable))?;
    // What showed the film before goes first.
    app.films.open.set(false);
    app.with(|lab| lab.player = Some(player));
    app.films.painted.set(None);
    app.films.open.set(true);
    app.films.shown.set(true);
    go(app, 0);
    Ok(())
}

/// Goes to a frame, or to the last one.
pub fn go(app: App, frame: usize) {
    let Some(player) = app.with(|lab| lab.player.clone()).flatten() else { return };
    let frame = frame.min(player.source.count().saturating_sub(1));
    if app.films.frame.get_untracked() != frame {
        app.films.frame.set(frame);
    }
    player.show(app, frame);
}

/// Goes on by so many frames.
fn step(app: App, by: isize) {
    go(app, app.films.frame.get_untracked().saturating_add_signed(by));
}
