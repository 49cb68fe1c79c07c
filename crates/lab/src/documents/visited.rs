//! Documents in the browser history. Each history entry stores its document (an own document with its text), so that a
//! reload and the buttons Back and Forward restore it.

use crate::app::App;
use crate::library;
use document::file_name;
use document::page::{self, Source};
use play::{Link, Subject};
use view::browser;
use view::views::window;
use wasm_bindgen::JsValue;
use web_sys::History;

/// Prefix of the state of a history entry.
const OURS: &str = "meniscus ";

/// Document of a history entry.
#[derive(Clone, PartialEq)]
pub struct Visited {
    /// Files that run.
    pub sources: Vec<Source>,
    /// Texts in the editor, if they differ from those that run.
    pub draft: Option<Vec<String>>,
}

impl Visited {
    /// Files with the texts in the editor.
    pub fn files(&self) -> Vec<Source> {
        let mut files = self.sources.clone();
        for (file, text) in files.iter_mut().zip(self.draft.iter().flatten()) {
            file.text.clone_from(text);
        }
        files
    }
}

/// Document of the present history entry; `None` if the page has not stored one.
pub fn present() -> Option<Visited> {
    let state = history()?.state().ok()?.as_string()?;
    read(state.strip_prefix(OURS)?)
}

/// Parses the output of [`describe`].
pub fn read(description: &str) -> Option<Visited> {
    let document = |sources| Some(Visited { sources, draft: None });
    match description.split_once(' ')? {
        ("home", _) => document(library::home()),
        ("library", name) => document(library::find(name)?),
        ("own", list) => document(page::read_list(list)?),
        ("draft", list) => {
            let mut sources = page::read_list(list)?;
            let texts = sources.split_off(sources.len() / 2);
            let draft = (sources.len() == texts.len()).then(|| texts.into_iter().map(|file| file.text).collect());
            Some(Visited { sources, draft })
        }
        _ => None,
    }
}

/// State of a history entry for the open document: the name of a library document, or an own document with its text. If
/// the text in the editor does not run, its files follow those that do.
pub fn describe(app: App) -> String {
    let sources = sources(app);
    let runs = app.read_writing(|writing| writing.runs());
    let written = if runs { Vec::new() } else { written(app) };
    if !written.is_empty() && written != sources {
        return format!("draft {}", page::write_list(&[sources, written].concat()));
    }
    match library::subject(&sources) {
        Subject::Home => "home ".to_owned(),
        Subject::Library(name) => format!("library {name}"),
        Subject::Packed(_) | Subject::File(_) => format!("own {}", page::write_list(&sources)),
    }
}

/// Adds a history entry for the open document. The address contains the name of a library document.
pub fn step(app: App) {
    let subject = match library::subject(&sources(app)) {
        // The text is stored in the entry and would make the address unreadable.
        Subject::Packed(_) | Subject::File(_) => Subject::Home,
        subject => subject,
    };
    let fragment = Link { subject, state: String::new() }.write();
    if let Some(history) = history() {
        // Refused inside some frames; the Back button then leaves the laboratory.
        let _ = history.push_state_with_url(&state(&describe(app)), "", Some(&browser::address(&fragment)));
    }
}

/// Stores the open document in the present history entry, optionally with another address.
pub fn note(app: App, address: Option<&str>) {
    if let Some(history) = history() {
        let state = state(&describe(app));
        let _ = match address {
            Some(address) => history.replace_state_with_url(&state, "", Some(address)),
            None => history.replace_state(&state, ""),
        };
    }
}

/// Stores the output of [`describe`] in the present history entry.
pub fn note_described(description: &str) {
    if let Some(history) = history() {
        let _ = history.replace_state(&state(description), "");
    }
}

fn history() -> Option<History> {
    window().history().ok()
}

/// Files of the open document.
pub fn sources(app: App) -> Vec<Source> {
    app.with(|lab| lab.sources.clone()).unwrap_or_default()
}

/// Files with the texts in the editor; empty if editing has not begun.
pub fn written(app: App) -> Vec<Source> {
    let texts = app.read_writing(|writing| writing.texts().to_vec());
    let names = sources(app).into_iter().map(|source| source.name);
    names.zip(texts).map(|(name, text)| Source { name, text }).collect()
}

/// File names of a document. A single file is named after its title unless the author has named it; with translations,
/// which refer to it by name, the names stay.
pub fn names(files: &[Source]) -> Vec<String> {
    match files {
        [only] if matches!(library::subject(files), Subject::File(_)) => vec![file_name(&only.name, &only.text)],
        all => all.iter().map(|file| file.name.clone()).collect(),
    }
}

/// Files of the open document for saving: with the texts in the editor, without the folders of the library.
pub fn files(app: App) -> Vec<Source> {
    let written = written(app);
    let files = if written.is_empty() { sources(app) } else { written };
    let names = names(&files).into_iter();
    let named = |(name, file): (String, Source)| Source {
        name: name.rsplit('/').next().unwrap_or_default().to_owned(),
        text: file.text,
    };
    names.zip(files).map(named).collect()
}

/// Base name of saved files of the open document, without extension.
pub fn stem(app: App) -> String {
    let name = files(app).into_iter().next().map(|file| file.name).unwrap_or_default();
    let name = name.trim_end_matches(".md");
    if name.is_empty() { "simulation".to_owned() } else { name.to_owned() }
}

fn state(description: &str) -> JsValue {
    format!("{OURS}{description}").into()
}
