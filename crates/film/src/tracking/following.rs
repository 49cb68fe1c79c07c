//! All that is followed in a film, frame by frame as a decoder delivers them.

use crate::plane::Plane;
use crate::timing::repeats;
use crate::tracking::backdrop::Backdrop;
use crate::tracking::body::{self, Body};
use crate::tracking::column::{self, Click, Column, SpaceTime};
use crate::tracking::marks::Marks;
use crate::tracking::refusal::Refusal;
use crate::tracking::similarity::Similarity;
use crate::tracking::track::{CameraShift, Track};

/// Pixels of two pictures that are compared at most.
const COMPARED: usize = 20_000;

/// What is to be followed, in pixels of the stored picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Plan {
    /// Surfaces in tubes. Their tracks come first.
    pub surfaces: Vec<Surface>,
    /// Bodies.
    pub bodies: Vec<body::Settings>,
    /// Marks that rest, as they are in the first of the frames: positions are corrected by them.
    pub marks: Vec<[f64; 2]>,
    /// The frames with their times in seconds, both ascending.
    pub frames: Vec<(usize, f64)>,
}

impl Plan {
    /// Moves clicks in frames that repeat the picture before, by their places among the frames, to the frame with that picture.
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

/// A surface with the frames in which a person has said where it is.
#[derive(Clone, Debug, PartialEq)]
pub struct Surface {
    /// What is known before the first frame.
    pub settings: column::Settings,
    /// Clicks by which the path is held.
    pub anchors: Vec<Click>,
}

/// The tracking of everything in a film: it asks for frames one after the other and then computes in portions.
///
/// A film may repeat pictures, whose times are wrong, and the camera may have moved, which the picture beside a tube shows where no marks
/// are given. The frames are then asked for a second time, without the repeated ones and corrected for the camera.
pub struct Following {
    plan: Plan,
    pass: Pass,
    /// Frames that repeat the picture before; none before the first pass is over.
    repeated: Option<Vec<usize>>,
    /// Frames and how far the picture has moved in them, in pixels; none where the camera stood still, or marks tell.
    shifts: Vec<(usize, [f64; 2])>,
}

/// One reading of the film.
struct Pass {
    columns: Vec<Column>,
    bodies: Vec<Body>,
    marks: Marks,
    /// The motion of the camera where no marks tell, in the first reading.
    backdrop: Option<Backdrop>,
    /// The mean absolute difference of each two successive pictures.
    differences: Vec<f64>,
    last: Option<Plane>,
    /// How many of the frames have been taken.
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
    /// Begins before the first frame.
    ///
    /// # Errors
    ///
    /// With more marks than can be followed.
    pub fn new(plan: Plan) -> Result<Self, Refusal> {
        let mut pass = Pass::new(&plan)?;
        if plan.marks.is_empty() && !plan.surfaces.is_empty() {
            pass.backdrop = Some(Backdrop::new(plan.surfaces.iter().map(|surface| surface.settings.axis()).collect()));
        }
        Ok(Self { pass, plan, repeated: None, shifts: Vec::new() })
    }

    /// The frame that is needed next; `None` once all have been taken.
    pub fn wanted(&self) -> Option<usize> {
        self.plan.frames.get(self.pass.taken).map(|frame| frame.0)
    }

    /// Takes the frame that is wanted, as it is stored.
    ///
    /// # Errors
    ///
    /// As [`Column::take`], [`Body::take`] and [`Marks::take`]; the film cannot be followed then.
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
        }
        pass.differences.extend(pass.last.as_ref().map(|last| difference(last, &plane)));
        pass.last = Some(plane.uncoloured());
        pass.taken += 1;
        self.leave_out_repeated()
    }

    /// Goes on without the frame that is wanted: it cannot be decoded.
    ///
    /// # Errors
    ///
    /// None that [`Following::new`] has not had.
    pub fn leave_out(&mut self) -> Result<(), Refusal> {
        if self.pass.taken < self.plan.frames.len() {
            self.plan.frames.remove(self.pass.taken);
        }
        self.leave_out_repeated()
    }

    /// Once all frames have been taken for the first time: begins again without those that repeat a picture, or with the motion of the camera.
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

    /// The greatest shift of the picture since the first frame, in pixels, by which positions are corrected; `None` where the camera stood
    /// still, or marks tell.
    pub fn camera_shift(&self) -> Option<f64> {
        self.shifts.iter().map(|(_, [c, d])| libm::hypot(*c, *d)).reduce(f64::max)
    }

    /// Continues the search by as many steps, each of which does the work of about one frame (less than a millisecond). True once all
    /// tracks are complete; never before all frames have been taken.
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

    /// The tracks, surfaces first, with the motion of the camera; empty before they are complete.
    pub fn tracks(&self) -> Vec<Track> {
        let shift = self.camera_shift().map(|pixels| CameraShift { pixels });
        let columns = self.pass.columns.iter().map(Column::track);
        let tracks = columns.chain(self.pass.bodies.iter().map(Body::track));
        tracks.map(|track| Some(Track { shift, ..track?.clone() })).collect::<Option<_>>().unwrap_or_default()
    }

    /// Fixes a surface in a frame ([`Column::anchor`]). Only the path and what follows from it are computed again, by
    /// [`Following::advance`].
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

    /// The space-time picture of a surface: the frames that have been taken in this reading of the film.
    pub fn space_time(&self, surface: usize) -> Option<SpaceTime> {
        self.pass.columns.get(surface)?.space_time()
    }

    /// The frames that are followed, with their times: those of the plan without repeated ones and those left out.
    pub fn frames(&self) -> &[(usize, f64)] {
        &self.plan.frames
    }

    /// The frames that repeat the picture before and are left out.
    pub fn repeated(&self) -> &[usize] {
        self.repeated.as_deref().unwrap_or_default()
    }

    /// How many of the frames have been taken in this reading of the film, and of how many.
    pub fn taken(&self) -> (usize, usize) {
        (self.pass.taken, self.plan.frames.len())
    }
}

impl std::fmt::Debug for Following {
    fn fmt(&self, out: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        out.debug_struct("Following").field("plan", &self.plan).field("taken", &self.pass.taken).finish_non_exhaustive()
    }
}

/// The mean absolute difference of two pictures, by some of their pixels, once the other is as bright and as contrasty as the one: a change
/// of the exposure is no motion.
fn difference(one: &Plane, other: &Plane) -> f64 {
    let step = (one.grey().len() / COMPARED).max(1);
    let pairs = || one.grey().iter().zip(other.grey()).step_by(step).map(|(a, b)| (f64::from(*a), f64::from(*b)));
    let [count, sum, other_sum, product, square] =
        pairs().fold([0.0; 5], |[count, sum, other_sum, product, square], (a, b)| {
            [count + 1.0, sum + a, other_sum + b, product + a * b, square + b * b]
        });
    let count = f64::max(count, 1.0);
    let (mean, other_mean) = (sum / count, other_sum / count);
    let variance = square - other_sum * other_mean;
    let gain = if variance > 0.0 { (product - sum * other_mean) / variance } else { 1.0 };
    pairs().map(|(a, b)| (a - mean - gain * (b - other_mean)).abs()).sum::<f64>() / count
}
