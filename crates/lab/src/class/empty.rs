//! Text of a section without content.

use super::words;
use crate::app::App;
use class::page;
use view::views::*;

/// A sentence in place of a content: how many hand-ins are computed, or that there is nothing.
pub fn nothing(app: App) -> View {
    let language = app.language.get_untracked();
    let progress = app.class.read_once(|collection| page::progress_text(collection, language));
    note(progress.unwrap_or_else(|| words::of(app).nothing.to_owned())).into()
}
