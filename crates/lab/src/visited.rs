//! The documents of the browser's history. Each step remembers its document, an own one with its text, so that a reload and
//! the buttons Back and Forward show it again.

use crate::app::App;
use crate::library;
use document::page::{self, Source};
use play::{Link, Subject};
use view::browser;
use view::views::window;
use wasm_bindgen::JsValue;
use web_sys::History;

/// What the state of a step begins with.
const OURS: &str = "meniscus ";
/// What the state of a step goes on with where its text does not run.
const DRAFT: &str = "draft";

/// The document of the present step; `None` where the page has not been here yet.
pub fn present() -> Option<Vec<Source>> {
    let state = history()?.state().ok()?.as_string()?;
    match state.strip_prefix(OURS)?.split_once(' ')? {
        ("home", _) => Some(library::home()),
        ("library", name) => library::find(name),
        ("own", list) => page::read_list(list),
        (DRAFT, lists) => Some(read_draft(lists)?.runs),
        _ => None,
    }
}

/// A document whose text does not run as it stands in the editor.
pub struct Draft {
    /// The files that run.
    pub runs: Vec<Source>,
    /// The texts in the editor.
    pub texts: Vec<String>,
}

/// What this step was writing that does not run yet.
pub fn draft() -> Option<Draft> {
    let state = history()?.state().ok()?.as_string()?;
    read_draft(state.strip_prefix(OURS)?.strip_prefix(DRAFT)?.trim_start())
}

/// One list: the files that run, and the same files as they stand in the editor.
fn read_draft(list: &str) -> Option<Draft> {
    let mut runs = page::read_list(list)?;
    let texts = runs.split_off(runs.len() / 2);
    (runs.len() == texts.len()).then(|| Draft { runs, texts: texts.into_iter().map(|file| file.text).collect() })
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
        let _ = history.push_state_with_url(&state(app), "", Some(&browser::address(&fragment)));
    }
}

/// Notes the open document in the present step; with another address if there is one.
pub fn note(app: App, address: Option<&str>) {
    if let Some(history) = history() {
        let _ = match address {
            Some(address) => history.replace_state_with_url(&state(app), "", Some(address)),
            None => history.replace_state(&state(app), ""),
        };
    }
}

fn history() -> Option<History> {
    window().history().ok()
}

/// The files of the open document.
pub fn sources(app: App) -> Vec<Source> {
    app.with(|lab| lab.sources.clone()).unwrap_or_default()
}

/// What a step remembers.
fn state(app: App) -> JsValue {
    let sources = sources(app);
    let draft = app.read_desk(|desk| (!desk.writing().runs()).then(|| desk.writing().texts().to_vec()));
    if let Some(draft) = draft.filter(|draft| draft.len() == sources.len()) {
        let names = sources.iter().map(|file| file.name.clone());
        let files: Vec<Source> = names.zip(draft).map(|(name, text)| Source { name, text }).collect();
        return format!("{OURS}{DRAFT} {}", page::write_list(&[sources, files].concat())).into();
    }
    let what = match library::subject(&sources) {
        Subject::Home => "home ".to_owned(),
        Subject::Library(name) => format!("library {name}"),
        Subject::Packed(_) | Subject::File(_) => format!("own {}", page::write_list(&sources)),
    };
    format!("{OURS}{what}").into()
}
