//! How many frames can be tracked at once, known before any of them is decoded.

use crate::tracking::column::Settings;
use crate::tracking::{Plan, Refusal};

/// Grey values that the strips of a surface may hold, as in [`crate::tracking::column`].
const VALUES: usize = 48 << 20;
/// Rows of a strip at most.
const ROWS: usize = 8192;
/// Bins across a strip at most.
const BINS: usize = 20;
/// Half the width of a strip where the settings have none, as a part of the height of the picture.
const HALF_WIDTH: f64 = 1.0 / 16.0;

/// Refuses a plan with more frames than the strips of its surfaces have room for, in pictures of `size` (width, height in pixels,
/// as they are stored).
///
/// The room for bodies depends on their outline in the first picture; [`crate::tracking::Following::take`] checks it.
///
/// # Errors
/// [`Refusal::Long`] with the number of frames that fit.
pub fn check(plan: &Plan, size: [usize; 2]) -> Result<(), Refusal> {
    let most = plan.surfaces.iter().map(|surface| most_frames(&surface.settings, size)).min();
    match most.filter(|most| plan.frames.len() > *most) {
        Some(frames) => Err(Refusal::Long { frames }),
        None => Ok(()),
    }
}

/// Frames whose strips fit into memory.
fn most_frames(settings: &Settings, size: [usize; 2]) -> usize {
    let [wide, high] = size.map(|side| side as f64);
    let length = settings.tube.map_or(high - 1.0, |[[x, y], [u, v]]| {
        let (along, down) = (u - x, v - y);
        (along * along + down * down).sqrt()
    });
    let half = settings.half_width.filter(|half| half.is_finite()).unwrap_or(HALF_WIDTH * high).min(wide).max(2.0);
    let bins = BINS.min((2.0 * half) as usize).max(1);
    VALUES / ((length as usize).saturating_add(1).min(ROWS) * bins)
}
