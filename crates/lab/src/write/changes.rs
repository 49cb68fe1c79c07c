//! What a change of the text does in the page: the document is checked and runs, and this visit remembers it.

use super::{findings, kept};
use crate::app::{App, Lab};
use crate::{library, opening, saved, visited};
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
    if app.with(|lab| lab.desk.is_none()) == Some(true) {
        opening::mend(app, file, text);
        return checked(app);
    }
    let runs = app.with(|lab| {
        let before = saved::key(lab);
        let Lab { desk: Some(desk), sources, findings, .. } = lab else { return false };
        let runs = desk.write(file, text);
        if runs {
            for (source, text) in sources.iter_mut().zip(desk.writing().texts()) {
                source.text.clone_from(text);
            }
            *findings = desk.writing().findings().to_vec();
            saved::rename(lab, before);
        }
        runs
    });
    if runs == Some(true) {
        if was_own {
            visited::note(app, None)
        } else {
            visited::step(app)
        }
        app.rebuild_program();
    } else {
        visited::note(app, None);
    }
    checked(app);
}

/// Keeps what was written, and shows what was found in it.
fn checked(app: App) {
    kept::keep(app);
    app.written.update(|count| *count += 1);
    findings::mark(app);
}

/// Whether the open document is neither the page's nor of its library.
fn is_own(app: App) -> bool {
    matches!(library::subject(&visited::sources(app)), Subject::File(_))
}
