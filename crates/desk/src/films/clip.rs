//! A film as its file describes it.

use film::containers::Film;
use film::timing::{Finding, Intervals, slow_motion};
use units::Words;

/// The largest number of frames that are tracked: those that strips have room for are fewer.
const MOST_FRAMES: usize = 1 << 20;

/// What a film file says of itself, in the order in which frames are shown.
#[derive(Clone, Debug, PartialEq)]
pub struct Clip {
    container: Film,
    times: Vec<f64>,
    intervals: Option<Intervals>,
}

impl Clip {
    /// What a container says.
    pub(crate) fn new(container: Film) -> Self {
        let mut times = container.times();
        times.truncate(MOST_FRAMES);
        Self { intervals: Intervals::of(&times), times, container }
    }

    /// The container.
    pub fn container(&self) -> &Film {
        &self.container
    }

    /// When each frame is shown, in seconds of the file.
    pub fn times(&self) -> &[f64] {
        &self.times
    }

    /// Width and height of the upright picture, with square pixels.
    pub fn size(&self) -> [f64; 2] {
        self.container.orientation.upright_size(self.plane_size().map(|side| side as f64))
    }

    /// Width and height of the planes to hand over: as the picture is stored, not turned, but with square pixels.
    pub fn plane_size(&self) -> [usize; 2] {
        let upright = self.container.display_size();
        self.container.orientation.upright_size(upright).map(|side| (side.round() as usize).max(1))
    }

    /// Where a point of the upright picture is in a plane.
    pub(crate) fn stored(&self, point: [f64; 2]) -> [f64; 2] {
        self.container.orientation.stored(point, self.plane_size().map(|side| side as f64))
    }

    /// Where a point of a plane is in the upright picture.
    pub(crate) fn upright(&self, point: [f64; 2]) -> [f64; 2] {
        self.container.orientation.upright(point, self.plane_size().map(|side| side as f64))
    }

    /// A direction of a plane, in the upright picture.
    pub(crate) fn upright_direction(&self, direction: [f64; 2]) -> [f64; 2] {
        self.container.orientation.upright(direction, [0.0; 2])
    }

    /// Errors of both coordinates of a plane, in the upright picture.
    pub(crate) fn upright_sigma(&self, sigma: [f64; 2]) -> [f64; 2] {
        self.container.orientation.upright_size(sigma)
    }

    /// How many times slower the film plays than things happened, by what the file says.
    pub(crate) fn stated_factor(&self) -> Option<f64> {
        match self.slow_motion()? {
            Finding::SlowMotion { factor, .. } => Some(factor),
            _ => None,
        }
    }

    pub(crate) fn slow_motion(&self) -> Option<Finding> {
        slow_motion(self.intervals.as_ref()?, self.container.capture_rate?)
    }

    /// What a person should know about the file and its times. Frames of doubled times are left out.
    pub(crate) fn notes(&self) -> Vec<Words> {
        let findings = self.intervals.as_ref().map(|intervals| intervals.findings(self.container.stated_rate));
        let notices = self.container.notices.iter().map(film::containers::Notice::words);
        notices.chain(findings.into_iter().flatten().map(|finding| finding.words())).collect()
    }

    /// The frames that share their time with the one before.
    pub(crate) fn doubled(&self) -> &[usize] {
        self.intervals.as_ref().map_or(&[], |intervals| &intervals.doubled)
    }

    /// Frames a second as the film is shown.
    pub fn rate(&self) -> Option<f64> {
        self.intervals.as_ref().map(|intervals| intervals.rate)
    }

    /// The frame that is shown at a time of the file, in seconds: the last one that is not later.
    pub fn frame_at(&self, seconds: f64) -> usize {
        self.times.partition_point(|time| *time <= seconds).saturating_sub(1)
    }
}
