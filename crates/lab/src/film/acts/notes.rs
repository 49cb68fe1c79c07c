//! Notes on the film: file, times, camera and scale.

use crate::app::App;
use view::views::*;

/// List of the notes.
pub fn view(app: App) -> View {
    let notes = memo(move || app.films.now.with(|now| now.as_ref().map(|now| now.notes.clone()).unwrap_or_default()));
    changing(move || ul().class("film-notes").id("film-notes").each(notes.get_clone(), |note| li().child(note)))
}
