//! Errors of films in which compression suppresses small changes of the picture.
//!
//! A slow and small motion then lags by up to the suppressed change, like a gear with play. The lag has nearly the
//! frequency of the motion: differences of the track do not show it, and the residual of a sinusoid is about a third of
//! it.

use crate::tracking::column::amplitude::WIDEST;
use crate::tracking::column::strip::Strip;
use crate::tracking::median::median;
use crate::tracking::readout;

/// Maximum number of values compared per pair of strips.
const COMPARED: usize = 1500;
/// Maximum difference of equal normalized values, in 1/256 of a grey value.
const SAME: u16 = 8;
/// Minimum fraction of values that stay equal between frames (median over the film) if compression suppresses changes.
/// Noise without compression leaves at most 0.03.
const KEPT: f64 = 0.1;
/// Maximum squared ratio of the changes over one frame to those over two (medians) if compression suppresses changes. Noise without compression
/// has at least 0.98, since it does not last.
const LASTING: f64 = 0.95;
/// Standard error of a slow motion in multiples of the residual of a sinusoid. Observed: 1 to 5 in coarse films.
const PLAY: f64 = 3.0;
/// Maximum residual of a sinusoidal motion, relative to the amplitude (root mean square).
const SINUSOIDAL: f64 = 0.15;
/// Maximum speed in rows per frame (root mean square) at which changes are suppressed.
const FAST: f64 = 10.0;

/// Standard error in px by the lag of a compressed film; 0 if the film shows no suppressed changes. `times` in s,
/// `along` in rows, `read`: readout position of each point, relative to the height of the frame.
pub(crate) fn lag(strips: &[Strip], times: &[f64], along: &[f64], read: &[f64]) -> f64 {
    let [least, greatest] = [f64::min, f64::max].map(|end| along.iter().copied().reduce(end).unwrap_or(0.0));
    if !suppresses(strips, greatest - least < WIDEST) {
        return 0.0;
    }
    let Some(missed) = readout::residual(times, along, read) else { return 0.0 };
    let count = along.len() as f64;
    let mean = along.iter().sum::<f64>() / count;
    let motion = (along.iter().map(|value| (value - mean) * (value - mean)).sum::<f64>() / count).sqrt();
    if missed > SINUSOIDAL * motion {
        return 0.0;
    }
    // Mean squared speed, (rows per frame)². The lag decreases from about 1 on.
    let speed = along.windows(2).map(|pair| (pair[1] - pair[0]) * (pair[1] - pair[0])).sum::<f64>() / count;
    if speed > FAST * FAST {
        return 0.0;
    }
    missed * (1.0 + (PLAY - 1.0) / (1.0 + speed))
}

/// True if compression suppresses small changes of the picture: many values stay equal, or noise lasts longer than a frame. The second is
/// looked for in films of small motions only: a wide one changes the picture more over two frames than over one.
fn suppresses(strips: &[Strip], is_small: bool) -> bool {
    let changes = |one: &Strip, other: &Strip| -> Vec<u16> {
        let stride = (one.grey.len() / COMPARED).max(1);
        one.grey.iter().zip(&other.grey).step_by(stride).map(|(one, other)| one.abs_diff(*other)).collect()
    };
    let (mut kept, mut once, mut twice) = (Vec::new(), Vec::new(), Vec::new());
    for part in strips.windows(3) {
        let next = changes(&part[0], &part[1]);
        kept.push(next.iter().filter(|change| **change <= SAME).count() as f64 / next.len().max(1) as f64);
        once.push(middle(next));
        twice.push(middle(changes(&part[0], &part[2])));
    }
    let (once, twice) = (median(once), median(twice));
    median(kept) >= KEPT || is_small && once * once < LASTING * twice * twice
}

/// Median of some changes.
fn middle(changes: Vec<u16>) -> f64 {
    median(changes.into_iter().map(f64::from).collect())
}
