//! The evidence that a thing moves with the positions that are found for it.

use crate::plane::Plane;
use crate::tracking::body::background::Background;
use crate::tracking::body::departure::coherence;
use crate::tracking::body::disc::Disc;

/// Least way between two frames that are compared, in pixels and in radii.
const WAY: (f64, f64) = (2.0, 0.25);
/// Least coherence of pixels that move, and of pixels at rest with the opposite sign.
const COHERENT: f64 = 0.12;

/// Comparison of the pixels at successive positions. The pixels of a thing at rest, or of a wall that looks like the body, do not move with
/// the position.
pub(super) struct Moving {
    /// The frame that is compared next, and the position there.
    earlier: (Plane, [f64; 2]),
    /// Index of the last position with which pixels moved.
    pub last: usize,
    /// True if pixels have rested since then while the position moved.
    pub rests: bool,
}

impl Moving {
    /// Starts at a click, which is the position with this index.
    pub(super) fn new(plane: &Plane, position: [f64; 2], index: usize) -> Moving {
        Moving { earlier: (plane.clone(), position), last: index, rests: false }
    }

    /// Takes the position with this index. Pixels that agree with motion and rest alike change nothing.
    pub(super) fn take(
        &mut self,
        background: &Background,
        (plane, position): (&Plane, [f64; 2]),
        disc: Disc,
        index: usize,
    ) {
        let (earlier, from) = &self.earlier;
        let way = [0, 1].map(|k| position[k] - from[k]);
        if libm::hypot(way[0], way[1]) < WAY.0.max(WAY.1 * disc.outline) {
            return;
        }
        let (first, now) = (background.compare(earlier), background.compare(plane));
        let coherence = coherence(&first, &now, (disc.middle(*from), disc.outline), way);
        self.earlier = (plane.clone(), position);
        if coherence > COHERENT {
            (self.last, self.rests) = (index, false);
        } else if coherence < -COHERENT {
            self.rests = true;
        }
    }
}
