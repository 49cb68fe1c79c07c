//! What the pointer holds of a drawing.

use document::drawing::Grip;

/// A drag by fewer CSS pixels moves nothing.
const STILL: f64 = 3.0;
/// What the pointer holds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Held {
    /// The pointer, as the browser numbers it.
    pub pointer: i32,
    /// Which grip of which element.
    pub grip: (usize, Grip),
    /// Where in the picture it took hold.
    pub from: [f64; 2],
    /// Where it is now.
    pub at: [f64; 2],
    /// How large a CSS pixel is there.
    pub pixel: f64,
}

impl Held {
    /// Whether it has been moved and not only pressed.
    pub fn is_moved(&self) -> bool {
        let [right, down] = self.way();
        libm::hypot(right, down) > STILL * self.pixel
    }

    /// How far it has been moved.
    pub fn way(&self) -> [f64; 2] {
        [self.at[0] - self.from[0], self.at[1] - self.from[1]]
    }
}
