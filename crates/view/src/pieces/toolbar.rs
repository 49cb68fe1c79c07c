//! Toolbars: groups of buttons that are one stop of Tab.

use crate::views::*;
use wasm_bindgen::JsCast;
use web_sys::{Element, HtmlElement, KeyboardEvent};

/// Toolbar: one stop of Tab, the place of the button that had the focus last. Arrow keys move within it.
#[derive(Clone, Copy)]
pub struct Toolbar(Signal<usize>);

impl Toolbar {
    /// A toolbar with the stop at its first button.
    pub fn new() -> Self {
        Self(create_signal(0))
    }

    /// The focus is on the button at this place.
    pub fn enter(self, place: usize) {
        self.0.set(place);
    }

    /// `tabindex` of the button at a place.
    pub fn stop(self, place: usize) -> &'static str {
        if self.0.get() == place { "0" } else { "-1" }
    }

    /// Moves the focus by arrow keys, cyclically.
    pub fn turn(event: KeyboardEvent) {
        let forward = match event.key().as_str() {
            "ArrowRight" => true,
            "ArrowLeft" => false,
            _ => return,
        };
        let bar = event.current_target().and_then(|bar| bar.dyn_into::<Element>().ok());
        let found = bar.and_then(|bar| bar.query_selector_all("button:not([hidden])").ok());
        let Some(found) = found else { return };
        let buttons = (0..found.length()).filter_map(|index| found.get(index)?.dyn_into().ok());
        // Without those that the style sheet leaves out.
        let buttons: Vec<HtmlElement> = buttons.filter(|button: &HtmlElement| button.offset_width() > 0).collect();
        let focused = document().active_element();
        let at = buttons.iter().position(|button| focused.as_ref() == Some(button.as_ref()));
        let Some(at) = at else { return };
        let next = if forward { at + 1 } else { at + buttons.len() - 1 };
        if let Some(button) = buttons.get(next % buttons.len()) {
            event.prevent_default();
            let _ = button.focus();
        }
    }
}
