//! The open document, as it is published.

use crate::app::App;
use crate::visited;
use document::page::Source;

/// What files of the open document are called, without an ending.
pub fn stem(app: App) -> String {
    let name = visited::sources(app).first().map(|source| source.name.clone()).unwrap_or_default();
    let name = name.rsplit('/').next().unwrap_or_default().trim_end_matches(".md");
    if name.is_empty() { "simulation".to_owned() } else { name.to_owned() }
}

/// The files of the document as they stand in the editor. Names of the library have folders, which files have not.
pub fn files(app: App) -> Vec<Source> {
    let written = visited::written(app);
    let sources = if written.is_empty() { visited::sources(app) } else { written };
    let named =
        |Source { name, text }: Source| Source { name: name.rsplit('/').next().unwrap_or_default().to_owned(), text };
    sources.into_iter().map(named).collect()
}
