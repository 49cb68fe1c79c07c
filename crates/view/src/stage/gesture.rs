//! State of the pointers on a plot.

/// Pointers pressed on a canvas.
#[derive(Default)]
pub struct Gesture {
    pub(super) fingers: Vec<(i32, f64, f64)>,
    /// Start and present corner of the zoom rectangle, in pixels.
    pub(super) rectangle: Option<((f64, f64), (f64, f64))>,
    /// Start position of a single pointer while it may still become a press: a mouse that moves pans, a finger reads.
    pub(super) pressed: Option<(f64, f64)>,
    /// Index of the brush end that is being dragged.
    pub(super) end: Option<usize>,
}

impl Gesture {
    /// Zoom rectangle being drawn: start and present corner, in pixels.
    pub fn rectangle(&self) -> Option<((f64, f64), (f64, f64))> {
        self.rectangle
    }
}
