//! Film as its file describes it.

use film::containers::Film;
use film::timing::{Finding, Intervals, slow_motion};
use units::Words;

/// Maximum number of frames. Strips limit the number of tracked frames further.
const MOST_FRAMES: usize = 1 << 20;

/// Description of a film by its file. Frames in order of presentation.
#[derive(Clone, Debug, PartialEq)]
pub struct Clip {
    container: Film,
    times: Vec<f64>,
    intervals: Option<Intervals>,
}

impl Clip {
    /// Clip of a film described by its container.
    pub(crate) fn new(container: Film) -> Self {
        let mut times = container.times();
        times.truncate(MOST_FRAMES);
        Self { intervals: Intervals::of(&times), times, container }
    }

    /// The container.
    pub fn container(&self) -> &Film {
        &self.container
    }

    /// Presentation times of the frames, s.
    pub fn times(&self) -> &[f64] {
        &self.times
    }

    /// Width and height of the upright picture, square px.
    pub fn size(&self) -> [f64; 2] {
        self.container.orientation.upright_size(self.plane_size().map(|side| side as f64))
    }

    /// Width and height of the planes for tracking: orientation as stored, square px.
    pub fn plane_size(&self) -> [usize; 2] {
        let upright = self.container.display_size();
        self.container.orientation.upright_size(upright).map(|side| (side.round() as usize).max(1))
    }

    /// Maps a point of the upright picture to a plane, px.
    pub(crate) fn stored(&self, point: [f64; 2]) -> [f64; 2] {
        self.container.orientation.stored(point, self.plane_size().map(|side| side as f64))
    }

    /// Maps a point of a plane to the upright picture, px.
    pub(crate) fn upright(&self, point: [f64; 2]) -> [f64; 2] {
        self.container.orientation.upright(point, self.plane_size().map(|side| side as f64))
    }

    /// Maps a direction of a plane to the upright picture.
    pub(crate) fn upright_direction(&self, direction: [f64; 2]) -> [f64; 2] {
        self.container.orientation.upright(direction, [0.0; 2])
    }

    /// Maps standard errors of both coordinates of a plane to the upright picture, px.
    pub(crate) fn upright_sigma(&self, sigma: [f64; 2]) -> [f64; 2] {
        self.container.orientation.upright_size(sigma)
    }

    /// Factor of slow motion stated by the file, if any: duration of playback relative to that of the recording.
    pub(crate) fn stated_factor(&self) -> Option<f64> {
        match self.slow_motion()? {
            Finding::SlowMotion { factor, .. } => Some(factor),
            _ => None,
        }
    }

    pub(crate) fn slow_motion(&self) -> Option<Finding> {
        slow_motion(self.intervals.as_ref()?, self.container.capture_rate?)
    }

    /// Notes on the file and its times for the user.
    pub(crate) fn notes(&self) -> Vec<Words> {
        let findings = self.intervals.as_ref().map(|intervals| intervals.findings(self.container.stated_rate));
        let notices = self.container.notices.iter().map(film::containers::Notice::words);
        notices.chain(findings.into_iter().flatten().map(|finding| finding.words())).collect()
    }

    /// Frames with the same time as the frame before.
    pub(crate) fn doubled(&self) -> &[usize] {
        self.intervals.as_ref().map_or(&[], |intervals| &intervals.doubled)
    }

    /// Frames per second of playback.
    pub fn rate(&self) -> Option<f64> {
        self.intervals.as_ref().map(|intervals| intervals.rate)
    }

    /// Frame shown at a playback time in s: the last one that is not later.
    pub fn frame_at(&self, seconds: f64) -> usize {
        self.times.partition_point(|time| *time <= seconds).saturating_sub(1)
    }
}
