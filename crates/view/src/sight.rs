//! What is in sight: only that has to follow a run while it goes on.

use crate::views::*;
use sycamore_reactive::on_cleanup;
use wasm_bindgen::JsCast;
use wasm_bindgen::closure::Closure;
use web_sys::{Element, IntersectionObserver, IntersectionObserverEntry};

/// Whether an element is in sight; taken to be so until the browser has said it.
pub fn in_sight(element: &Element) -> ReadSignal<bool> {
    let seen = create_signal(true);
    let told = Closure::<dyn FnMut(js_sys::Array)>::new(move |entries: js_sys::Array| {
        let entry: Option<IntersectionObserverEntry> = entries.pop().dyn_into().ok();
        if let Some(entry) = entry {
            seen.set(entry.is_intersecting());
        }
    });
    if let Ok(observer) = IntersectionObserver::new(told.as_ref().unchecked_ref()) {
        observer.observe(element);
        on_cleanup(move || {
            observer.disconnect();
            drop(told);
        });
    }
    *seen
}
