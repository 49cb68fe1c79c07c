//! What a change of the text does in the page: the document is checked and runs, and this visit remembers it.

use super::{draft, findings, kept, versions};
use crate::app::{App, Lab};
use crate::{library, opening, saved, visited};
use desk::{Desk, Writing};
use document::page::Source;
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

/// Adds a file to the open document, such as a translation, which refers to it by the name that it is saved under. It stays the same
/// draft: its versions and what can be undone in its other files stay.
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
    // What shows the files shows one more.
    app.rebuild();
}

/// What is about to be changed is one's own document from here on. Whether it was before; one of the library keeps what is saved of it.
fn become_own(app: App) -> bool {
    let was_own = is_own(app);
    if !was_own {
        saved::now(app);
    }
    kept::begin(app);
    was_own
}

/// The desk has taken a change of one's own document. One that was of the library is a new step of the visit once it runs.
fn replaced_own(app: App, was_own: bool, runs: bool) {
    if runs {
        if !was_own {
            visited::step(app);
        }
        app.rebuild_program();
    }
    checked(app);
}

/// Shows what was found in the texts.
fn checked(app: App) {
    app.written.update(|count| *count += 1);
    findings::mark(app);
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

/// Makes the text as it stands a version, and goes back to other texts.
pub fn go_back(app: App, texts: &[String]) {
    draft::flush(app);
    versions::make(app);
    take(app, texts);
}

/// Goes back to the version of this name, if the open document still has it.
pub fn restore(app: App, version: &str) {
    if let Some(texts) = versions::texts(app, version) {
        go_back(app, &texts);
    }
}

/// Takes the texts of the files that this page is served from, which have changed: the run goes on with them. `before` are the files as
/// they were. What was typed here since becomes a version; its name.
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

/// Has the desk take a change of the texts, and of the files that they belong to. Whether its text runs now.
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

/// Whether the open document is neither the page's nor of its library.
fn is_own(app: App) -> bool {
    matches!(library::subject(&visited::sources(app)), Subject::File(_))
}
