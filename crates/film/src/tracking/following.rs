//! Tracking of all surfaces and bodies of a film, frame by frame as a decoder delivers them.

use crate::plane::Plane;
use crate::timing::repeats;
use crate::tracking::backdrop::Backdrop;
use crate::tracking::body::{self, Body};
use crate::tracking::column::{self, Click, Column, SpaceTime};
use crate::tracking::doubt::doubt_shared;
use crate::tracking::marks::Marks;
use crate::tracking::refusal::Refusal;
use crate::tracking::similarity::Similarity;
use crate::tracking::track::{CameraShift, Track};

/// Maximum number of pixels compared per pair of pictures.
const COMPARED: usize = 20_000;
/// Number of pixels whose products have a sum of 32 bits.
const PART: usize = 1 << 16;

/// Objects to be tracked. Positions in px of the stored picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Plan {
    /// Surfaces in tubes. Their tracks come first.
    pub surfaces: Vec<Surface>,
    /// Bodies.
    pub bodies: Vec<body::Settings>,
    /// Positions of fixed marks in the first frame, for the correction of camera motion.
    pub marks: Vec<[f64; 2]>,
    /// Frame numbers and times in s, both ascending.
    pub frames: Vec<(usize, f64)>,
}

impl Plan {
    /// Moves clicks in repeated frames to the frame with the original picture. `repeated`: indices among the frames,
    /// ascending.
    fn move_clicks(&mut self, repeated: &[usize]) {
        let kept = |click: &mut Click| {
            let Ok(mut place) = self.frames.binary_search_by_key(&click.frame, |frame| frame.0) else { return };
            while place > 0 && repeated.binary_search(&place).is_ok() {
                place -= 1;
            }
            click.frame = self.frames.get(place).map_or(click.frame, |frame| frame.0);
        };
        for surface in &mut self.surfaces {
            std::iter::once(&mut surface.settings.click).chain(&mut surface.anchors).for_each(kept);
        }
        self.bodies.iter_mut().flat_map(|body| &mut body.keys).for_each(kept);
    }
}

/// Surface with its anchors.
#[derive(Clone, Debug, PartialEq)]
pub struct Surface {
    /// Settings of the tracking.
    pub settings: column::Settings,
    /// Clicks that fix the path in further frames.
    pub anchors: Vec<Click>,
}

/// Tracking of a film: requests frames one after the other and then computes in steps.
///
/// If the film repeats pictures, whose times are wrong, or the picture beside a tube shows a motion of the camera that
/// no marks correct, the frames are requested a second time. Repeated frames are then left out and the motion of the
/// camera is corrected.
pub struct Following {
    plan: Plan,
    pass: Pass,
    /// Frame numbers of repeated pictures; `None` before the end of the first pass.
    repeated: Option<Vec<usize>>,
    /// Frame numbers and shifts of the picture, px; empty if the camera stands still or marks are given.
    shifts: Vec<(usize, [f64; 2])>,
}

/// State of one pass through the film.
struct Pass {
    columns: Vec<Column>,
    bodies: Vec<Body>,
    marks: Marks,
    /// Measurement of the camera motion in the first pass, if no marks are given.
    backdrop: Option<Backdrop>,
    /// Mean absolute difference of successive pictures, grey values.
    differences: Vec<f64>,
    /// Pixels of the last picture that are compared with those of the next.
    last: Option<Vec<u8>>,
    /// Number of frames taken.
    taken: usize,
}

impl Pass {
    fn new(plan: &Plan) -> Result<Self, Refusal> {
        let column = |surface: &Surface| {
            let mut column = Column::new(surface.settings.clone());
            surface.anchors.iter().for_each(|anchor| column.anchor(*anchor));
            column
        };
        Ok(Self {
            columns: plan.surfaces.iter().map(column).collect(),
            bodies: plan.bodies.iter().cloned().map(Body::new).collect(),
            marks: Marks::new(plan.marks.clone())?,
            backdrop: None,
            differences: Vec::new(),
            last: None,
            taken: 0,
        })
    }
}

impl Following {
    /// State before the first frame.
    ///
    /// # Errors
    ///
    /// [`Refusal::Many`] for too many marks.
    pub fn new(plan: Plan) -> Result<Self, Refusal> {
        let mut pass = Pass::new(&plan)?;
        if plan.marks.is_empty() && !plan.surfaces.is_empty() {
            pass.backdrop = Some(Backdrop::new(plan.surfaces.iter().map(|surface| surface.settings.axis()).collect()));
        }
        Ok(Self { pass, plan, repeated: None, shifts: Vec::new() })
    }

    /// Number of the next frame to be taken; `None` at the end.
    pub fn wanted(&self) -> Option<usize> {
        self.plan.frames.get(self.pass.taken).map(|frame| frame.0)
    }

    /// Takes the requested frame as it is stored.
    ///
    /// # Errors
    ///
    /// As [`Column::take`], [`Body::take`] and [`Marks::take`]. The film cannot be tracked then.
    pub fn take(&mut self, plane: Plane) -> Result<(), Refusal> {
        let Some(&(frame, time)) = self.plan.frames.get(self.pass.taken) else { return Ok(()) };
        let pass = &mut self.pass;
        let mut camera = pass.marks.take(frame, &plane)?;
        if let Ok(at) = self.shifts.binary_search_by_key(&frame, |shift| shift.0) {
            let [c, d] = self.shifts[at].1;
            camera = Similarity { c, d, ..camera };
        }
        if let Some(backdrop) = &mut pass.backdrop {
            backdrop.take(&plane);
        }
        for column in &mut pass.columns {
            column.take(frame, time, &plane, camera)?;
        }
        for body in &mut pass.bodies {
            body.take(frame, time, &plane, camera)?;
            let taken = pass.taken + 1;
            body.check(taken, self.plan.frames.len() - taken)?;
        }
        let pixels = compared(&plane);
        pass.differences.extend(pass.last.as_ref().map(|last| difference(last, &pixels)));
        pass.last = Some(pixels);
        pass.taken += 1;
        self.leave_out_repeated()
    }

    /// Skips the requested frame, which cannot be decoded.
    ///
    /// # Errors
    ///
    /// As [`Following::new`].
    pub fn leave_out(&mut self) -> Result<(), Refusal> {
        if self.pass.taken < self.plan.frames.len() {
            self.plan.frames.remove(self.pass.taken);
        }
        self.leave_out_repeated()
    }

    /// At the end of the first pass, starts a second one if there are repeated pictures or the camera moves.
    fn leave_out_repeated(&mut self) -> Result<(), Refusal> {
        if self.wanted().is_some() || self.repeated.is_some() {
            return Ok(());
        }
        self.pass.last = None;
        let places = repeats(&self.pass.differences);
        let repeated = places.iter().filter_map(|place| Some(self.plan.frames.get(*place)?.0)).collect();
        if let Some(backdrop) = self.pass.backdrop.take() {
            let frames = self.plan.frames.iter().map(|frame| frame.0);
            self.shifts = frames.zip(backdrop.moved().unwrap_or_default()).collect();
        }
        if !places.is_empty() || !self.shifts.is_empty() {
            self.plan.move_clicks(&places);
            let mut place = 0..;
            self.plan.frames.retain(|_| place.next().is_none_or(|place| places.binary_search(&place).is_err()));
            self.pass = Pass::new(&self.plan)?;
        }
        self.repeated = Some(repeated);
        Ok(())
    }

    /// Largest shift of the picture since the first frame by which positions are corrected, px; `None` if the camera
    /// stands still or marks are given.
    pub fn camera_shift(&self) -> Option<f64> {
        self.shifts.iter().map(|(_, [c, d])| libm::hypot(*c, *d)).reduce(f64::max)
    }

    /// Continues the computation by `steps` steps of about the work of one frame, less than 1 ms each. Returns true
    /// once all tracks are complete, never before all frames have been taken.
    ///
    /// # Errors
    ///
    /// As [`Column::advance`].
    pub fn advance(&mut self, steps: usize) -> Result<bool, Refusal> {
        if self.wanted().is_some() {
            return Ok(false);
        }
        for column in self.pass.columns.iter_mut().filter(|column| column.track().is_none()) {
            if !column.advance(steps)? || steps < usize::MAX {
                return Ok(false);
            }
        }
        for body in self.pass.bodies.iter_mut().filter(|body| body.track().is_none()) {
            if !body.advance(steps) || steps < usize::MAX {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// Tracks with the motion of the camera, surfaces first; two bodies at one place are in doubt. Empty before they are complete.
    pub fn tracks(&self) -> Vec<Track> {
        let shift = self.camera_shift().map(|pixels| CameraShift { pixels });
        let columns = self.pass.columns.iter().map(Column::track);
        let tracks = columns.chain(self.pass.bodies.iter().map(Body::track));
        let tracks = tracks.map(|track| Some(Track { shift, ..track?.clone() }));
        let mut tracks: Vec<Track> = tracks.collect::<Option<_>>().unwrap_or_default();
        doubt_shared(&mut tracks);
        tracks
    }

    /// Fixes a surface in a frame ([`Column::anchor`]). [`Following::advance`] then repeats the search of that surface
    /// only.
    pub fn anchor(&mut self, surface: usize, click: Click) {
        self.release(surface, click.frame);
        if let Some(surface) = self.plan.surfaces.get_mut(surface) {
            surface.anchors.push(click);
        }
        if let Some(column) = self.pass.columns.get_mut(surface) {
            column.anchor(click);
        }
    }

    /// Removes the anchor of a surface in a frame.
    pub fn release(&mut self, surface: usize, frame: usize) {
        if let Some(surface) = self.plan.surfaces.get_mut(surface) {
            surface.anchors.retain(|anchor| anchor.frame != frame);
        }
        if let Some(column) = self.pass.columns.get_mut(surface) {
            column.release(frame);
        }
    }

    /// Space-time picture of a surface, from the frames taken in this pass.
    pub fn space_time(&self, surface: usize) -> Option<SpaceTime> {
        self.pass.columns.get(surface)?.space_time()
    }

    /// Numbers and times (s) of the tracked frames, without repeated and skipped ones.
    pub fn frames(&self) -> &[(usize, f64)] {
        &self.plan.frames
    }

    /// Numbers of the frames that repeat the picture before and are left out.
    pub fn repeated(&self) -> &[usize] {
        self.repeated.as_deref().unwrap_or_default()
    }

    /// Number of frames taken in this pass, and their total number.
    pub fn taken(&self) -> (usize, usize) {
        (self.pass.taken, self.plan.frames.len())
    }
}

impl std::fmt::Debug for Following {
    fn fmt(&self, out: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        out.debug_struct("Following").field("plan", &self.plan).field("taken", &self.pass.taken).finish_non_exhaustive()
    }
}

/// Grey values of a part of the pixels of a picture.
fn compared(plane: &Plane) -> Vec<u8> {
    let step = (plane.grey().len() / COMPARED).max(1);
    plane.grey().iter().copied().step_by(step).collect()
}

/// Mean absolute difference of the compared pixels of two pictures in grey values. Brightness and contrast are matched
/// first, so that a change of the exposure does not count.
fn difference(one: &[u8], other: &[u8]) -> f64 {
    // Sums of integers, which are exact.
    let [mut sum, mut other_sum, mut product, mut square] = [0_u64; 4];
    for (one, other) in one.chunks(PART).zip(other.chunks(PART)) {
        let part = one.iter().zip(other).fold([0_u32; 4], |[sum, other_sum, product, square], (a, b)| {
            let (a, b) = (u32::from(*a), u32::from(*b));
            [sum + a, other_sum + b, product + a * b, square + b * b]
        });
        sum += u64::from(part[0]);
        other_sum += u64::from(part[1]);
        product += u64::from(part[2]);
        square += u64::from(part[3]);
    }
    let [count, sum, other_sum, product, square] =
        [one.len().min(other.len()).max(1) as u64, sum, other_sum, product, square].map(|sum| sum as f64);
    let (mean, other_mean) = (sum / count, other_sum / count);
    let variance = square - other_sum * other_mean;
    let gain = if variance > 0.0 { (product - sum * other_mean) / variance } else { 1.0 };
    let left = |(a, b): (&u8, &u8)| (f64::from(*a) - mean - gain * (f64::from(*b) - other_mean)).abs();
    // Four sums do not wait for one another.
    let mut sums = [0.0; 4];
    let ((parts, rest), (other_parts, other_rest)) = (one.as_chunks::<4>(), other.as_chunks::<4>());
    for (one, other) in parts.iter().zip(other_parts) {
        sums.iter_mut().zip(one.iter().zip(other)).for_each(|(sum, pair)| *sum += left(pair));
    }
    sums.iter_mut().zip(rest.iter().zip(other_rest)).for_each(|(sum, pair)| *sum += left(pair));
    sums.iter().sum::<f64>() / count
}
