//! Opens a project: its document and the measurements.

use crate::app::App;
use crate::{documents::opening, fit};
use desk::saved::project::{LONGEST_PROJECT, PROJECT_ENDING, Project, ProjectError};
use view::browser;
use web_sys::File;

/// True if a file is a project, by the ending of its name.
pub fn is_project(file: &File) -> bool {
    file.name().to_lowercase().ends_with(PROJECT_ENDING)
}

/// Opens the project in a file; see [`show`].
pub async fn open(app: App, file: &File) {
    let name = file.name();
    let project = match read(file).await {
        Ok(project) => project,
        Err(Some(error)) => {
            let words = error.words();
            return app.complain(format!("{name} {}", words.text(app.language.get_untracked())));
        }
        Err(None) => return app.complain(format!("{} {name}", app.words().file_not_read)),
    };
    show(app, &name, project);
}

/// Opens the project of this name as a new history entry. Existing records stay.
pub fn show(app: App, name: &str, project: Project) {
    opening::go_to(app, project.documents, &project.state);
    let runs = app.read(|_| true);
    let refused = app.act_on_desk(|desk| desk::take_project_items(desk, &project.items).len());
    let refused = if runs { refused } else { project.items.len() };
    if refused > 0 {
        app.complain(format!("{name}: {} {refused}", app.words().project_items_refused));
    }
    if app.read_desk(|desk| desk.fits().has_waiting()) {
        fit::go_on(app);
    }
    browser::focus_later(if runs { "play" } else { "apparatus" }.to_owned());
}

/// The project, or the reason why it cannot be read; `Err(None)` if the browser did not provide the file.
async fn read(file: &File) -> Result<Project, Option<ProjectError>> {
    // Too large files are refused without reading them.
    if file.size() > LONGEST_PROJECT as f64 {
        return Err(Some(ProjectError::TooLarge));
    }
    let text = browser::wait(file.text()).await.ok().and_then(|text| text.as_string()).ok_or(None)?;
    Project::read(&text).map_err(Some)
}
