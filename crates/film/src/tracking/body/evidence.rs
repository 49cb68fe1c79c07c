//! Evidence that a template shows the clicked body as a whole.

use crate::tracking::body::refining::Seen;
use crate::tracking::body::template::Template;
use crate::tracking::median::median;
use crate::tracking::smooth::Motion;

/// Number of frames from a key frame on whose motion shows that a body was followed that was lost then.
const SHORTEST: usize = 8;
/// The picture of a click is not that of the body if what it leaves unexplained is so many times larger than usual, with an addition.
const UNLIKE: (f64, f64) = (5.0, 0.02);
/// Minimum distance of such a click from where the next frames lead, px and relative to the radius, and the number of those frames.
const BESIDE: (f64, f64) = (5.0, 0.3);
const BACK: usize = 4;
/// Fraction of the ring around a disc that does not show the background, from which something larger moves there, and maximum fraction of the
/// frames in which that may be so around a whole body.
const LARGER: (f32, f64) = (0.5, 0.5);

/// Evidence of a template.
#[derive(Clone, Copy, Debug)]
pub(super) struct Evidence {
    /// True once the disc has moved as a whole.
    pub moved: bool,
    /// True if the outline is given, or is that of the pixels that the body has left.
    pub is_outline_certain: bool,
}

impl Evidence {
    /// True if the template with this index shows the body. `was_lost`: true if the body was lost in a frame.
    pub(super) fn is_shown(self, (seen, key): (&[Seen], usize), template: Option<&Template>, was_lost: bool) -> bool {
        let of: Vec<&Seen> = seen.iter().filter(|one| one.key == key).collect();
        let is_long = of.len() >= SHORTEST || !was_lost;
        let begins_beside = || template.is_some_and(|template| begins_beside(&of, template));
        self.moved && is_long && moves_mostly(&of) && (self.is_outline_certain || !is_part(&of)) && !begins_beside()
    }
}

/// True if the pixels rest in fewer frames than they move.
fn moves_mostly(of: &[&Seen]) -> bool {
    2 * of.iter().filter(|one| one.moves).count() >= of.len()
}

/// True if the ring around the disc does not show the background in most frames: the disc is a part of a larger body, which may turn.
fn is_part(of: &[&Seen]) -> bool {
    let inside = of.iter().filter(|one| one.outside > LARGER.0).count();
    inside as f64 > LARGER.1 * of.len() as f64
}

/// True if the frame of a click looks unlike all others, and the motion in the next ones does not lead back to the click: the template of two
/// bodies, one of which covered the other, is found beside either of them.
fn begins_beside(of: &[&Seen], template: &Template) -> bool {
    let Some(first) = of.first().filter(|_| of.len() >= SHORTEST) else { return false };
    let usual = median(of.iter().map(|one| one.now.score).collect());
    let is_unlike = |one: &Seen| 1.0 - one.now.score > UNLIKE.0 * (1.0 - usual) + UNLIKE.1;
    // Frames in which the body is disturbed as well tell nothing about the click.
    if !is_unlike(first) || of.iter().skip(1).take(BACK).any(|one| is_unlike(one)) {
        return false;
    }
    let motion = Motion::new(of.iter().map(|one| one.time).collect(), of.iter().map(|one| one.now.position).collect());
    let length = |[x, y]: [f64; 2]| libm::hypot(x, y);
    let off = length(motion.back(&[1, 2, 3])).min(length(motion.back(&[1, 2, 3, 4])));
    off > BESIDE.0.max(BESIDE.1 * template.disc.outline)
}
