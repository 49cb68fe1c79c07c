//! What pointers are doing on a plot.

/// The pointers that are down on a canvas.
#[derive(Default)]
pub struct Gesture {
    pub(super) fingers: Vec<(i32, f64, f64)>,
    /// Where a zoom rectangle began and where it is now.
    pub(super) rectangle: Option<((f64, f64), (f64, f64))>,
    /// Where a single pointer went down, as long as it may become a press: a mouse that moves pans, a finger reads.
    pub(super) pressed: Option<(f64, f64)>,
    /// The end of the brush that is being dragged.
    pub(super) end: Option<usize>,
}

impl Gesture {
    /// The zoom rectangle that is being drawn.
    pub fn rectangle(&self) -> Option<((f64, f64), (f64, f64))> {
        self.rectangle
    }
}
