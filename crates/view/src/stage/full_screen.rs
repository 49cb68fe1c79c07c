//! Full-screen mode for single plots. Some browsers do not support it.

use crate::views::document;
use web_sys::Element;

/// True if the browser supports full-screen mode.
pub fn is_offered() -> bool {
    document().fullscreen_enabled()
}

/// Switches full-screen mode of an element on, or leaves it.
pub fn toggle(element: &Element) {
    if document().fullscreen_element().is_some() {
        document().exit_fullscreen();
    } else {
        // If refused, the page stays as it is.
        let _ = element.request_fullscreen();
    }
}
