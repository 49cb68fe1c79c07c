//! Errors of films in which compression keeps small changes of the picture back.
//!
//! A slow and small motion then lags behind by up to the change that is kept back, like a gear with play. The lag has nearly the frequency of the
//! motion itself: differences of the track do not show it, and the part that a sinusoid misses is about a third of it.

use crate::tracking::column::strip::Strip;
use crate::tracking::median::median;
use crate::tracking::readout;

/// Values of two strips that are compared at most.
const COMPARED: usize = 1500;
/// Steps of 1/256 by which evened values that are the same differ at most.
const SAME: u16 = 8;
/// Least part of the values that stay the same from a frame to the next one (median of the film) in a film whose compression keeps changes back:
/// noise without compression leaves fewer the same.
const KEPT: f64 = 0.3;
/// The error of a slow motion as a multiple of what a sinusoid misses: 1 to 5 in films with coarse steps.
const PLAY: f64 = 3.0;
/// Where a sinusoid misses more than this part of the motion, the motion is none.
const SINUSOIDAL: f64 = 0.15;
/// What moves by more rows a frame (root mean square) changes too much to be kept back.
const FAST: f64 = 10.0;

/// The standard error, in pixels, that the lag of a compressed film makes likely; 0 where the picture changes freely.
pub(crate) fn lag(strips: &[Strip], times: &[f64], along: &[f64], read: &[f64]) -> f64 {
    let kept = |pair: &[Strip]| {
        let stride = (pair[0].grey.len() / COMPARED).max(1);
        let pairs = || pair[0].grey.iter().zip(&pair[1].grey).step_by(stride);
        pairs().filter(|(one, other)| one.abs_diff(**other) <= SAME).count() as f64 / pairs().count().max(1) as f64
    };
    if median(strips.windows(2).map(kept).collect()) < KEPT {
        return 0.0;
    }
    let Some(missed) = readout::residual(times, along, read) else { return 0.0 };
    let count = along.len() as f64;
    let mean = along.iter().sum::<f64>() / count;
    let motion = (along.iter().map(|value| (value - mean) * (value - mean)).sum::<f64>() / count).sqrt();
    if missed > SINUSOIDAL * motion {
        return 0.0;
    }
    // The square of the speed in rows a frame: from about one on, less is kept back.
    let speed = along.windows(2).map(|pair| (pair[1] - pair[0]) * (pair[1] - pair[0])).sum::<f64>() / count;
    if speed > FAST * FAST {
        return 0.0;
    }
    missed * (1.0 + (PLAY - 1.0) / (1.0 + speed))
}
