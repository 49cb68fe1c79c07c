//! Reports the height of the page to the surrounding page: `{ meniscus: { height } }`, in CSS pixels.

use crate::surrounding::say;
use std::cell::Cell;
use view::views::{document, window};
use wasm_bindgen::JsCast;
use wasm_bindgen::closure::Closure;
use web_sys::ResizeObserver;

/// Makes the page as high as its content and reports its height on every change.
pub fn tell() {
    let (Some(root), Some(body)) = (document().document_element(), document().body()) else { return };
    let _ = root.set_attribute("data-height", "content");
    let told = Cell::new(0.0);
    let content = body.clone();
    let changed = Closure::<dyn FnMut()>::new(move || {
        let height = content.get_bounding_client_rect().height().ceil();
        if told.replace(height) != height
            && let Ok(Some(parent)) = window().parent()
        {
            say(&parent, "height", &height.into());
        }
    });
    if let Ok(observer) = ResizeObserver::new(changed.as_ref().unchecked_ref()) {
        observer.observe(&body);
    }
    changed.forget();
}
