//! The full screen, for the stage and for single plots. Some browsers offer none.

use crate::views::document;
use web_sys::Element;

/// Whether the browser can fill the screen with a part of the page.
pub fn is_offered() -> bool {
    document().fullscreen_enabled()
}

/// Fills the screen with an element, or gives the screen back.
pub fn toggle(element: &Element) {
    if document().fullscreen_element().is_some() {
        document().exit_fullscreen();
    } else {
        // A refusal leaves the page as it is.
        let _ = element.request_fullscreen();
    }
}
