//! The documents of the browser's history. Each step remembers its document, an own one with its text, so that a reload and
//! the buttons Back and Forward show it again.

use crate::app::App;
use crate::library;
use document::file_name;
use document::page::{self, Source};
use play::{Link, Subject};
use view::browser;
use view::views::window;
use wasm_bindgen::JsValue;
use web_sys::History;

/// What the state of a step begins with.
const OURS: &str = "meniscus ";

/// A document as a step remembers it.
#[derive(Clone, PartialEq)]
pub struct Visited {
    /// The files that run.
    pub sources: Vec<Source>,
    /// The texts in the editor, where they are not those that run.
    pub draft: Option<Vec<String>>,
}

impl Visited {
    /// Its files as they stood in the editor.
    pub fn files(&self) -> Vec<Source> {
        let mut files = self.sources.clone();
        for (file, text) in files.iter_mut().zip(self.draft.iter().flatten()) {
            file.text.clone_from(text);
        }
        files
    }
}

/// The document of the present step; `None` where the page has not been here yet.
pub fn present() -> Option<Visited> {
    let state = history()?.state().ok()?.as_string()?;
    read(state.strip_prefix(OURS)?)
}

/// Reads what [`describe`] has written.
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

/// What a step remembers of the open document: the name of one of the library, an own one with its text. Where the text in the
/// editor does not run, its files follow those that do.
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

/// Makes the open document a new step. A document of the library has its name in the address.
pub fn step(app: App) {
    let subject = match library::subject(&sources(app)) {
        // Its text is in the step and would make the address unreadable.
        Subject::Packed(_) | Subject::File(_) => Subject::Home,
        subject => subject,
    };
    let fragment = Link { subject, state: String::new() }.write();
    if let Some(history) = history() {
        // Refused inside some frames: there Back leaves the laboratory.
        let _ = history.push_state_with_url(&state(&describe(app)), "", Some(&browser::address(&fragment)));
    }
}

/// Notes the open document in the present step; with another address if there is one.
pub fn note(app: App, address: Option<&str>) {
    if let Some(history) = history() {
        let state = state(&describe(app));
        let _ = match address {
            Some(address) => history.replace_state_with_url(&state, "", Some(address)),
            None => history.replace_state(&state, ""),
        };
    }
}

/// Notes the open document, which [`describe`] has described, in the present step.
pub fn note_described(description: &str) {
    if let Some(history) = history() {
        let _ = history.replace_state(&state(description), "");
    }
}

fn history() -> Option<History> {
    window().history().ok()
}

/// The files of the open document.
pub fn sources(app: App) -> Vec<Source> {
    app.with(|lab| lab.sources.clone()).unwrap_or_default()
}

/// The files as they stand in the editor; none where writing has not begun.
pub fn written(app: App) -> Vec<Source> {
    let texts = app.read_writing(|writing| writing.texts().to_vec());
    let names = sources(app).into_iter().map(|source| source.name);
    names.zip(texts).map(|(name, text)| Source { name, text }).collect()
}

/// What the files of a document are called. While it has no translation, which refers to it by its name, it is called after its title
/// unless its author has named it.
pub fn names(files: &[Source]) -> Vec<String> {
    match files {
        [only] if matches!(library::subject(files), Subject::File(_)) => vec![file_name(&only.name, &only.text)],
        all => all.iter().map(|file| file.name.clone()).collect(),
    }
}

/// The files of the open document as they are saved: as they stand in the editor, without the folders of the library.
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

/// What files of the open document are called, without an ending.
pub fn stem(app: App) -> String {
    let name = files(app).into_iter().next().map(|file| file.name).unwrap_or_default();
    let name = name.trim_end_matches(".md");
    if name.is_empty() { "simulation".to_owned() } else { name.to_owned() }
}

fn state(description: &str) -> JsValue {
    format!("{OURS}{description}").into()
}
