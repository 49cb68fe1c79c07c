//! Visibility of elements: only visible ones must be updated while a run plays.

use crate::views::*;
use sycamore_reactive::on_cleanup;
use wasm_bindgen::JsCast;
use wasm_bindgen::closure::Closure;
use web_sys::{Element, IntersectionObserver, IntersectionObserverEntry};

/// Observes the visibility of an element until it is dropped.
pub struct Sight {
    observer: Option<IntersectionObserver>,
    /// Kept alive for the observer.
    _callback: Closure<dyn FnMut(js_sys::Array)>,
}

impl Sight {
    /// Calls `react` after the browser's first check, and whenever the element becomes visible or invisible.
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

/// Signal that is true while an element is visible, and until the browser's first check.
pub fn in_sight(element: &Element) -> ReadSignal<bool> {
    let seen = create_signal(true);
    let sight = Sight::of(element, move |is_seen| seen.set(is_seen));
    on_cleanup(move || drop(sight));
    *seen
}
