//! From the times at which frames are shown to those at which they were taken.

use super::finding::Finding;
use super::intervals::Intervals;

/// No camera slows down by more, and no time lapse speeds up by more.
pub const LARGEST_FACTOR: f64 = 1e6;
/// Below this rate a stated capture rate is that of a normal film, which in dim light has fewer frames than it states.
const LEAST_CAPTURE_RATE: f64 = 45.0;
/// A factor nearer to 1 is no slow motion.
const LEAST_FACTOR: f64 = 1.5;
/// A factor this near to a whole number is that number: cameras write 240 frames a second as 30, or as 29.97.
const WHOLE: f64 = 0.03;

/// The times at which frames were taken.
#[derive(Clone, Debug, PartialEq)]
pub struct TimeBase {
    /// How many times slower the film plays than things happened; below 1 for a time lapse.
    factor: f64,
    times: Vec<f64>,
}

impl TimeBase {
    /// Of frames that are shown at `times` (seconds) and were taken `factor` times faster; `None` unless the factor is positive and
    /// at most [`LARGEST_FACTOR`], and at least one over that.
    pub fn new(times: &[f64], factor: f64) -> Option<Self> {
        (1.0 / LARGEST_FACTOR..=LARGEST_FACTOR)
            .contains(&factor)
            .then(|| Self { factor, times: times.iter().map(|time| time / factor).collect() })
    }

    /// How many times slower the film plays than things happened.
    pub fn factor(&self) -> f64 {
        self.factor
    }

    /// When the frames were taken, in seconds, in the order in which they are shown.
    pub fn times(&self) -> &[f64] {
        &self.times
    }
}

/// The factor of slow motion or a time lapse, by the rate at which the camera says that it took the frames: this over the rate
/// at which they are shown. `None` for a film of normal speed.
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
