//! Class server that the page belongs to: takes the answers that it has of the same seat, perhaps from another device.

use crate::answers;
use js_sys::{Array, JSON, Reflect};
use play::{Answer, Attempt, Conditions, Grade};
use view::views::*;
use view::{App, browser};
use wasm_bindgen::JsValue;
use web_sys::CustomEvent;

/// Element that the class server puts into its pages.
const CONFIG: &str = "class-config";
/// Event of the server's script: the text of a hand-in.
const KNOWN: &str = "class-hand-in-known";

/// Listens to the script of a class server; does nothing in any other page.
pub fn listen(app: App) {
    if browser::by_id::<web_sys::Element>(CONFIG).is_none() {
        return;
    }
    browser::listen(KNOWN, move |event: &CustomEvent| {
        let known = event.detail().as_string().and_then(|text| JSON::parse(&text).ok());
        let items = known.map(|known| items(&known)).unwrap_or_default();
        app.act(|play| {
            for (name, answer) in &items {
                play.change_answers(|answers, run| answers.merge(run, name, answer));
            }
        });
        answers::save(app);
        app.rebuild();
    });
    if let Some(root) = document().document_element() {
        let _ = root.set_attribute("data-class", "listens");
    }
}

/// Value at a path of keys; undefined if there is none.
fn at(value: &JsValue, path: &[&str]) -> JsValue {
    let next = |value: JsValue, key: &&str| Reflect::get(&value, &(*key).into()).unwrap_or(JsValue::UNDEFINED);
    path.iter().fold(value.clone(), next)
}

fn text(value: &JsValue, key: &str) -> Option<String> {
    at(value, &[key]).as_string()
}

/// Elements of a list; none if it is no list.
fn list(value: &JsValue) -> Vec<JsValue> {
    if Array::is_array(value) { Array::from(value).to_vec() } else { Vec::new() }
}

/// Names of questions, and answers.
fn items(hand_in: &JsValue) -> Vec<(String, Answer)> {
    let items = list(&at(hand_in, &["work", "items"]));
    items
        .iter()
        .filter_map(|item| Some((text(item, "name")?, answer(&at(item, &["item", "item", "answer"]))?)))
        .collect()
}

/// `None` if it is no answer.
fn answer(value: &JsValue) -> Option<Answer> {
    let attempts: Vec<Attempt> = list(&at(value, &["attempts"])).iter().filter_map(attempt).collect();
    let is = |key: &str| at(value, &[key]).is_truthy();
    let shown = at(value, &["shown"]).as_f64().map(|before| before as usize);
    Some(Answer {
        typed: text(value, "typed")?,
        grade: text(value, "grade").and_then(|code| Grade::from_code(&code)),
        shown: shown.or_else(|| Answer::shown_of_0_2(is("revealed"), is("found"), attempts.len())),
        attempts,
    })
}

fn attempt(value: &JsValue) -> Option<Attempt> {
    // Numbers that are not finite stand as texts.
    let number = |value: &JsValue| value.as_f64().unwrap_or(f64::NAN);
    let values = list(&at(value, &["values"]));
    let values = values.iter().filter_map(|pair| Some((text(pair, "0")?, number(&at(pair, &["1"])))));
    Some(Attempt {
        typed: text(value, "typed")?,
        grade: Grade::from_code(&text(value, "grade")?)?,
        conditions: text(value, "language").map(|language| Conditions { language, values: values.collect() }),
    })
}
