//! Class server that the page belongs to: hands in to its script, and takes the answers that it has of the same seat, perhaps from
//! another device.

use crate::{answers, hand_in};
use js_sys::{Array, JSON, Promise, Reflect};
use play::{Answer, Attempt, Conditions, Grade};
use view::{App, page::class};
use wasm_bindgen::JsValue;

/// Offers hand-ins to the script of a class server; does nothing in any other page.
pub fn listen(app: App) {
    if !class::is_here() {
        return;
    }
    let hand_in = move |name: String| {
        let made = app.read(|play| hand_in::made(play, &name));
        Promise::resolve(&made.map_or(JsValue::UNDEFINED, |made| class::array_of(&made.parts)))
    };
    let merge = move |text: String| {
        let items = JSON::parse(&text).map(|known| items(&known)).unwrap_or_default();
        app.act(|play| {
            for (name, answer) in &items {
                play.change_answers(|answers, run| answers.merge(run, name, answer));
            }
        });
        answers::save(app);
        app.rebuild();
    };
    class::offer(hand_in, merge);
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
