//! Diagnostics of the texts: marked in the editor, counted in a line, and listed with reasons and remedies.

use super::{Editor, Panel, panels};
use crate::app::App;
use crate::documents::diagnostics::{self, Leads};
use crate::documents::visited;
use desk::Writing;
use model::Fix;
use std::rc::Rc;
use view::browser;
use view::views::*;

/// Marks the diagnostics in the text shown.
pub fn mark(app: App) {
    let file = app.written_file.get_untracked();
    let marks = app.read_writing(|writing| writing.marks(file));
    if let Some(editor) = app.with(|lab| lab.editor.clone()).flatten() {
        editor.mark(&marks, app.language.get_untracked());
    }
}

/// Number of errors and remarks, and whether the text runs.
pub fn summary(app: App) -> String {
    let words = app.words();
    let (errors, all, runs) = app.read_writing(|writing| (writing.errors(), writing.findings().len(), writing.runs()));
    let count = |number: usize, one: &str, many: &str| match number {
        1 => format!("1 {one}"),
        number => format!("{number} {many}"),
    };
    let mut found = Vec::new();
    if errors > 0 {
        found.push(count(errors, words.one_error, words.many_errors));
    }
    if all > errors {
        found.push(count(all - errors, words.one_warning, words.many_warnings));
    }
    let nothing_runs = format!("{}.", words.nothing_runs);
    let state = match (runs, app.read(|_| true)) {
        (true, _) if errors > 0 => words.text_runs_in_part,
        (true, _) => words.text_runs,
        (false, true) => words.text_waits,
        (false, false) => &nothing_runs,
    };
    if found.is_empty() { state.to_owned() } else { format!("{}. {state}", found.join(", ")) }
}

/// Status of the text, visible and for screen readers.
pub fn status(app: App) -> HtmlP {
    let errors = move || {
        app.written.track();
        app.read_writing(Writing::errors)
    };
    let sentence = move || {
        app.written.track();
        summary(app)
    };
    let class = move || if errors() > 0 { "writing-status faulty" } else { "writing-status" };
    p().class(class).role("status").id("writing-status").child(text(sentence))
}

/// Button that leads to the list of errors from elsewhere; hidden while there are none.
pub fn lead(app: App) -> HtmlButton {
    let words = app.words();
    let errors = memo(move || {
        app.written.track();
        app.read_writing(|writing| writing.errors())
    });
    let title = move || match errors.get() {
        1 => words.show_error.to_owned(),
        number => words.show_errors.replace('#', &number.to_string()),
    };
    button()
        .class("quiet outlined")
        .id("show-errors")
        .hidden(move || errors.get() == 0)
        .when(events::click, move |_| browser::reveal_later(FINDINGS.to_owned()))
        .child(text(title))
}

/// Id of the list of diagnostics.
pub const FINDINGS: &str = "writing-findings";

/// List of diagnostics, except those shown beside their statement. Each place is a link to the text.
pub fn view(app: App) -> View {
    changing(move || {
        app.written.track();
        let mut findings = app.read_writing(|writing| writing.findings().to_vec());
        if app.writing_panel.get() == Panel::Model {
            let text = app.read_writing(|writing| writing.texts().first().cloned().unwrap_or_default());
            let is_beside = super::model::beside(&text);
            findings.retain(|(file, found)| *file > 0 || !is_beside(found));
        }
        if findings.is_empty() {
            return View::new();
        }
        let leads = Leads {
            go: Rc::new(move |file, place| go_to(app, file, place)),
            fix: Some(Rc::new(move |file, fix| carry_out(app, file, fix))),
        };
        diagnostics::list(app, &visited::written(app), &findings, Some(leads)).id(FINDINGS).tabindex("-1").into()
    })
}

/// Goes to a place in a text, given in bytes.
pub fn go_to(app: App, file: usize, place: usize) {
    let Some(editor) = app.with(|lab| lab.editor.clone()).flatten() else { return };
    let place = app.read_writing(|writing| writing.in_utf16(file, place));
    panels::show(app, Panel::Text);
    show(app, &editor, file);
    editor.go(place);
}

/// Applies a remedy to a text.
fn carry_out(app: App, file: usize, fix: &Fix) {
    let Some(editor) = app.with(|lab| lab.editor.clone()).flatten() else { return };
    let changes = app.read_writing(|writing| writing.changes(file, fix));
    panels::show(app, Panel::Text);
    show(app, &editor, file);
    editor.change(&changes);
}

/// Shows a text in the editor.
fn show(app: App, editor: &Editor, file: usize) {
    if app.written_file.get_untracked() != file {
        app.written_file.set(file);
        editor.select(file);
        mark(app);
    }
}
