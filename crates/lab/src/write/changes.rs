//! Effects of a text change on the page: the document is checked and run, and the history entry is updated.

use super::{draft, findings, kept, versions};
use crate::app::{App, Lab};
use crate::{documents::opening, documents::saved, documents::visited, library};
use desk::{Desk, Writing};
use document::page::Source;
use play::Subject;

/// Begins editing the open document, unless this has been done.
pub fn begin(app: App) {
    app.with(|lab| {
        let Lab { desk: Some(desk), sources, .. } = lab else { return };
        if !desk.writing().has_begun() {
            desk.set_writing(Writing::of_running(sources.iter().map(|source| source.text.clone()).collect()));
        }
    });
}

/// Handles a changed text of the editor.
pub fn written(app: App, file: usize, text: String) {
    let is_current = app.with(|lab| lab.editor_is_current) == Some(true);
    // Ignores texts of a previous document and changes that were undone at once.
    if !is_current || app.read_writing(|writing| writing.texts().get(file) == Some(&text)) {
        return;
    }
    let was_own = become_own(app);
    versions::before_change(app);
    if app.with(|lab| lab.desk.is_none()) == Some(true) {
        opening::mend(app, |writing, _| writing.change(file, text));
        checked(app);
    } else {
        let runs = app.with(|lab| replaced(lab, |desk, _| desk.write(file, text)));
        replaced_own(app, was_own, runs == Some(true));
    }
    kept::now(app);
}

/// Adds a file to the open document, such as a translation, which refers to it by its saved name. The draft, its
/// versions and the undo history of the other files stay.
pub fn add(app: App, file: Source) {
    begin(app);
    let was_own = become_own(app);
    versions::make(app);
    if let Some(editor) = app.with(|lab| lab.editor.clone()).flatten() {
        editor.add(&file.text);
    }
    let mut texts = app.read_writing(|writing| writing.texts().to_vec());
    texts.push(file.text.clone());
    let names = visited::files(app).into_iter().map(|file| file.name);
    let names: Vec<String> = names.chain([file.name.clone()]).collect();
    let name = |sources: &mut Vec<Source>| {
        sources.push(file);
        sources.iter_mut().zip(names).for_each(|(source, name)| source.name = name);
    };
    if app.with(|lab| lab.desk.is_none()) == Some(true) {
        opening::mend(app, |writing, sources| {
            name(sources);
            writing.change_all(texts)
        });
        checked(app);
    } else {
        let add = |desk: &mut Desk, sources: &mut Vec<Source>| {
            name(sources);
            desk.write_all(texts)
        };
        let runs = app.with(|lab| replaced(lab, add));
        replaced_own(app, was_own, runs == Some(true));
    }
    kept::now(app);
    // The views of the files must show the new one.
    app.rebuild();
}

/// Turns the open document into one of the user's own before a change. Returns true if it already was one. Saved data
/// of a library document stay with it.
fn become_own(app: App) -> bool {
    let was_own = is_own(app);
    if !was_own {
        saved::now(app);
    }
    kept::begin(app);
    was_own
}

/// Updates the page after the desk has accepted a change. A library document becomes a new history entry once its
/// changed text runs.
fn replaced_own(app: App, was_own: bool, runs: bool) {
    if runs {
        if !was_own {
            visited::step(app);
        }
        app.rebuild_program();
    }
    checked(app);
}

/// Shows the diagnostics of the texts.
fn checked(app: App) {
    app.written.update(|count| *count += 1);
    findings::mark(app);
}

/// Replaces all texts as if they had been typed: each can be undone in the editor.
pub fn take(app: App, texts: &[String]) {
    let editor = app.with(|lab| lab.editor.clone()).flatten();
    for (file, text) in texts.iter().enumerate() {
        if let Some(editor) = &editor {
            editor.take(file, text);
        }
        written(app, file, text.clone());
    }
}

/// Stores the present texts as a version and replaces them.
pub fn go_back(app: App, texts: &[String]) {
    draft::flush(app);
    versions::make(app);
    take(app, texts);
}

/// Restores the version with this name, if it belongs to the open document.
pub fn restore(app: App, version: &str) {
    if let Some(texts) = versions::texts(app, version) {
        go_back(app, &texts);
    }
}

/// Takes over changed files of a served page; the run continues with them. `before` are the previous files. Text typed
/// here since becomes a version; returns its name.
pub fn follow_file(app: App, before: &[Source], texts: &[String]) -> Option<String> {
    begin(app);
    draft::flush(app);
    let is_typed = |writing: &Writing| {
        let is_lost = |(file, written): (usize, &String)| {
            before.get(file).is_none_or(|before| before.text != *written) && texts.get(file) != Some(written)
        };
        writing.texts().iter().enumerate().any(is_lost)
    };
    let version = app.read_writing(is_typed).then(|| {
        kept::begin(app);
        versions::make(app)
    });
    if let Some((Some(editor), true)) = app.with(|lab| (lab.editor.clone(), lab.editor_is_current)) {
        for (file, text) in texts.iter().enumerate() {
            editor.take(file, text);
        }
    }
    let runs = app.with(|lab| replaced(lab, |desk, _| desk.write_all(texts.to_vec())));
    visited::note(app, None);
    if runs == Some(true) {
        app.rebuild_program();
    }
    checked(app);
    version.flatten()
}

/// Applies a change to the texts of the desk and to their files. Returns true if the text runs now.
fn replaced(lab: &mut Lab, change: impl FnOnce(&mut Desk, &mut Vec<Source>) -> bool) -> bool {
    let before = saved::key(lab);
    let Lab { desk: Some(desk), sources, findings, .. } = lab else { return false };
    let runs = change(desk, sources);
    if runs {
        for (source, text) in sources.iter_mut().zip(desk.writing().texts()) {
            source.text.clone_from(text);
        }
        *findings = desk.writing().findings().to_vec();
    }
    saved::rename(lab, before);
    runs
}

/// True if the open document is neither the page's own nor one of the library.
fn is_own(app: App) -> bool {
    matches!(library::subject(&visited::sources(app)), Subject::File(_))
}
