//! Simulations of Easy JavaScript Simulations: a dropped file becomes a document, with a report beside it.

use crate::app::App;
use crate::documents::import_report::Report;
use crate::documents::opening;
use document::page::Source;
use ejss::{Imported, Importing, Refusal};
use js_sys::Uint8Array;
use std::rc::Rc;
use units::Language;
use view::browser;
use view::panel::tabs;
use web_sys::File;

/// True while the document of an import is open.
pub fn is_open(app: App, report: &Report) -> bool {
    app.with(|lab| lab.sources.first().is_some_and(|source| source.name == report.name())) == Some(true)
}

/// True for a simulation, and for an archive that holds one.
pub async fn is_simulation(file: &File) -> bool {
    let name = file.name();
    if !name.to_lowercase().ends_with(".zip") {
        return ejss::is_simulation(&name);
    }
    let bytes = browser::wait(file.array_buffer()).await;
    bytes.is_ok_and(|bytes| ejss::holds_simulation(&Uint8Array::new(&bytes).to_vec()))
}

/// Opens the document of a simulation in *Write*, with its report.
pub async fn open(app: App, file: &File) {
    let name = file.name();
    let Ok(bytes) = browser::wait(file.array_buffer()).await else {
        return app.complain(format!("{} {name}", app.words().file_not_read));
    };
    let bytes = Uint8Array::new(&bytes).to_vec();
    let language = app.language.get_untracked();
    let imported = match import(&bytes, language).await {
        Ok(imported) => imported,
        Err(refusal) => return app.complain(format!("{name}: {}", refusal.words().text(language))),
    };
    let stem = name.rsplit_once('.').map_or(name.as_str(), |(stem, _)| stem).trim_end_matches("_source");
    let source = Source { name: format!("{stem}.md"), text: imported.document.clone() };
    let report = Rc::new(Report::new(source.name.clone(), imported));
    opening::go_to_in_portions(app, vec![source], "").await;
    if is_open(app, &report) {
        app.imported.set(Some(report));
        app.tab.set(tabs::WRITE);
    }
}

/// Document of a simulation. The page answers between the steps.
async fn import(bytes: &[u8], language: Language) -> Result<Imported, Refusal> {
    browser::breathe().await;
    let mut importing = Importing::begin(bytes)?;
    browser::breathe().await;
    importing.translate();
    loop {
        browser::breathe().await;
        let imported = importing.candidate();
        if imported.listed_because.is_some() {
            return Ok(imported);
        }
        browser::breathe().await;
        match document::open(&imported.document, &[]).first_error() {
            Some(error) => importing.refuse(error.message.text(language).into_owned()),
            None => return Ok(imported),
        }
    }
}
