//! What the views of the drawing share.

use super::held::Held;
use super::seen::Seen;
use crate::app::App;
use document::drawing::Drawing;
use view::views::*;

/// The handle; copied freely.
#[derive(Clone, Copy)]
pub struct Hand {
    /// The laboratory.
    pub app: App,
    /// The drawing as it is written.
    pub drawing: ReadSignal<Option<Drawing>>,
    /// The numbers of the elements that are chosen.
    pub chosen: Signal<Vec<usize>>,
    /// Whether what is moved comes to lie on the grid.
    pub grid: Signal<bool>,
    /// Where everything stands in the picture.
    pub seen: Signal<Option<Seen>>,
    /// What the pointer holds.
    pub held: Signal<Option<Held>>,
    /// Why the last change was refused.
    pub refusal: Signal<Option<String>>,
}
