//! Description of a film by its container: codec, size, orientation and list of frames.

use super::codec::Codec;
use super::notice::Notice;
use units::order::sort_by_key;

/// Container format.
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
    /// No file: the frames are drawn by the program.
    Drawn,
}

/// Transformation of a decoded picture to the upright one: mirroring first, if any, then quarter turns.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub struct Orientation {
    /// Number of clockwise quarter turns, 0 to 3.
    pub quarter_turns: u8,
    /// True if left and right are exchanged before the turn.
    pub mirrored: bool,
}

impl Orientation {
    /// Size (width, height) of the upright picture, from the `size` of the decoded one.
    pub fn upright_size<T: Copy>(self, [width, height]: [T; 2]) -> [T; 2] {
        if self.quarter_turns % 2 == 1 { [height, width] } else { [width, height] }
    }

    /// Maps a point of the decoded picture of `size` (width, height) to the upright one. Coordinates in px: `x` to the
    /// right, `y` down, origin at the corner of the first pixel.
    pub fn upright(self, [x, y]: [f64; 2], [width, height]: [f64; 2]) -> [f64; 2] {
        let x = if self.mirrored { width - x } else { x };
        match self.quarter_turns % 4 {
            0 => [x, y],
            1 => [height - y, x],
            2 => [width - x, height - y],
            _ => [y, width - x],
        }
    }

    /// Maps a point of the upright picture to the decoded one, which has `size` (width, height). Inverse of
    /// [`Orientation::upright`], in the same coordinates.
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

/// Encoded frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sample {
    /// Offset of its bytes from the start of the file.
    pub offset: u64,
    /// Size in bytes, never 0.
    pub size: u32,
    /// Presentation time after the edit list, in units of 1/[`Film::timescale`] seconds from the start of the film.
    /// Frames that are not shown get the time that a longer first edit would give them, which may be negative.
    pub ticks: i64,
    /// True if decoding can begin with this frame.
    pub key: bool,
    /// False if an edit list cuts the frame off. It is still decoded, since shown frames may depend on it.
    pub shown: bool,
}

/// Video track of a file.
#[derive(Clone, Debug, PartialEq)]
pub struct Film {
    /// Container format.
    pub container: Container,
    /// Configuration of the decoder.
    pub codec: Codec,
    /// Width and height of the decoded picture, px, before orientation.
    pub size: [u32; 2],
    /// Ratio of width to height of a pixel, in lowest terms; `[1, 1]` for square pixels.
    pub pixel_aspect: [u32; 2],
    /// Transformation to the upright picture.
    pub orientation: Orientation,
    /// Ticks per second.
    pub timescale: u32,
    /// Frames in decoding order.
    pub samples: Vec<Sample>,
    /// Frames per second at recording, if stated. Phones store a film taken at 240 frames per second as one of 30.
    pub capture_rate: Option<f64>,
    /// Frames per second, if the container states it independently of the frame times.
    pub stated_rate: Option<f64>,
    /// Length in s, if the container states it.
    pub duration: Option<f64>,
    /// Recording time in s since 1970-01-01 UTC, if the container states it. Some cameras write local time.
    pub created: Option<i64>,
    /// Defects of the file that do not prevent its use.
    pub notices: Vec<Notice>,
}

impl Film {
    /// Converts ticks to seconds.
    pub fn seconds(&self, ticks: i64) -> f64 {
        ticks as f64 / f64::from(self.timescale)
    }

    /// Width and height of the upright picture in square px. Non-square pixels are stretched, never shrunk.
    pub fn display_size(&self) -> [f64; 2] {
        let ([width, height], [across, down]) = (self.size.map(f64::from), self.pixel_aspect.map(f64::from));
        let stretch = across / down;
        let size = if stretch >= 1.0 { [width * stretch, height] } else { [width, height / stretch] };
        self.orientation.upright_size(size)
    }

    /// Indices in `samples` of the shown frames, in order of presentation.
    ///
    /// Time 0 is the start of the film in a player. The first frame may come later: if an edit list begins with a
    /// pause, or if frames are reordered for decoding and the container has no edit list.
    pub fn shown(&self) -> Vec<usize> {
        let mut order = order(&self.samples);
        order.retain(|&at| self.samples[at].shown);
        order
    }

    /// Presentation times of the shown frames in s, ascending.
    pub fn times(&self) -> Vec<f64> {
        self.shown().into_iter().map(|at| self.seconds(self.samples[at].ticks)).collect()
    }

    /// Index of the key frame at which decoding must begin to obtain sample `at`: the last key frame at or before `at`,
    /// else 0.
    pub fn key_before(&self, at: usize) -> usize {
        let samples = self.samples.get(..=at).unwrap_or(&self.samples);
        samples.iter().rposition(|sample| sample.key).unwrap_or(0)
    }
}

/// Frames collected by a reader.
#[derive(Debug, Default)]
pub(super) struct Samples {
    /// Frames whose bytes are inside the file.
    pub(super) list: Vec<Sample>,
    /// Number of listed frames whose bytes lie beyond the end of the file.
    pub(super) lost: usize,
}

impl Samples {
    /// Adds a frame of a file of `file` bytes. An empty frame is ignored.
    pub(super) fn add(&mut self, sample: Sample, file: u64) {
        if sample.size == 0 {
        } else if sample.offset.checked_add(u64::from(sample.size)).is_some_and(|end| end <= file) {
            self.list.push(sample);
        } else {
            self.lost += 1;
        }
    }
}

/// Indices of `samples` in ascending order of presentation time.
pub(super) fn order(samples: &[Sample]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..samples.len()).collect();
    sort_by_key(&mut order, |&at| samples[at].ticks);
    order
}

/// Ratio `first : second` in lowest terms. `None` if a number is 0 or a term exceeds `u32`.
pub(super) fn lowest_terms(first: u64, second: u64) -> Option<[u32; 2]> {
    let (mut a, mut b) = (first, second);
    while b > 0 {
        (a, b) = (b, a % b);
    }
    let terms = [u32::try_from(first.checked_div(a)?).ok()?, u32::try_from(second.checked_div(a)?).ok()?];
    terms.iter().all(|&term| term > 0).then_some(terms)
}
