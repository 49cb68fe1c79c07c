//! A frame as grey values.

/// The grey values of one frame, or of a part of it, row by row from the top. Coordinates count pixels: `x` to the right, `y`
/// downwards, and the middle of the first pixel is at (0.5, 0.5).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Plane {
    width: usize,
    height: usize,
    grey: Vec<u8>,
}

impl Plane {
    /// The picture of `width` times `height` pixels; `None` if `grey` does not hold exactly one value for each of them.
    pub fn new(width: usize, height: usize, grey: Vec<u8>) -> Option<Plane> {
        (width.checked_mul(height) == Some(grey.len())).then_some(Plane { width, height, grey })
    }

    /// Pixels in a row.
    pub fn width(&self) -> usize {
        self.width
    }

    /// Rows.
    pub fn height(&self) -> usize {
        self.height
    }

    /// The values, row by row from the top.
    pub fn grey(&self) -> &[u8] {
        &self.grey
    }
}
