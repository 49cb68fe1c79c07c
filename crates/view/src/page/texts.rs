//! Texts of the languages. The page carries them packed, those of each module by themselves; English stands in the module.

use crate::browser;
use js_sys::{Function, Promise, Reflect, Uint8Array};
use units::{Catalogue, Language};
use wasm_bindgen::{JsCast, JsValue};

/// Beginning of the ids of the elements with texts for the player.
pub const PLAYER: &str = "texts";
/// The same for the laboratory.
pub const LABORATORY: &str = "laboratory-texts";

/// Calls `then` when the texts of a language are there: at once if the page has inflated them, otherwise afterwards. If the
/// page has none, they stay English. `module`: beginning of the ids of their elements.
pub fn when_there(module: &'static str, language: Language, then: impl FnOnce() + 'static) {
    if Catalogue::is_installed(language) || install(language, &ready(module, language)) {
        return then();
    }
    wasm_bindgen_futures::spawn_local(async move {
        load(module, language).await;
        then();
    });
}

/// Loads the texts of a language, if the page has them.
pub async fn load(module: &str, language: Language) {
    let load = || field(&texts(), "load").dyn_into::<Function>().ok();
    if !Catalogue::is_installed(language)
        && let Some(promise) = load().and_then(|load| load.call1(&JsValue::UNDEFINED, &id(module, language)).ok())
        && let Ok(promise) = promise.dyn_into::<Promise>()
        && let Ok(bytes) = browser::wait(promise).await
    {
        install(language, &bytes);
    }
}

/// Installs packed texts; false if these are none.
fn install(language: Language, bytes: &JsValue) -> bool {
    let bytes = bytes.dyn_ref::<Uint8Array>().map(Uint8Array::to_vec);
    bytes.map(|bytes| Catalogue::unpack(&bytes).install(language)).is_some()
}

/// Texts that the script of the page has inflated already; undefined otherwise.
fn ready(module: &str, language: Language) -> JsValue {
    Reflect::get(&field(&texts(), "ready"), &id(module, language)).unwrap_or(JsValue::UNDEFINED)
}

/// Object of the page's script (`crates/view/page/boot.js`).
fn texts() -> JsValue {
    field(&js_sys::global(), "texts")
}

fn field(object: &JsValue, name: &str) -> JsValue {
    Reflect::get(object, &name.into()).unwrap_or(JsValue::UNDEFINED)
}

fn id(module: &str, language: Language) -> JsValue {
    format!("{module}-{}", language.tag()).into()
}
