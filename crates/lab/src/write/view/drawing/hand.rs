//! Data shared by the views of the drawing.

use super::held::Held;
use super::seen::Seen;
use crate::app::App;
use document::drawing::Drawing;
use view::views::*;
use web_sys::MouseEvent;

/// Handle of the drawing views; cheap to copy.
#[derive(Clone, Copy)]
pub struct Hand {
    /// Handle of the laboratory.
    pub app: App,
    /// Text of the document in the editor.
    pub text: ReadSignal<String>,
    /// The drawing in this text.
    pub drawing: ReadSignal<Option<Drawing>>,
    /// Indices of the selected elements.
    pub chosen: Signal<Vec<usize>>,
    /// True if moved elements snap to the grid.
    pub grid: Signal<bool>,
    /// Geometry of all elements in the picture.
    pub seen: Signal<Option<Seen>>,
    /// Place of the last click in the picture, where new elements are drawn; at the centre if `None`.
    pub pointed: Signal<Option<[f64; 2]>>,
    /// The part held by the pointer.
    pub held: Signal<Option<Held>>,
    /// Reason why the last change was refused.
    pub refusal: Signal<Option<String>>,
}

impl Hand {
    /// Selects an element; with Shift or Control, adds it to the selection or removes it.
    pub fn choose(self, event: &MouseEvent, number: usize) {
        let adds = event.shift_key() || event.ctrl_key() || event.meta_key();
        self.chosen.update(|chosen| match chosen.iter().position(|one| *one == number) {
            Some(place) if adds => drop(chosen.remove(place)),
            None if adds => chosen.push(number),
            _ => *chosen = vec![number],
        });
    }
}
