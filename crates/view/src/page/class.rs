//! What a page offers to the script of a class server (`crates/server/src/pages/student.js`).

use crate::browser;
use crate::views::window;
use handed::parts::Parts;
use js_sys::{Array, Function, Object, Promise, Reflect};
use wasm_bindgen::closure::Closure;
use wasm_bindgen::{JsCast, JsValue};

/// Element that the class server puts into its pages.
const CONFIG: &str = "class-config";

/// Object of the page for the script.
const PAGE: &str = "classPage";

/// Function of the script that takes the answers to a survey.
const SURVEY: &str = "classSurvey";

/// True for a page of a class server.
pub fn is_here() -> bool {
    browser::by_id::<web_sys::Element>(CONFIG).is_some()
}

/// Offers three functions to the script in the object `classPage`. `handIn(name)` makes a promise of the parts of the hand-in
/// ([`array_of`]), or of nothing if the work is as it was at the last call. `merge(text)` takes the hand-in that the server has of the
/// same seat, perhaps from another device. `leave()` ends storing, before the script removes what the browser has of a person.
pub fn offer(hand_in: impl Fn(String) -> Promise + 'static, merge: impl Fn(String) + 'static) {
    let hand_in = Closure::<dyn Fn(String) -> JsValue>::new(move |name| hand_in(name).into());
    let merge = Closure::<dyn Fn(String)>::new(merge);
    let leave = Closure::<dyn Fn()>::new(browser::end_remembering);
    let page = Object::new();
    let functions = [hand_in.into_js_value(), merge.into_js_value(), leave.into_js_value()];
    for (name, function) in ["handIn", "merge", "leave"].into_iter().zip(functions) {
        let _ = Reflect::set(&page, &name.into(), &function);
    }
    let _ = Reflect::set(&window(), &PAGE.into(), &page);
}

/// The parts of a hand-in as pairs of a name and a text.
pub fn array_of(parts: &Parts<'_>) -> JsValue {
    let pair = |(name, text): (String, String)| Array::of2(&name.into(), &text.into());
    parts.named().into_iter().map(pair).collect::<Array>().into()
}

/// Passes answers to a survey to the script, which sends them apart from the seat. Does nothing in any other page.
pub fn give_survey(text: &str) {
    let take = Reflect::get(&window(), &SURVEY.into()).ok().and_then(|take| take.dyn_into::<Function>().ok());
    if let Some(take) = take {
        let _ = take.call1(&JsValue::UNDEFINED, &text.into());
    }
}
