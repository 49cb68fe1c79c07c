//! A film as its container describes it.

use super::codec::Codec;
use super::notice::Notice;

/// The kind of file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Container {
    /// MP4 and 3GP (ISO/IEC 14496-12).
    Mp4,
    /// QuickTime (`.mov`).
    QuickTime,
    /// WebM.
    WebM,
    /// Matroska (`.mkv`).
    Matroska,
    /// AVI.
    Avi,
    /// None: the frames are drawn, and in no file.
    Drawn,
}

/// How a decoded picture is turned to be upright: mirrored first, if at all, then by quarter turns.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub struct Orientation {
    /// Quarter turns clockwise, 0 to 3.
    pub quarter_turns: u8,
    /// Whether left and right are exchanged before the turn.
    pub mirrored: bool,
}

impl Orientation {
    /// The size of the upright picture, of a decoded one with `size` (width, height).
    pub fn upright_size<T: Copy>(self, [width, height]: [T; 2]) -> [T; 2] {
        if self.quarter_turns % 2 == 1 { [height, width] } else { [width, height] }
    }

    /// Where a point of the decoded picture of `size` (width, height) is in the upright one. Coordinates in pixels, `x` to the
    /// right and `y` down from the corner of the first pixel.
    pub fn upright(self, [x, y]: [f64; 2], [width, height]: [f64; 2]) -> [f64; 2] {
        let x = if self.mirrored { width - x } else { x };
        match self.quarter_turns % 4 {
            0 => [x, y],
            1 => [height - y, x],
            2 => [width - x, height - y],
            _ => [y, width - x],
        }
    }

    /// Where a point of the upright picture is in the decoded one, which has `size` (width, height).
    pub fn stored(self, [x, y]: [f64; 2], [width, height]: [f64; 2]) -> [f64; 2] {
        let [x, y] = match self.quarter_turns % 4 {
            0 => [x, y],
            1 => [y, height - x],
            2 => [width - x, height - y],
            _ => [width - y, x],
        };
        [if self.mirrored { width - x } else { x }, y]
    }
}

/// One coded frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sample {
    /// Where its bytes begin in the file.
    pub offset: u64,
    /// How many bytes it has, never 0.
    pub size: u32,
    /// When it is shown, in units of 1/[`Film::timescale`] seconds after the start of the film, as edit lists have it. For a
    /// frame that is not shown, when it would be if the first edit were longer, so that it may be negative.
    pub ticks: i64,
    /// Whether decoding can begin with it.
    pub key: bool,
    /// Whether it is shown. Others are cut off by an edit list; they are decoded, since shown ones refer to them.
    pub shown: bool,
}

/// The video of a file.
#[derive(Clone, Debug, PartialEq)]
pub struct Film {
    /// The kind of file.
    pub container: Container,
    /// How frames are coded.
    pub codec: Codec,
    /// Width and height of the decoded picture in pixels, before it is turned.
    pub size: [u32; 2],
    /// Width to height of a pixel, in lowest terms; `[1, 1]` for square ones.
    pub pixel_aspect: [u32; 2],
    /// How it is turned to be upright.
    pub orientation: Orientation,
    /// Ticks in a second.
    pub timescale: u32,
    /// The frames in the order in which they are decoded.
    pub samples: Vec<Sample>,
    /// Frames that the camera took in a second, if it says so: phones write a film of 240 frames a second as one of 30.
    pub capture_rate: Option<f64>,
    /// Frames a second, if the container states them apart from the times.
    pub stated_rate: Option<f64>,
    /// Length in seconds, if the container states it.
    pub duration: Option<f64>,
    /// When it was taken, in seconds since the start of 1970 (UTC), if the container states it. Some cameras write local time.
    pub created: Option<i64>,
    /// What its reader should know.
    pub notices: Vec<Notice>,
}

impl Film {
    /// Ticks in seconds.
    pub fn seconds(&self, ticks: i64) -> f64 {
        ticks as f64 / f64::from(self.timescale)
    }

    /// Width and height of the upright picture with square pixels, as wide as it is decoded or wider.
    pub fn display_size(&self) -> [f64; 2] {
        let ([width, height], [across, down]) = (self.size.map(f64::from), self.pixel_aspect.map(f64::from));
        let stretch = across / down;
        let size = if stretch >= 1.0 { [width * stretch, height] } else { [width, height / stretch] };
        self.orientation.upright_size(size)
    }

    /// The places in `samples` of the frames that are shown, in the order in which they are.
    ///
    /// The time 0 is the start of the film as a player has it. The first frame may come later: where an edit list begins with a
    /// pause, or where the container has no edit list and frames are decoded in another order than they are shown.
    pub fn shown(&self) -> Vec<usize> {
        let mut order = order(&self.samples);
        order.retain(|&at| self.samples[at].shown);
        order
    }

    /// The times of the frames that are shown, in seconds, in order.
    pub fn times(&self) -> Vec<f64> {
        self.shown().into_iter().map(|at| self.seconds(self.samples[at].ticks)).collect()
    }

    /// The key frame with which decoding begins in order to see the sample `at`: the last one at or before it, else the first
    /// sample.
    pub fn key_before(&self, at: usize) -> usize {
        let samples = self.samples.get(..=at).unwrap_or(&self.samples);
        samples.iter().rposition(|sample| sample.key).unwrap_or(0)
    }
}

/// Frames as a reader finds them, and what it had to leave out.
#[derive(Debug, Default)]
pub(super) struct Samples {
    /// Those whose bytes are in the file.
    pub(super) list: Vec<Sample>,
    /// How many others are listed, whose bytes lie beyond its end.
    pub(super) lost: usize,
}

impl Samples {
    /// Takes a frame of a file of `file` bytes. An empty one shows nothing and is left out.
    pub(super) fn add(&mut self, sample: Sample, file: u64) {
        if sample.size == 0 {
        } else if sample.offset.checked_add(u64::from(sample.size)).is_some_and(|end| end <= file) {
            self.list.push(sample);
        } else {
            self.lost += 1;
        }
    }
}

/// The places of frames in the order of their times.
pub(super) fn order(samples: &[Sample]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..samples.len()).collect();
    order.sort_by_key(|&at| samples[at].ticks);
    order
}

/// Two numbers in lowest terms, if neither is 0.
pub(super) fn lowest_terms(first: u64, second: u64) -> Option<[u32; 2]> {
    let (mut a, mut b) = (first, second);
    while b > 0 {
        (a, b) = (b, a % b);
    }
    let terms = [u32::try_from(first.checked_div(a)?).ok()?, u32::try_from(second.checked_div(a)?).ok()?];
    terms.iter().all(|&term| term > 0).then_some(terms)
}
