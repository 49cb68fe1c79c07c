//! Findings about the times of a film, as text.

use units::number::{fixed, plain};
use units::{Words, words};

/// Finding about the times of a film. Rates in frames per second, times in s.
#[derive(Clone, Debug, PartialEq)]
pub enum Finding {
    /// The frame rate is constant.
    Rate {
        /// Frame rate.
        rate: f64,
        /// Standard deviation of the intervals, s.
        spread: f64,
    },
    /// The frame rate changes during the film.
    Variable {
        /// Mean frame rate.
        rate: f64,
        /// Reciprocal of the longest interval.
        slowest: f64,
        /// Reciprocal of the shortest interval.
        fastest: f64,
    },
    /// The container stores times in whole milliseconds.
    Rounded,
    /// Frames are missing.
    Gap {
        /// Number of missing frames.
        missing: usize,
        /// Time of the frame before the gap.
        time: f64,
    },
    /// Further gaps that are not listed one by one.
    MoreGaps {
        /// Number of gaps.
        gaps: usize,
        /// Total number of missing frames.
        missing: usize,
    },
    /// Frames with the same time as the frame before.
    Doubled {
        /// Number of such frames.
        count: usize,
        /// Time of the first one.
        time: f64,
    },
    /// The stated frame rate differs from that of the times.
    Stated {
        /// Rate stated by the container.
        stated: f64,
        /// Rate from the times.
        measured: f64,
    },
    /// Slow motion or time lapse: recording and playback rates differ.
    SlowMotion {
        /// Recording rate.
        captured: f64,
        /// Playback rate.
        shown: f64,
        /// Divisor of the playback times.
        factor: f64,
    },
    /// Frames that repeat the picture before.
    Repeated {
        /// Number of repeated frames.
        count: usize,
        /// Number of frames of the film.
        of: usize,
    },
}

impl Finding {
    /// Message of one sentence.
    pub fn words(&self) -> Words {
        let number = |value: f64| Words::each(move |language| fixed(value, 2, language.style()));
        match *self {
            Self::Rate { rate, spread } => words!(
                "{rate} frames/s, intervals spread by {spread} ms",
                rate = number(rate),
                spread = Words::each(move |language| fixed(
                    spread * 1e3,
                    if spread < 9.5e-5 { 2 } else { 1 },
                    language.style()
                ))
            ),
            Self::Variable { rate, slowest, fastest } => words!(
                "variable frame rate: {rate} frames/s in the mean, from {slowest} to {fastest}; each frame keeps its own time",
                rate = number(rate),
                slowest = number(slowest),
                fastest = number(fastest)
            ),
            Self::Rounded => {
                words("the file stores times in whole milliseconds, a standard error of 0.3 ms for each frame")
            }
            Self::Gap { missing: 1, time } => {
                words!("a gap of 1 frame at {time} s", time = number(time))
            }
            Self::Gap { missing, time } => words!(
                "a gap of {missing} frames at {time} s",
                missing = Words::same(missing.to_string()),
                time = number(time)
            ),
            Self::MoreGaps { gaps, missing } => words!("further gaps: {gaps}, with {missing} missing frames in all"),
            Self::Doubled { count: 1, time } => words!(
                "a frame has the same time as the one before, {time} s; leave one of them out",
                time = number(time)
            ),
            Self::Doubled { count, time } => words!(
                "{count} frames have the same time as the one before, the first at {time} s; leave them out",
                count = Words::same(count.to_string()),
                time = number(time)
            ),
            Self::Stated { stated, measured } => words!(
                "the file states {stated} frames/s, its times give {measured}; the times are used",
                stated = number(stated),
                measured = number(measured)
            ),
            Self::SlowMotion { captured, shown, factor } if factor >= 1.0 => words!(
                "slow motion: taken at {captured} frames/s, shown at {shown}; times are divided by {factor}. Check it against a known time, such as a fall",
                captured = number(captured),
                shown = number(shown),
                factor = Words::each(move |language| plain(factor, 4, language.style()))
            ),
            Self::SlowMotion { captured, shown, factor } => words!(
                "time lapse: taken at {captured} frames/s, shown at {shown}; times are multiplied by {factor}",
                captured = Words::each(move |language| plain(captured, 3, language.style())),
                shown = number(shown),
                factor = Words::each(move |language| plain(1.0 / factor, 4, language.style()))
            ),
            Self::Repeated { count, of } => words!(
                "{count} of {of} frames repeat the picture before, with wrong times; leave them out, or use the original film"
            ),
        }
    }
}
