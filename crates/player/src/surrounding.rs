//! Parameters in both directions between this page and a page around it, such as a notebook, by messages of the browser:
//! `{ meniscus: { parameters: { b: 250 } } }`, numbers in declared units, and words of choices. This page answers each message with
//! all its values, and afterwards tells each change. A page around it that says nothing hears nothing of them.

use js_sys::{Object, Reflect};
use program::Parameter;
use std::cell::Cell;
use std::rc::Rc;
use view::App;
use view::browser;
use view::views::{effect, window};
use wasm_bindgen::JsValue;
use web_sys::{MessageEvent, Window};

/// Listens to the page around this one, if there is one.
pub fn follow(app: App) {
    // The window of a page that nothing surrounds is its own parent.
    let Some(parent) = window().parent().ok().flatten().filter(|parent| *parent != window()) else { return };
    let is_asked = Rc::new(Cell::new(false));
    let (asked, speaker) = (Rc::clone(&is_asked), parent.clone());
    browser::listen("message", move |event: &MessageEvent| {
        let wanted = part(&event.data(), "meniscus").and_then(|said| part(&said, "parameters"));
        let is_parent = event.source().is_some_and(|source| Object::is(&source, &speaker));
        let Some(wanted) = wanted.filter(|_| is_parent) else { return };
        asked.set(true);
        set(app, &wanted);
        tell(app, &speaker);
    });
    effect(move || {
        app.changes.parameters.track();
        if is_asked.get() {
            tell(app, &parent);
        }
    });
}

/// Member of an object that is an object itself.
fn part(value: &JsValue, name: &str) -> Option<JsValue> {
    Reflect::get(value, &name.into()).ok().filter(JsValue::is_object)
}

/// Sets the parameters that have a number or a word among these members. A refusal is shown in the page.
fn set(app: App, wanted: &JsValue) {
    let values: Vec<(usize, f64)> = app.read(|play| {
        let model = play.model();
        let value = |(index, parameter): (usize, &Parameter)| {
            let value = Reflect::get(wanted, &parameter.name.as_str().into()).ok()?;
            let value = match value.as_string() {
                Some(word) => parameter.chosen(&word, &model.texts),
                None => value.as_f64().map(|number| parameter.unit.to_si(number)),
            };
            value.map(|value| (index, value))
        };
        let shown = model.parameters.iter().enumerate().filter(|(_, parameter)| parameter.is_shown());
        shown.filter_map(value).collect()
    });
    for (index, value) in values {
        let set = app.attempt(|play| play.change_settings(|settings| settings.set_parameter(index, value)));
        if let Some(refusal) = set {
            app.complain(refusal);
        }
    }
}

/// Sends the values of all parameters.
fn tell(app: App, parent: &Window) {
    let values = Object::new();
    app.read(|play| {
        let model = play.model();
        let all = model.parameters.iter().zip(play.course().parameters());
        for (parameter, value) in all.filter(|(parameter, _)| parameter.is_shown()) {
            let value = match parameter.word(*value, &model.texts) {
                Some(word) => word.into(),
                None => parameter.unit.from_si(*value).into(),
            };
            let _ = Reflect::set(&values, &parameter.name.as_str().into(), &value);
        }
    });
    say(parent, "parameters", &values);
}

/// Sends `{ meniscus: { name: value } }` to a page around this one, whoever it is: nothing in it may be confidential.
pub fn say(parent: &Window, name: &str, value: &JsValue) {
    let (message, said) = (Object::new(), Object::new());
    let _ = Reflect::set(&said, &name.into(), value);
    let _ = Reflect::set(&message, &"meniscus".into(), &said);
    let _ = parent.post_message(&message, "*");
}
