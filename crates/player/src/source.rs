//! The document of the simulation, stored in the page so that it can be opened in the laboratory and handed in.

use js_sys::{Array, JSON, Reflect};
use view::views::*;
use view::{App, browser, pieces::icons};
use wasm_bindgen::{JsCast, JsValue};

/// Files of the document: (name, text).
pub fn files() -> Vec<(String, String)> {
    let text = browser::by_id::<web_sys::Element>("documents").and_then(|element| element.text_content());
    let list = text.and_then(|text| JSON::parse(&text).ok()).and_then(|list| list.dyn_into::<Array>().ok());
    let field = |file: &JsValue, name: &str| Reflect::get(file, &JsValue::from_str(name)).ok()?.as_string();
    let files = list.into_iter().flat_map(|list| list.to_vec());
    files.filter_map(|file| Some((field(&file, "name")?, field(&file, "text")?))).collect()
}

/// Button that saves the document; empty if the page contains none.
pub fn button_of(app: App) -> View {
    if files().is_empty() {
        return View::new();
    }
    let save = move |_| {
        for (name, text) in files() {
            browser::save_text(&name, "text/markdown", &text);
        }
    };
    let words = app.words();
    labelled(icons::folder(), words.document)
        .id("document")
        .title(words.document_title)
        .when(events::click, save)
        .into()
}
