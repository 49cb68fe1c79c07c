//! Export of the files of the document, and of the project with the measurements.

use super::words;
use crate::app::App;
use crate::documents::visited::{files, stem};
use desk::saved::project::{PROJECT_ENDING, Project};
use view::browser;
use view::views::*;

/// Section of the dialog: buttons that save the files and the project.
pub fn view(app: App) -> View {
    let words = words::of(app);
    let save = button().class("quiet outlined").id("save-source").child(words.source_save);
    let save = save.when(events::click, move |_| {
        for source in files(app) {
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

fn save_project(app: App) {
    let (state, items) =
        app.read_desk(|desk| (desk.play().share(), desk::project_items(desk, js_sys::Date::now() as u64)));
    let project = Project { documents: files(app), state, items };
    browser::save_text(&format!("{}{PROJECT_ENDING}", stem(app)), "application/json", &project.write());
}
