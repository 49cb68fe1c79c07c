//! Tracking of the surface of a liquid in a tube.
//!
//! [`Column::take`] keeps a strip along the tube from each frame. [`Column::advance`] finds the path of the surface
//! through the space-time picture of the strips, and refines it on the pixels of the bore.
//!
//! The cheapest path (`path.rs`) is sought through the space-time picture and through what is left of it without its temporal
//! median. Each is improved by what the rows show above and below the surface (`seeking.rs`, `regions.rs`), and the one that
//! explains most is kept. Then position, gain and offset of each frame are fitted to the pixels of the bore. What the surface
//! looks like (`pattern.rs`) is a spline that all frames determine together, beside a background that stands still. The
//! amplitude of a motion of a few rows is the multiple for which pattern and background, fitted together, explain most
//! (`amplitude.rs`). Smear during the exposure widens the splines, so that the exposure time is the one of least residual
//! (`exposure.rs`).

mod align;
mod amplitude;
mod bore;
mod certainty;
mod compression;
mod contrast;
mod exposure;
mod joining;
mod outcome;
mod path;
mod pattern;
mod picture;
mod reflection;
mod regions;
mod removing;
mod seeking;
mod separating;
mod solving;
mod strip;
mod together;

use crate::plane::Plane;
use crate::tracking::refusal::Refusal;
use crate::tracking::similarity::Similarity;
use crate::tracking::track::{Known, Track};
use bore::Changes;
use joining::joined;
pub use picture::SpaceTimePicture;
use solving::{Solving, Task};
use strip::{Grid, Line, Strip};

/// Maximum number of grey values in the strips of a film, two bytes each.
const VALUES: usize = 48 << 20;
/// Maximum number of rows of a strip; paths store rows in 16 bits.
const ROWS: usize = 8192;
/// Maximum number of bins across the strip.
const BINS: usize = 20;
/// Default half width of the strip, relative to the height of the picture.
const HALF_WIDTH: f64 = 1.0 / 16.0;
/// Maximum motion of the surface between frames, relative to the height of the picture, unless the film shows a faster one.
const REACH: f64 = 1.0 / 8.0;
/// Minimum length of a tube, px.
const SHORTEST: f64 = 24.0;
/// Minimum number of frames of a track.
const FEWEST: usize = 3;

/// Click on the surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Click {
    /// Frame number, as passed to [`Column::take`].
    pub frame: usize,
    /// Position in px, to the right and downwards.
    pub position: [f64; 2],
}

/// Settings of the tracking of a surface.
#[derive(Clone, Debug, PartialEq)]
pub struct Settings {
    /// Click on the surface.
    pub click: Click,
    /// Two points of the tube axis, such as its ends, px. Default: an upright tube through the click.
    pub tube: Option<[[f64; 2]; 2]>,
    /// Half the width of the strip in which the bore is sought, px. Default: 1/16 of the height of the picture.
    pub half_width: Option<f64>,
    /// Exposure time.
    pub exposure: Known,
    /// Readout time of a frame.
    pub readout: Known,
}

impl Settings {
    /// Settings for an upright tube.
    pub fn new(click: Click) -> Settings {
        Settings { click, tube: None, half_width: None, exposure: Known::Estimated, readout: Known::Estimated }
    }

    /// Point of the tube axis (px), and its unit direction.
    pub(crate) fn axis(&self) -> ([f64; 2], [f64; 2]) {
        let upright = (self.click.position, [0.0, 1.0]);
        let Some([from, to]) = self.tube else { return upright };
        let (u, v) = (to[0] - from[0], to[1] - from[1]);
        let length = (u * u + v * v).sqrt();
        if length > 0.0 { (from, [u / length, v / length]) } else { upright }
    }

    /// Length of the axis in px, in a picture with the height `high` in px.
    fn length(&self, high: f64) -> f64 {
        self.tube.map_or(high - 1.0, |[[x, y], [u, v]]| {
            let (along, down) = (u - x, v - y);
            (along * along + down * down).sqrt()
        })
    }

    /// Rows and bins of a strip, in pictures with this width and height in px.
    fn grid(&self, [wide, high]: [f64; 2]) -> Grid {
        let half = self.half_width.filter(|half| half.is_finite()).unwrap_or(HALF_WIDTH * high).min(wide).max(2.0);
        // A bin has at least the width of a pixel.
        let bins = BINS.min((2.0 * half) as usize).max(1);
        let rows = (self.length(high) as usize).saturating_add(1).min(ROWS);
        Grid { rows, bins, width: 2.0 * half / bins as f64 }
    }

    /// Maximum number of frames in pictures with this width and height in px.
    pub(crate) fn most_frames(&self, size: [usize; 2]) -> usize {
        most_frames(self.grid(size.map(|side| side as f64)))
    }
}

/// Grey values of the space-time picture.
#[derive(Clone, Debug, PartialEq)]
pub struct SpaceTime {
    /// One column per frame: mean over the bore for each row along the tube, from its first end.
    pub columns: Vec<Vec<u8>>,
    /// Position of the first row in the first frame, px.
    pub origin: [f64; 2],
    /// Unit vector along the tube, from one row to the next.
    pub direction: [f64; 2],
    /// Edges of the bore, as distances from the axis in px; positive to the right for a tube that
    /// points down.
    pub bore: [f64; 2],
}

/// Maximum number of frames whose strips fit into memory.
fn most_frames(grid: Grid) -> usize {
    VALUES / (grid.rows * grid.bins).max(1)
}

/// Tracker of a surface.
pub struct Column {
    settings: Settings,
    layout: Option<Layout>,
    strips: Vec<Strip>,
    anchors: Vec<Click>,
    solving: Option<Solving>,
    track: Option<Track>,
}

/// Geometry determined by the first frame.
struct Layout {
    size: (usize, usize),
    line: Line,
    grid: Grid,
    changes: Changes,
}

impl Layout {
    fn of(settings: &Settings, plane: &Plane) -> Result<Layout, Refusal> {
        let size = (plane.width(), plane.height());
        let (wide, high) = (size.0 as f64, size.1 as f64);
        let inside = |[x, y]: [f64; 2]| {
            let inside = (0.0..=wide).contains(&x) && (0.0..=high).contains(&y);
            if inside { Ok([x, y]) } else { Err(Refusal::Click { x, y }) }
        };
        let [x, _] = inside(settings.click.position)?;
        let length = settings.length(high);
        let (origin, direction) = match settings.tube {
            None => ([x, 0.5], [0.0, 1.0]),
            Some([from, to]) => {
                let (from, to) = (inside(from)?, inside(to)?);
                (from, [(to[0] - from[0]) / length, (to[1] - from[1]) / length])
            }
        };
        if length.is_nan() || length < SHORTEST {
            return Err(Refusal::Tube { length, least: SHORTEST });
        }
        let grid = settings.grid([wide, high]);
        Ok(Layout { size, line: Line { origin, direction }, grid, changes: Changes::new(grid) })
    }
}

impl Column {
    /// State before the first frame.
    pub fn new(settings: Settings) -> Column {
        Column { settings, layout: None, strips: Vec::new(), anchors: Vec::new(), solving: None, track: None }
    }

    /// Takes the next frame and keeps a strip of it. `time` in s, ascending. `camera`: motion of the camera since the
    /// first frame ([`Similarity::IDENTITY`] on a tripod).
    ///
    /// # Errors
    ///
    /// A [`Refusal`] if the click lies outside the picture, the tube is too short, the frame has another size or is out
    /// of order, or the film is too long.
    pub fn take(&mut self, frame: usize, time: f64, plane: &Plane, camera: Similarity) -> Result<(), Refusal> {
        let layout = match &mut self.layout {
            Some(layout) => layout,
            empty => empty.insert(Layout::of(&self.settings, plane)?),
        };
        if layout.size != (plane.width(), plane.height()) {
            return Err(Refusal::Size { frame });
        }
        if !time.is_finite() || self.strips.last().is_some_and(|last| last.time >= time || last.frame >= frame) {
            return Err(Refusal::Order { frame });
        }
        let most = most_frames(layout.grid);
        if self.strips.len() >= most {
            return Err(Refusal::Long { frames: most });
        }
        let mut strip = Strip::read(frame, time, plane, &layout.line, camera, layout.grid);
        if let Some(first) = self.strips.first() {
            strip.even(first);
        }
        layout.changes.take(&strip);
        self.strips.push(strip);
        (self.solving, self.track) = (None, None);
        Ok(())
    }

    /// Fixes the surface in a frame to within several px of a click. Replaces an earlier anchor of that frame. The next
    /// calls of [`Column::advance`] repeat the search.
    pub fn anchor(&mut self, click: Click) {
        self.anchors.retain(|anchor| anchor.frame != click.frame);
        self.anchors.push(click);
        self.start_again();
    }

    /// Removes the anchor of a frame.
    pub fn release(&mut self, frame: usize) {
        self.anchors.retain(|anchor| anchor.frame != frame);
        self.start_again();
    }

    fn start_again(&mut self) {
        self.track = None;
        let Some(layout) = &self.layout else { return };
        let anchors = self.anchors.iter().map(|click| seen(&self.strips, layout, click)).collect();
        if let Some(solving) = &mut self.solving {
            solving.again(anchors);
        }
    }

    /// Continues the search by `steps` steps of about the work of one frame, less than 1 ms each. Returns true once the
    /// track is complete.
    ///
    /// # Errors
    ///
    /// A [`Refusal`] if there are too few frames, or nothing at the click can be tracked.
    pub fn advance(&mut self, steps: usize) -> Result<bool, Refusal> {
        let short = Refusal::Short { frames: FEWEST };
        let Some(layout) = self.layout.as_ref().filter(|_| self.strips.len() >= FEWEST) else { return Err(short) };
        let solving = match &mut self.solving {
            Some(solving) => solving,
            empty => {
                empty.insert(Solving::new(task(&self.settings, &self.anchors, &self.strips, layout), &self.strips))
            }
        };
        for _ in 0..steps {
            if self.track.is_some() {
                break;
            }
            if solving.step(&self.strips)? {
                self.track = Some(joined(self.settings.readout, layout.line, layout.size.1, (&self.strips, solving)));
            }
        }
        Ok(self.track.is_some())
    }

    /// Completes the search.
    ///
    /// # Errors
    ///
    /// As [`Column::advance`].
    pub fn finish(&mut self) -> Result<Track, Refusal> {
        while !self.advance(usize::MAX)? {}
        Ok(self.track.clone().unwrap_or_default())
    }

    /// Track, once it is complete.
    pub fn track(&self) -> Option<&Track> {
        self.track.as_ref()
    }

    /// Space-time picture of the frames taken so far; `None` before the first. The estimate of the bore improves with
    /// the number of frames.
    pub fn space_time(&self) -> Option<SpaceTime> {
        let layout = self.layout.as_ref()?;
        let grid = layout.grid;
        let solving = self.solving.as_ref().filter(|solving| solving.profiles().len() == self.strips.len());
        let (first, end) = solving.map_or_else(|| layout.changes.bore(grid), |solving| solving.task.bins);
        let grey = |profile: &[f32]| profile.iter().map(|value| value.round() as u8).collect();
        let columns = match solving {
            Some(solving) => solving.profiles().iter().map(|profile| grey(profile)).collect(),
            None => self.strips.iter().map(|strip| grey(&strip.profile(grid, (first, end)))).collect(),
        };
        let bore = [first, end].map(|bin| (bin as f64 - grid.bins as f64 / 2.0) * grid.width);
        Some(SpaceTime { columns, origin: layout.line.origin, direction: layout.line.direction, bore })
    }
}

fn task(settings: &Settings, anchors: &[Click], strips: &[Strip], layout: &Layout) -> Task {
    Task {
        grid: layout.grid,
        bins: layout.changes.bore(layout.grid),
        clicked: seen(strips, layout, &settings.click),
        anchors: anchors.iter().map(|click| seen(strips, layout, click)).collect(),
        reach: REACH * layout.size.1 as f64,
        exposure: settings.exposure,
    }
}

/// Index of the strip and row of a click. If its frame was not taken, a neighbouring strip is used.
fn seen(strips: &[Strip], layout: &Layout, click: &Click) -> (usize, f64) {
    let at = strips.partition_point(|strip| strip.frame < click.frame).min(strips.len().saturating_sub(1));
    let row = strips.get(at).map_or(0.0, |strip| strip.line.row(click.position));
    (at, row.min(layout.grid.rows as f64 - 1.0).max(0.0))
}
