//! How many frames can be tracked at once, known before any of them is decoded.

use crate::tracking::{Plan, Refusal};

/// Refuses a plan with more frames than the strips of its surfaces have room for, in pictures of `size` (width, height in pixels,
/// as they are stored).
///
/// The room for bodies depends on their outline in the first picture; [`crate::tracking::Following::take`] checks it.
///
/// # Errors
/// [`Refusal::Long`] with the number of frames that fit.
pub fn check(plan: &Plan, size: [usize; 2]) -> Result<(), Refusal> {
    let most = plan.surfaces.iter().map(|surface| surface.settings.most_frames(size)).min();
    match most.filter(|most| plan.frames.len() > *most) {
        Some(frames) => Err(Refusal::Long { frames }),
        None => Ok(()),
    }
}
