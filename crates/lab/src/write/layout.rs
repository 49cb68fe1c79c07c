//! Button that formats the document in the standard layout.

use super::draft::flush;
use super::{Panel, typing};
use crate::app::App;
use view::views::*;

/// The button, visible while the text is shown.
pub fn view(app: App) -> HtmlButton {
    let words = app.words();
    button()
        .class("quiet outlined")
        .id("format-writing")
        .title(words.format_writing_title)
        .hidden(move || app.writing_panel.get() != Panel::Text)
        .when(events::click, move |_| format(app))
        .child(words.format_writing)
}

/// Formats the file shown; can be undone.
fn format(app: App) {
    flush(app);
    let (file, words) = (app.written_file.get_untracked(), app.words());
    let text = typing::text(app, file);
    let mut keeps_faults = false;
    let changed = typing::act(app, file, &text, |outline| {
        let formatted = document::format(outline);
        keeps_faults = !formatted.left.is_empty();
        Ok(formatted.edits)
    });
    match changed {
        Ok(_) if keeps_faults => app.notify(words.format_left),
        Ok(edits) if edits.is_empty() => app.notify(words.format_nothing),
        Ok(_) => app.notify(words.formatted),
        Err(refusal) => app.complain(refusal),
    }
}
