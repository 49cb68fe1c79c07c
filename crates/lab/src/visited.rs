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

/// The document of the present step; `None` where the page has not been here yet.
pub fn present() -> Option<Vec<Source>> {
    let state = history()?.state().ok()?.as_string()?;
    match state.strip_prefix(OURS)?.split_once(' ')? {
        ("home", _) => Some(library::home()),
        ("library", name) => library::find(name),
        ("own", list) => page::read_list(list),
        _ => None,
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
    let what = match library::subject(&sources) {
        Subject::Home => "home ".to_owned(),
        Subject::Library(name) => format!("library {name}"),
        Subject::Packed(_) | Subject::File(_) => format!("own {}", page::write_list(&sources)),
    };
    format!("{OURS}{what}").into()
}
