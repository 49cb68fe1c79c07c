//! Pages of a class server. The script of the teacher's page passes hand-ins as they arrive, that of a student's page takes the work.

use super::{survey, window};
use crate::app::App;
use crate::publish;
use crate::verifying::reading::read;
use class::collection::References;
use desk::saved::hand_in::{HandIn, HandInError};
use view::browser;
use view::views::{Signal, create_signal, document, window as page_window};
use wasm_bindgen::JsCast;
use web_sys::{CustomEvent, CustomEventInit, Event, File};

/// Element that the class server puts into its pages.
const CONFIG: &str = "class-config";
/// Events of the teacher's script: the documents of the class, open the dashboard, a hand-in as a file, a list of answers to surveys.
const DOCUMENTS: &str = "class-documents";
const OPEN: &str = "class-open";
const HAND_IN: &str = "class-hand-in";
const SHEETS: &str = "class-sheets";
/// Event of the student's script: hand in under this name. `MADE` answers with the text of the hand-in.
const ASKED: &str = "class-hand-in-asked";
const MADE: &str = "class-hand-in-made";
/// Event of the student's script: the hand-in that the server has of this seat, perhaps from another device.
const KNOWN: &str = "class-hand-in-known";
/// Tells the script that this page listens.
const READY: &str = "class-ready";

/// Names and texts of items.
type Items = Vec<(String, String)>;

/// Listens to the script of a class server; does nothing in any other page.
pub fn listen(app: App) {
    if browser::by_id::<web_sys::Element>(CONFIG).is_none() {
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
    browser::listen(ASKED, move |event: &CustomEvent| {
        wasm_bindgen_futures::spawn_local(hand_in(app, event.detail().as_string().unwrap_or_default(), handed));
    });
    browser::listen(KNOWN, move |event: &CustomEvent| {
        let known = event.detail().as_string().and_then(|text| HandIn::read(&text).ok());
        if let Some(known) = known {
            app.act_on_desk(|desk| desk::merge_project_items(desk, &known.work.items).len());
            app.page.rebuild();
        }
    });
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

/// Passes the work to the script if its items have changed. `handed`: the items of last time.
async fn hand_in(app: App, name: String, handed: Signal<Option<Items>>) {
    // Without the time of storage, which changes alone.
    let items = Some(app.read_desk(|desk| desk::project_items(desk, 0)));
    if handed.with_untracked(|before| *before == items) {
        return;
    }
    handed.set_silent(items);
    if let Some((hand_in, _)) = publish::made(app, name).await {
        let options = CustomEventInit::new();
        options.set_detail(&hand_in.write().into());
        if let Ok(made) = CustomEvent::new_with_event_init_dict(MADE, &options) {
            let _ = page_window().dispatch_event(&made);
        }
    }
}
