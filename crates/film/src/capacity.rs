//! Upper bound of the number of frames that can be tracked at once, known before any frame is decoded.

use crate::tracking::{Plan, Refusal};

/// Checks that the strips of all surfaces in a plan fit into memory. `size`: width and height of the stored picture,
/// px.
///
/// The bound for bodies depends on their radius. [`crate::tracking::Following::take`] checks it as soon as the radius is certain, at most 32 frames
/// after the click.
///
/// # Errors
///
/// [`Refusal::Long`] with the number of frames that fit.
pub fn check(plan: &Plan, size: [usize; 2]) -> Result<(), Refusal> {
    let most = plan.surfaces.iter().map(|surface| surface.settings.most_frames(size)).min();
    match most.filter(|most| plan.frames.len() > *most) {
        Some(frames) => Err(Refusal::Long { frames }),
        None => Ok(()),
    }
}
