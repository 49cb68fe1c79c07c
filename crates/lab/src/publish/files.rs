//! The files of the document, and the project that holds them and what was measured.

use super::{stem, words};
use crate::app::App;
use crate::visited;
use document::page::Source;
use document::project::{PROJECT_ENDING, Project};
use view::browser;
use view::views::*;

/// The section.
pub fn view(app: App) -> View {
    let words = words(app);
    let save = button().class("quiet outlined").id("save-source").child(words.source_save);
    let save = save.when(events::click, move |_| {
        for source in present(app) {
            browser::save_text(&source.name, "text/markdown", &source.text);
        }
    });
    let project = button().class("quiet outlined").id("save-project").child(words.project_save);
    let project = project.when(events::click, move |_| save_project(app));
    View::from((
        note(words.source_intro),
        div().class("ways").child(save),
        note(words.project_intro),
        div().class("ways").child(project),
    ))
}

/// The files of the document as they stand in the editor. Names of the library have folders, which files have not.
pub fn present(app: App) -> Vec<Source> {
    let written = visited::written(app);
    let sources = if written.is_empty() { visited::sources(app) } else { written };
    let named =
        |Source { name, text }: Source| Source { name: name.rsplit('/').next().unwrap_or_default().to_owned(), text };
    sources.into_iter().map(named).collect()
}

fn save_project(app: App) {
    let (state, items) = app.read_desk(|desk| (desk.play().share(), desk.project_items(js_sys::Date::now() as u64)));
    let project = Project { documents: present(app), state, items };
    browser::save_text(&format!("{}{PROJECT_ENDING}", stem(app)), "application/json", &project.write());
}
