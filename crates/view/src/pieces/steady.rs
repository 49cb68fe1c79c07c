//! Numbers that change in each frame.

use crate::views::*;
use web_sys::{HtmlElement, Text};

/// A text that changes in each frame. Its width depends on the number of characters, not on the digits, so that the
/// browser need not lay out its neighbours for other digits.
pub struct Steady {
    place: HtmlElement,
    text: Text,
    shown: String,
}

impl Steady {
    /// An empty text and its element.
    pub fn new() -> (Self, HtmlSpan) {
        let (mut place, mut inner) = (span(), span());
        let text = document().create_text_node("");
        let _ = inner.node::<HtmlElement>().append_child(&text);
        (Self { place: place.node(), text, shown: String::new() }, place.child(inner))
    }

    /// Text shown now.
    pub fn shown(&self) -> &str {
        &self.shown
    }

    /// Shows a text.
    pub fn show(&mut self, text: &str) {
        if text == self.shown {
            return;
        }
        if text.len() != self.shown.len() || is_number(text) != is_number(&self.shown) {
            self.place.set_class_name(if is_number(text) { "steady" } else { "" });
            let _ = self.place.style().set_property("--letters", &text.chars().count().to_string());
        }
        self.text.set_data(text);
        text.clone_into(&mut self.shown);
    }
}

/// True if a text is a number. Other texts contain letters wider than a digit, and change less often.
fn is_number(text: &str) -> bool {
    text.trim_start_matches(['(', '-', '−', '+']).starts_with(|letter: char| letter.is_ascii_digit())
}

/// Element with a text that changes with a signal.
pub fn steady(text: impl FnMut() -> String + 'static) -> HtmlSpan {
    let (mut steady, element) = Steady::new();
    let text = memo(text);
    effect(move || text.with(|text| steady.show(text)));
    element
}
