//! Frames kept after a click.

use crate::plane::Plane;
use crate::tracking::body::frame::Frame;
use crate::tracking::body::region::Region;
use crate::tracking::similarity::Similarity;

/// Frame that was taken.
pub(super) struct Shot {
    pub number: usize,
    pub time: f64,
    pub plane: Plane,
    pub camera: Similarity,
}

impl Shot {
    /// The frame.
    pub(super) fn frame(&self) -> Frame<'_> {
        Frame { number: self.number, time: self.time, plane: &self.plane, camera: self.camera }
    }
}

/// Click, the frames from there on, and what was known before: number of sightings and of templates, first frame
/// without the body.
pub(super) struct Start {
    pub click: [f64; 2],
    pub shots: Vec<Shot>,
    pub seen: usize,
    pub templates: usize,
    pub lost: Option<usize>,
    /// Body at the two ages before, the last one first.
    pub regions: [Option<Region>; 2],
}

impl Start {
    /// The frames from the click on.
    pub(super) fn planes(&self) -> Vec<&Plane> {
        self.shots.iter().map(|shot| &shot.plane).collect()
    }

    pub(super) fn new(click: [f64; 2], (seen, templates): (usize, usize), lost: Option<usize>) -> Start {
        Start { click, shots: Vec::new(), seen, templates, lost, regions: [None, None] }
    }
}
