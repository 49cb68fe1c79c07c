//! Opening files picked or dropped by the user.

use crate::app::App;
use crate::documents::{imported, opening, project};
use crate::verifying::dialog as verified;
use crate::{class, film, measuring::intake};
use desk::saved::hand_in::{HandIn, HandInError};
use document::BlockKind;
use document::page::{self, Source};
use js_sys::Uint8Array;
use units::order::sort_by_key;
use view::browser;
use web_sys::{File, FileList};

/// Text of a file without byte-order mark, or the reason why it cannot be read.
async fn text_of(app: App, file: &File) -> Result<String, String> {
    let (name, words) = (file.name(), app.words());
    let bytes = browser::wait(file.array_buffer()).await.map_err(|_| format!("{} {name}", words.file_not_read))?;
    let text = String::from_utf8(Uint8Array::new(&bytes).to_vec());
    let text = text.map_err(|_| format!("{name} {}", words.file_not_text))?;
    Ok(text.strip_prefix('\u{feff}').map(str::to_owned).unwrap_or(text))
}

/// True if a text contains a model, with or without errors: only then does it replace the open document.
fn has_model(text: &str) -> bool {
    document::read(text).blocks_of(BlockKind::Model).next().is_some()
}

/// Opens files picked by the user: a document with its translations, one exported page, a project, a hand-in or
/// report to be verified, or records.
pub fn open(app: App, files: &FileList) {
    let files: Vec<File> = (0..files.length()).filter_map(|index| files.get(index)).collect();
    wasm_bindgen_futures::spawn_local(async move {
        let mut sources = Vec::new();
        let is_document = |file: &File| {
            let name = file.name().to_lowercase();
            [".md", ".markdown", ".html", ".htm"].iter().any(|ending| name.ends_with(ending))
        };
        let (films, files): (Vec<File>, Vec<File>) = files.into_iter().partition(film::is_film);
        if let Some(file) = films.into_iter().next() {
            film::open(app, file);
        }
        let (hand_ins, files): (Vec<File>, Vec<File>) = files.into_iter().partition(class::is_hand_in);
        match <[File; 1]>::try_from(hand_ins) {
            Ok([file]) if !app.class.is_open() => verified::open(app, &file).await,
            Ok([file]) => class::add(app, vec![file]).await,
            Err(several) if several.is_empty() => {}
            Err(several) => class::add(app, several).await,
        }
        let (sheets, files): (Vec<File>, Vec<File>) = files.into_iter().partition(class::is_sheet);
        if !sheets.is_empty() {
            class::open(app);
            class::add_sheets(app, sheets).await;
        }
        let (mut simulations, mut others) = (Vec::new(), Vec::new());
        for file in files {
            if imported::is_simulation(&file).await { simulations.push(file) } else { others.push(file) }
        }
        if let Some(file) = simulations.into_iter().next() {
            imported::open(app, &file).await;
        }
        let files = others;
        let (projects, files): (Vec<File>, Vec<File>) = files.into_iter().partition(project::is_project);
        if let Some(file) = projects.into_iter().next() {
            project::open(app, &file).await;
        }
        let (documents, records): (Vec<File>, Vec<File>) = files.into_iter().partition(is_document);
        if documents.is_empty() {
            return intake::read(app, records);
        }
        for file in documents {
            let name = file.name();
            let text = match text_of(app, &file).await {
                Ok(text) => text,
                // A document and its translations are opened together or not at all.
                Err(refusal) => return app.complain(refusal),
            };
            if let Some(embedded) = page::read(&text) {
                sources = embedded;
                break;
            }
            if text.trim_start().starts_with('<') {
                match HandIn::open(text.as_bytes()) {
                    Err(HandInError::NoData) => {}
                    report => return verified::show(app, &name, report).await,
                }
            }
            if !name.to_lowercase().ends_with(".html") {
                sources.push(Source { name, text });
            }
        }
        // `utube.md` before `utube.es.md`: the document precedes its translations.
        sort_by_key(&mut sources, |source| source.name.matches('.').count());
        if sources.is_empty() {
            return app.complain(app.words().unreadable.to_owned());
        }
        if let Some(base) = sources.first().filter(|base| !has_model(&base.text)) {
            return app.complain(format!("{} {}", base.name, app.words().no_simulation));
        }
        // A link may have been waiting for this file.
        let name = sources.first().map(|source| source.name.clone());
        let awaited = app.with(|lab| lab.awaited.take_if(|(awaited, _)| Some(&*awaited) == name.as_ref()));
        let state = awaited.flatten().map(|(_, state)| state).unwrap_or_default();
        opening::go_to_in_portions(app, sources, &state).await;
        intake::read(app, records);
        browser::focus_later(if app.read(|_| true) { "play" } else { "apparatus" }.to_owned());
    });
}
