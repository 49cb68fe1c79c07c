//! Help for the word under the cursor: its meaning, the kind of quantity, and the typeset statement. It stands below
//! the text and is not announced.

use super::{Panel, imported, typing};
use crate::app::App;
use desk::Insight;
use document::form::CellKind;
use view::views::*;
use wasm_bindgen::JsCast;
use wasm_bindgen::closure::Closure;

/// Delay after the last cursor move in a form, in milliseconds; the same as in the editor.
const REST: i32 = 150;

/// Updates the help for a place of a text, in UTF-16 units.
pub fn look(app: App, text: &str, place: usize) {
    let found = app.with(|lab| {
        let program = lab.desk.as_ref().map(|desk| desk.play().program());
        desk::insight(text, program, place)
    });
    let found = found.unwrap_or_default();
    if app.insight.with_untracked(|known| *known != found) {
        app.insight.set(found);
    }
}

/// Updates the help for a place of a cell, in UTF-16 units from its start, after the delay.
pub fn look_at_cell(app: App, number: usize, kind: CellKind, place: usize) {
    let turn = app.resting.get_untracked() + 1;
    app.resting.set(turn);
    let act = move || {
        if app.resting.get_untracked() != turn {
            return;
        }
        let text = typing::text(app, 0);
        let form = document::form::places(&document::read(&text));
        if let Some(cell) = form.parts.get(number).and_then(|part| part.cell(kind)) {
            let before = text.get(..cell.span.start).unwrap_or_default();
            look(app, &text, before.encode_utf16().count() + place.min(cell.text.encode_utf16().count()));
        }
    };
    let act = Closure::once_into_js(act);
    let _ = window().set_timeout_with_callback_and_timeout_and_arguments_0(act.unchecked_ref(), REST);
}

/// The line with the help.
pub fn view(app: App) -> HtmlDiv {
    let line = move || {
        let Insight { word, typeset } = app.insight.get_clone();
        let (words, language) = (app.words(), app.language.get_untracked());
        if word.is_none() && typeset.is_empty() {
            return View::from(span().class("hush").child(words.insight_none));
        }
        let original = word.as_ref().and_then(|(word, _)| imported::original(app, word));
        let word = word.map(|(word, found)| {
            let dimension = found.dimension.map(|dimension| format!(" ({})", dimension.text(language)));
            let meaning = format!(": {}{}", found.meaning.text(language), dimension.unwrap_or_default());
            span().class("meaning").child(code().child(word)).child(meaning)
        });
        let typeset = (!typeset.is_empty()).then(|| span().class("typeset").inner_html(typeset));
        span().class("insight-line").maybe(word).maybe(typeset).maybe(original).into()
    };
    div()
        .class("insight")
        .id("insight")
        .role("group")
        .hidden(move || !matches!(app.writing_panel.get(), Panel::Text | Panel::Model))
        .tabindex("0")
        .attr("aria-label", app.words().insight)
        .child(changing(line))
}
