//! Times of films as they are shown.

use units::Words;
use units::number::fixed;

/// Resolution of displayed film times, s.
pub const RESOLUTION: f64 = 1e-3;
/// Part of the resolution by which a time may be smaller because it was rounded.
const ROUNDED: f64 = 1e-6;

/// Number of seconds with three decimal places, rounded down, so that the frame of this number is shown at that time.
pub fn displayed(seconds: f64) -> Words {
    Words::each(move |language| fixed((seconds / RESOLUTION + ROUNDED).floor() * RESOLUTION, 3, language.style()))
}
