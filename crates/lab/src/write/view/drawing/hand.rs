//! What the views of the drawing share.

use super::held::Held;
use super::seen::Seen;
use crate::app::App;
use document::drawing::Drawing;
use view::views::*;
use web_sys::MouseEvent;

/// The handle; copied freely.
#[derive(Clone, Copy)]
pub struct Hand {
    /// The laboratory.
    pub app: App,
    /// The text of the document as it stands in the editor.
    pub text: ReadSignal<String>,
    /// The drawing as it is written there.
    pub drawing: ReadSignal<Option<Drawing>>,
    /// The numbers of the elements that are chosen.
    pub chosen: Signal<Vec<usize>>,
    /// Whether what is moved comes to lie on the grid.
    pub grid: Signal<bool>,
    /// Where everything stands in the picture.
    pub seen: Signal<Option<Seen>>,
    /// Where in the picture the author has clicked last: there new elements are drawn, otherwise in its middle.
    pub pointed: Signal<Option<[f64; 2]>>,
    /// What the pointer holds.
    pub held: Signal<Option<Held>>,
    /// Why the last change was refused.
    pub refusal: Signal<Option<String>>,
}

impl Hand {
    /// Chooses an element; with Shift or Control beside those that are chosen, or no longer.
    pub fn choose(self, event: &MouseEvent, number: usize) {
        let adds = event.shift_key() || event.ctrl_key() || event.meta_key();
        self.chosen.update(|chosen| match chosen.iter().position(|one| *one == number) {
            Some(place) if adds => drop(chosen.remove(place)),
            None if adds => chosen.push(number),
            _ => *chosen = vec![number],
        });
    }
}
