//! A part of a frame.

use crate::plane::Plane;

/// The part of a frame whose first pixel is at `corner`.
#[derive(Clone, Debug)]
pub(crate) struct Part {
    pub plane: Plane,
    pub corner: [f64; 2],
}

impl Part {
    /// The part of a frame within so many pixels of a point; `None` outside the picture.
    pub(crate) fn around(plane: &Plane, [x, y]: [f64; 2], reach: f64) -> Option<Part> {
        let (left, top) = ((x - reach).floor().max(0.0), (y - reach).floor().max(0.0));
        let size = |at: f64, first: f64| ((at + reach).ceil() - first).max(0.0) as usize;
        let plane = plane.crop(left as usize, top as usize, size(x, left), size(y, top))?;
        Some(Part { plane, corner: [left, top] })
    }

    pub(crate) fn at(&self, x: f64, y: f64) -> f64 {
        self.plane.cubic(x - self.corner[0], y - self.corner[1])
    }

    /// The value and its derivatives.
    pub(crate) fn jet(&self, x: f64, y: f64) -> (f64, [f64; 2]) {
        let across = self.at(x + 0.5, y) - self.at(x - 0.5, y);
        let down = self.at(x, y + 0.5) - self.at(x, y - 0.5);
        (self.at(x, y), [across, down])
    }
}
