//! Pages of a class server. The script of the teacher's page passes hand-ins as they arrive, that of a student's page asks for the work.

use super::{survey, window};
use crate::app::App;
use crate::publish;
use crate::verifying::reading::read;
use class::collection::References;
use desk::saved::hand_in::{HandIn, HandInError};
use view::browser;
use view::page::class as class_page;
use view::views::{Signal, create_signal, document, window as page_window};
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_futures::future_to_promise;
use web_sys::{CustomEvent, Event, File};

/// Events of the teacher's script: the documents of the class, open the dashboard, a hand-in as a file, a list of answers to surveys.
const DOCUMENTS: &str = "class-documents";
const OPEN: &str = "class-open";
const HAND_IN: &str = "class-hand-in";
const SHEETS: &str = "class-sheets";
/// Tells the script that this page listens.
const READY: &str = "class-ready";

/// Names and texts of items.
type Items = Vec<(String, String)>;

/// Listens to the script of a class server; does nothing in any other page.
pub fn listen(app: App) {
    if !class_page::is_here() {
        return;
    }
    browser::listen(DOCUMENTS, move |event: &CustomEvent| {
        let documents = event.detail().as_string().and_then(|text| References::of_json(&text));
        documents.into_iter().for_each(|documents| app.class.set_references(documents));
    });
    browser::listen(OPEN, move |_: &Event| window::open(app));
    browser::listen(HAND_IN, move |event: &CustomEvent| {
        if let Ok(file) = event.detail().dyn_into::<File>() {
            wasm_bindgen_futures::spawn_local(take(app, file));
        }
    });
    browser::listen(SHEETS, move |event: &CustomEvent| {
        let files =
            js_sys::Array::from(&event.detail()).iter().filter_map(|file| file.dyn_into::<File>().ok()).collect();
        app.survey.clear();
        wasm_bindgen_futures::spawn_local(survey::add(app, files));
    });
    let handed = create_signal(None);
    class_page::offer(
        move |name| future_to_promise(hand_in(app, name, handed)),
        move |text| {
            if let Ok(known) = HandIn::read(&text) {
                // The script has forgotten what was handed in, and asks for all of it.
                handed.set_silent(None);
                app.act_on_desk(|desk| desk::merge_project_items(desk, &known.work.items).len());
                app.page.rebuild();
            }
        },
    );
    if let Some(root) = document().document_element() {
        let _ = root.set_attribute("data-class", "ready");
    }
    if let Ok(ready) = Event::new(READY) {
        let _ = page_window().dispatch_event(&ready);
    }
}

async fn take(app: App, file: File) {
    let content = read(&file).await.unwrap_or(Err(HandInError::Damaged));
    app.class.update(&file.name(), content);
    app.class.compute();
}

/// The parts of the work; undefined if its items are as they were last time, or if the document has errors. `handed`: the items of
/// last time.
async fn hand_in(app: App, name: String, handed: Signal<Option<Items>>) -> Result<JsValue, JsValue> {
    let items = Some(app.read_desk(|desk| desk::project_items(desk, 0)));
    if handed.with_untracked(|before| *before == items) {
        return Ok(JsValue::UNDEFINED);
    }
    handed.set_silent(items);
    let made = publish::made(app, name).await;
    Ok(made.map_or(JsValue::UNDEFINED, |(hand_in, _)| class_page::array_of(&hand_in.parts())))
}
