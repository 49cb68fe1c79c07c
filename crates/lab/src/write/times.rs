//! Formatting of the times of changes.

use crate::app::App;
use js_sys::{Date, Object, Reflect};
use wasm_bindgen::JsValue;

/// Date and time in the format of the page's language. `time` is in milliseconds.
pub fn time_text(app: App, time: u64) -> String {
    let options = Object::new();
    for (name, value) in [("dateStyle", "medium"), ("timeStyle", "medium")] {
        let _ = Reflect::set(&options, &name.into(), &value.into());
    }
    let locale = app.language.get_untracked().say("en-GB");
    let text = Date::new(&JsValue::from(time as f64)).to_locale_string(locale, &options);
    text.as_string().unwrap_or_default()
}
