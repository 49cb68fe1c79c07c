//! The surface of a liquid in a tube.
//!
//! [`Column::take`] keeps a strip along the tube of each frame. Then [`Column::advance`] finds the path of the surface through
//! the space-time picture of the strips, and refines it on the pixels of the bore.

mod align;
mod bore;
mod compression;
mod contrast;
mod exposure;
mod joining;
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

use crate::plane::Plane;
use crate::tracking::refusal::Refusal;
use crate::tracking::similarity::Similarity;
use crate::tracking::track::{Known, Track};
use bore::Changes;
use joining::joined;
pub use picture::SpaceTimePicture;
use solving::{Solving, Task};
use strip::{Grid, Line, Strip};

/// Grey values that the strips of a film may hold, of two bytes each.
const VALUES: usize = 48 << 20;
/// Rows of a strip at most: paths keep rows in 16 bits.
const ROWS: usize = 8192;
/// Bins across the strip.
const BINS: usize = 20;
/// Half the width of the strip, as a part of the picture's height.
const HALF_WIDTH: f64 = 1.0 / 16.0;
/// The surface moves by at most this part of the picture's height between frames.
const REACH: f64 = 1.0 / 8.0;
/// A tube shorter than this, in pixels, shows no motion that could be followed.
const SHORTEST: f64 = 24.0;
/// The fewest frames of a track.
const FEWEST: usize = 3;

/// Where the surface was clicked, in pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Click {
    /// The frame, counted as the frames that are taken.
    pub frame: usize,
    /// To the right and downwards.
    pub position: [f64; 2],
}

/// What is known before the first frame.
#[derive(Clone, Debug, PartialEq)]
pub struct Settings {
    /// The surface.
    pub click: Click,
    /// Two points of the tube's axis, such as its ends; without them the tube is upright and goes through the click.
    pub tube: Option<[[f64; 2]; 2]>,
    /// Half the width of the strip in which the bore is sought, in pixels; without it 1/16 of the picture's height.
    pub half_width: Option<f64>,
    /// The exposure time.
    pub exposure: Known,
    /// The time that the camera takes to read a frame.
    pub readout: Known,
}

impl Settings {
    /// An upright tube of which only the surface is known.
    pub fn new(click: Click) -> Settings {
        Settings { click, tube: None, half_width: None, exposure: Known::Estimated, readout: Known::Estimated }
    }

    /// A point of the tube's axis, and its direction, of length 1.
    pub(crate) fn axis(&self) -> ([f64; 2], [f64; 2]) {
        let upright = (self.click.position, [0.0, 1.0]);
        let Some([from, to]) = self.tube else { return upright };
        let (u, v) = (to[0] - from[0], to[1] - from[1]);
        let length = (u * u + v * v).sqrt();
        if length > 0.0 { (from, [u / length, v / length]) } else { upright }
    }

    /// Length of the axis in pixels, in a picture of this height in pixels.
    fn length(&self, high: f64) -> f64 {
        self.tube.map_or(high - 1.0, |[[x, y], [u, v]]| {
            let (along, down) = (u - x, v - y);
            (along * along + down * down).sqrt()
        })
    }

    /// Rows and bins of a strip, in pictures of this width and height in pixels.
    fn grid(&self, [wide, high]: [f64; 2]) -> Grid {
        let half = self.half_width.filter(|half| half.is_finite()).unwrap_or(HALF_WIDTH * high).min(wide).max(2.0);
        // A bin is no narrower than a pixel.
        let bins = BINS.min((2.0 * half) as usize).max(1);
        let rows = (self.length(high) as usize).saturating_add(1).min(ROWS);
        Grid { rows, bins, width: 2.0 * half / bins as f64 }
    }

    /// Number of frames that can be tracked, in pictures of this width and height in pixels.
    pub(crate) fn most_frames(&self, size: [usize; 2]) -> usize {
        most_frames(self.grid(size.map(|side| side as f64)))
    }
}

/// The grey values of the space-time picture.
#[derive(Clone, Debug, PartialEq)]
pub struct SpaceTime {
    /// One column of the picture for each frame: the mean over the bore in every row along the tube, from its beginning.
    pub columns: Vec<Vec<u8>>,
    /// The point of the first row in the first frame, in pixels.
    pub origin: [f64; 2],
    /// Along the tube, of length 1: from one row to the next.
    pub direction: [f64; 2],
    /// Where the bore begins and ends, in pixels from the axis to the right of a tube that points downwards.
    pub bore: [f64; 2],
}

/// Number of frames whose strips fit into memory.
fn most_frames(grid: Grid) -> usize {
    VALUES / (grid.rows * grid.bins).max(1)
}

/// The tracking of a surface.
pub struct Column {
    settings: Settings,
    layout: Option<Layout>,
    strips: Vec<Strip>,
    anchors: Vec<Click>,
    solving: Option<Solving>,
    track: Option<Track>,
}

/// What the first frame decides.
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
    /// Prepares for the first frame.
    pub fn new(settings: Settings) -> Column {
        Column { settings, layout: None, strips: Vec::new(), anchors: Vec::new(), solving: None, track: None }
    }

    /// Takes the next frame, in the order of time (seconds); keeps a strip of it. `camera` says how the camera has moved since the
    /// first frame ([`Similarity::IDENTITY`] on a tripod).
    ///
    /// # Errors
    ///
    /// Where the click lies outside the picture, the frame has another size or an earlier time, or the film is too long.
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

    /// Fixes the surface in a frame to within some pixels of a click, in place of an earlier anchor of that frame. The path is
    /// found again by the next calls of [`Column::advance`].
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

    /// Continues the search by as many steps, each of which does the work of about one frame (less than a millisecond). True
    /// once the track is complete.
    ///
    /// # Errors
    ///
    /// Where there are too few frames, or the clicked place shows nothing that can be followed.
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

    /// The whole search at once.
    ///
    /// # Errors
    ///
    /// As [`Column::advance`].
    pub fn finish(&mut self) -> Result<Track, Refusal> {
        while !self.advance(usize::MAX)? {}
        Ok(self.track.clone().unwrap_or_default())
    }

    /// The track, once it is complete.
    pub fn track(&self) -> Option<&Track> {
        self.track.as_ref()
    }

    /// The space-time picture of the frames that have been taken; `None` before the first. Which part of the strip is the bore is known
    /// the better, the more frames there are.
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

/// The strip and the row of a click; the nearest strip where its frame was not taken.
fn seen(strips: &[Strip], layout: &Layout, click: &Click) -> (usize, f64) {
    let at = strips.partition_point(|strip| strip.frame < click.frame).min(strips.len().saturating_sub(1));
    let row = strips.get(at).map_or(0.0, |strip| strip.line.row(click.position));
    (at, row.min(layout.grid.rows as f64 - 1.0).max(0.0))
}
