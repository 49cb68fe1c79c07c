//! What is in sight: only that has to follow a run while it goes on.

use crate::views::*;
use sycamore_reactive::on_cleanup;
use wasm_bindgen::JsCast;
use wasm_bindgen::closure::Closure;
use web_sys::{Element, IntersectionObserver, IntersectionObserverEntry};

/// Reports whether an element is in sight, until it is dropped.
pub struct Sight {
    observer: Option<IntersectionObserver>,
    /// Kept as long as the observer calls it.
    _callback: Closure<dyn FnMut(js_sys::Array)>,
}

impl Sight {
    /// Calls `react` when the browser has first looked, and whenever the element comes into sight or goes out of it.
    pub fn of(element: &Element, react: impl FnMut(bool) + 'static) -> Self {
        let mut react: Box<dyn FnMut(bool)> = Box::new(react);
        let callback = Closure::<dyn FnMut(js_sys::Array)>::new(move |entries: js_sys::Array| {
            let entry: Option<IntersectionObserverEntry> = entries.pop().dyn_into().ok();
            if let Some(entry) = entry {
                react(entry.is_intersecting());
            }
        });
        let observer = IntersectionObserver::new(callback.as_ref().unchecked_ref()).ok();
        if let Some(observer) = &observer {
            observer.observe(element);
        }
        Self { observer, _callback: callback }
    }
}

impl Drop for Sight {
    fn drop(&mut self) {
        if let Some(observer) = &self.observer {
            observer.disconnect();
        }
    }
}

/// Whether an element is in sight; taken to be so until the browser has said it.
pub fn in_sight(element: &Element) -> ReadSignal<bool> {
    let seen = create_signal(true);
    let sight = Sight::of(element, move |is_seen| seen.set(is_seen));
    on_cleanup(move || drop(sight));
    *seen
}
