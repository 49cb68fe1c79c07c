//! State of a drag in the drawing.

use document::drawing::Grip;

/// Minimum length of a drag that moves anything, in CSS pixels.
const STILL: f64 = 3.0;
/// The part held by the pointer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Held {
    /// Pointer id of the browser.
    pub pointer: i32,
    /// Element index and grip.
    pub grip: (usize, Grip),
    /// Start position, in picture units.
    pub from: [f64; 2],
    /// Present position, in picture units.
    pub at: [f64; 2],
    /// Size of a CSS pixel, in picture units.
    pub pixel: f64,
}

impl Held {
    /// True if the pointer has moved and not only been pressed.
    pub fn is_moved(&self) -> bool {
        let [right, down] = self.way();
        libm::hypot(right, down) > STILL * self.pixel
    }

    /// Displacement from the start, in picture units.
    pub fn way(&self) -> [f64; 2] {
        [self.at[0] - self.from[0], self.at[1] - self.from[1]]
    }
}
