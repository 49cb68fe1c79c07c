//! Drafts: typed text that does not run or has not been checked yet when a document is opened or left.

use crate::app::{App, Lab};
use crate::documents::visited::Visited;
use desk::Writing;
use view::panel::tabs;

/// Restores the draft of the open document from a history entry.
pub fn resume(app: App, visited: Option<Visited>) {
    let resumed = app.with(|lab| {
        let Lab { desk: Some(desk), sources, .. } = lab else { return false };
        let draft = visited.filter(|visited| visited.sources == *sources).and_then(|visited| visited.draft);
        let Some(draft) = draft else { return false };
        desk.set_writing(Writing::of_running(sources.iter().map(|source| source.text.clone()).collect()));
        desk.write_all(draft);
        true
    });
    if resumed == Some(true) {
        app.written.update(|count| *count += 1);
        app.tab.set(tabs::WRITE);
    }
}

/// Checks the text typed last immediately.
pub fn flush(app: App) {
    if let Some(editor) = app.with(|lab| lab.editor.clone()).flatten() {
        editor.flush();
    }
}
