//! Conversion of presentation times to recording times.

use super::finding::Finding;
use super::intervals::Intervals;

/// Upper bound of the factor of slow motion, and of its reciprocal for a time lapse.
pub const LARGEST_FACTOR: f64 = 1e6;
/// Lower bound of a recording rate for slow motion, frames per second. A normal film in dim light has fewer frames than
/// its stated recording rate.
const LEAST_CAPTURE_RATE: f64 = 45.0;
/// Smallest factor of slow motion.
const LEAST_FACTOR: f64 = 1.5;
/// Maximum relative distance from a whole factor that is rounded to it: cameras write 240 frames per second as 30, or
/// as 29.97.
const WHOLE: f64 = 0.03;

/// Recording times of the frames.
#[derive(Clone, Debug, PartialEq)]
pub struct TimeBase {
    /// Duration of playback relative to that of the recording; below 1 for a time lapse.
    factor: f64,
    times: Vec<f64>,
}

impl TimeBase {
    /// Converts presentation times (s) by dividing them by `factor`. `None` unless `factor` lies between
    /// 1/[`LARGEST_FACTOR`] and [`LARGEST_FACTOR`].
    pub fn new(times: &[f64], factor: f64) -> Option<Self> {
        (1.0 / LARGEST_FACTOR..=LARGEST_FACTOR)
            .contains(&factor)
            .then(|| Self { factor, times: times.iter().map(|time| time / factor).collect() })
    }

    /// Duration of playback relative to that of the recording; below 1 for a time lapse.
    pub fn factor(&self) -> f64 {
        self.factor
    }

    /// Recording times in s, in order of presentation.
    pub fn times(&self) -> &[f64] {
        &self.times
    }
}

/// Detects slow motion or a time lapse: factor between the stated `capture_rate` (frames per second) and the playback
/// rate. `None` for a film of normal speed.
pub fn slow_motion(intervals: &Intervals, capture_rate: f64) -> Option<Finding> {
    let exact = capture_rate / intervals.rate;
    let whole = exact.round();
    let factor = if whole >= 2.0 && (exact / whole - 1.0).abs() < WHOLE { whole } else { exact };
    let slow = factor >= LEAST_FACTOR && capture_rate >= LEAST_CAPTURE_RATE;
    let lapse = factor <= 1.0 / LEAST_FACTOR;
    ((slow || lapse) && (1.0 / LARGEST_FACTOR..=LARGEST_FACTOR).contains(&factor)).then_some(Finding::SlowMotion {
        captured: capture_rate,
        shown: intervals.rate,
        factor,
    })
}
