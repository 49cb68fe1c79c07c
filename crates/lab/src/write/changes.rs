//! What a change of the text does in the page: the document is checked and runs, and this visit remembers it.

use super::{findings, kept, versions};
use crate::app::{App, Lab};
use crate::{library, opening, saved, visited};
use desk::Desk;
use play::Subject;

/// Begins to write at the open document, unless that has been done.
pub fn begin(app: App) {
    app.with(|lab| {
        let Lab { desk: Some(desk), sources, .. } = lab else { return };
        if !desk.writing().has_begun() {
            desk.begin_writing(sources.iter().map(|source| source.text.clone()).collect());
        }
    });
}

/// Takes a text as it stands in the editor.
pub fn written(app: App, file: usize, text: String) {
    let is_current = app.with(|lab| lab.editor_is_current) == Some(true);
    // Of a document that has been left; or typed and taken back at once.
    if !is_current || app.read_writing(|writing| writing.texts().get(file) == Some(&text)) {
        return;
    }
    let was_own = is_own(app);
    if !was_own {
        // The document of the library keeps what is saved of it; from here on the text is a copy of one's own.
        saved::now(app);
    }
    kept::begin(app);
    versions::before_change(app);
    if app.with(|lab| lab.desk.is_none()) == Some(true) {
        opening::mend(app, file, text);
        return checked(app, visited::describe(app));
    }
    let runs = app.with(|lab| replaced(lab, |desk| desk.write(file, text)));
    let description = visited::describe(app);
    if runs == Some(true) && !was_own {
        visited::step(app);
    } else {
        visited::note_described(&description);
    }
    if runs == Some(true) {
        app.rebuild_program();
    }
    checked(app, description);
}

/// Takes other texts for all files, as if they had been typed: each can be undone in the editor.
pub fn take(app: App, texts: &[String]) {
    let editor = app.with(|lab| lab.editor.clone()).flatten();
    for (file, text) in texts.iter().enumerate() {
        if let Some(editor) = &editor {
            editor.take(file, text);
        }
        written(app, file, text.clone());
    }
}

/// Takes the texts of the files that this page is served from, which have changed: the run goes on with them. What was typed in the
/// editor can be brought back there.
pub fn follow_file(app: App, texts: &[String]) {
    begin(app);
    let editor = app.with(|lab| (lab.editor.clone(), lab.editor_is_current));
    if let Some((Some(editor), true)) = editor {
        editor.flush();
        for (file, text) in texts.iter().enumerate() {
            editor.take(file, text);
        }
    }
    let runs = app.with(|lab| replaced(lab, |desk| desk.write_all(texts.to_vec())));
    visited::note(app, None);
    if runs == Some(true) {
        app.rebuild_program();
    }
    app.written.update(|count| *count += 1);
    findings::mark(app);
}

/// Has the desk take a change. Whether its text runs now.
fn replaced(lab: &mut Lab, change: impl FnOnce(&mut Desk) -> bool) -> bool {
    let before = saved::key(lab);
    let Lab { desk: Some(desk), sources, findings, .. } = lab else { return false };
    let runs = change(desk);
    if runs {
        for (source, text) in sources.iter_mut().zip(desk.writing().texts()) {
            source.text.clone_from(text);
        }
        *findings = desk.writing().findings().to_vec();
        saved::rename(lab, before);
    }
    runs
}

/// Keeps what was written, as [`visited::describe`] describes it, and shows what was found in it.
fn checked(app: App, description: String) {
    kept::keep(app, description);
    app.written.update(|count| *count += 1);
    findings::mark(app);
}

/// Whether the open document is neither the page's nor of its library.
fn is_own(app: App) -> bool {
    matches!(library::subject(&visited::sources(app)), Subject::File(_))
}
