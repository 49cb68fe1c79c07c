//! What a change of the text does in the page: the document is checked and runs, and this visit remembers it.

use super::{findings, kept};
use crate::app::{App, Lab};
use crate::visited::Visited;
use crate::{library, saved, tabs, visited};
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

/// Takes up what was being written of the open document and did not run yet.
pub fn resume(app: App, visited: Option<Visited>) {
    let resumed = app.with(|lab| {
        let Lab { desk: Some(desk), sources, .. } = lab else { return false };
        let draft = visited.filter(|visited| visited.sources == *sources).and_then(|visited| visited.draft);
        let Some(draft) = draft else { return false };
        desk.begin_writing(sources.iter().map(|source| source.text.clone()).collect());
        desk.write_all(draft);
        true
    });
    if resumed == Some(true) {
        app.written.update(|count| *count += 1);
        app.tab.set(tabs::WRITE);
    }
}

/// Takes a text as it stands in the editor.
pub fn written(app: App, file: usize, text: String) {
    let was_own = is_own(app);
    if !was_own {
        // What is seen of a document of the library stays its: what is written is a copy of one's own.
        saved::now(app);
    }
    kept::begin(app);
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
    kept::keep(app);
    app.written.update(|count| *count += 1);
    findings::mark(app);
}

/// Whether the open document is neither the page's nor of its library.
fn is_own(app: App) -> bool {
    matches!(library::subject(&visited::sources(app)), Subject::File(_))
}

/// The files as they stand in the editor.
pub fn files(app: App) -> Vec<Source> {
    let texts = app.read_desk(|desk| desk.writing().texts().to_vec());
    let names = visited::sources(app).into_iter().map(|source| source.name);
    names.zip(texts).map(|(name, text)| Source { name, text }).collect()
}
