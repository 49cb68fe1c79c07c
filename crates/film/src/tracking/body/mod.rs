//! Tracking of a body such as a ball or the bob of a pendulum.
//!
//! [`Body::take`] searches each frame near the predicted position for shades of the body that differ from the
//! background, and keeps the pixels around it. [`Body::advance`] then improves the positions with the mean of those
//! pixels.

mod background;
mod course;
mod crossing;
mod disc;
mod joining;
mod look;
mod moving;
mod part;
mod refining;
mod rival;
mod smooth;
mod start;
mod starting;
mod template;
mod vacated;

use background::Background;
use course::course;
pub(crate) use disc::Disc;
use look::Look;
use moving::Moving;
use part::Axis;
pub(crate) use part::Part;
use template::Found;
pub(crate) use template::Template;

use crate::plane::Plane;
use crate::tracking::column::Click;
use crate::tracking::refusal::Refusal;
use crate::tracking::similarity::Similarity;
use crate::tracking::track::{Known, Track};
use joining::joined;
use refining::{Refining, Seen};
use rival::{Rivals, Told};
use start::{Shot, Start};

/// Minimum correlation of a template that was found.
const SCORE: f64 = 0.6;
/// Minimum correlation at which the first template is used. It does not drift.
const CLEAR: f64 = 0.85;
/// Minimum agreement of a body, relative to the best possible one.
const AGREES: f32 = 0.45;
/// Minimum agreement away from the predicted position, where similar objects may be. The body may have been pushed.
const PUSHED: f32 = 0.7;
/// Minimum agreement for an update of the appearance.
const WHOLE: f32 = 0.75;
/// Best possible agreement below which body and background are too similar, so that the template alone decides.
const DISTINCT: f32 = 0.2;
/// Increase of the fraction of the ring without background from which something touches the body.
const TOUCH: f32 = 0.2;
/// Number of frames after which a touching object counts as part of the appearance.
const TOUCHED: usize = 5;
/// Fraction of the deviation by which the template is updated in each frame.
const PACE: f64 = 0.2;
/// Maximum distance from the smooth curve through a meeting, px and relative to the radius, of a position that is certain.
const NEAR: (f64, f64) = (2.5, 0.1);
/// Maximum number of frames in which a hidden body is sought.
const HIDDEN: usize = 10;
/// Maximum radius of a body relative to the height of the picture, if it is not given.
const RADIUS: f64 = 1.0 / 9.0;
/// Maximum size of the kept pixels in bytes.
const BYTES: usize = 96 << 20;
/// Margin around a template in px: steps of the alignment and support of the interpolation.
pub(crate) const MARGIN: f64 = 5.0;

/// Settings of the tracking of a body.
#[derive(Clone, Debug, PartialEq)]
pub struct Settings {
    /// Clicks on the body: in the first frame, and in key frames that supply further templates. Positions in px.
    pub keys: Vec<Click>,
    /// Radius of the outline, px. Default: that of the circle around the click with the largest contrast.
    pub radius: Option<f64>,
    /// Readout time of the camera. Not estimated for bodies: [`Known::Estimated`] counts as 0.
    pub readout: Known,
}

/// Result of a frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Sight {
    /// Frame before the first click.
    Before,
    /// Position in px and correlation with the template, 0 to 1.
    At([f64; 2], f64),
    /// Not found. The search continues at the predicted position.
    Hidden,
    /// Not found. The search ends until the next key frame.
    Lost,
}

/// State of the search in successive frames.
struct Tracker {
    look: Look,
    /// Template that is updated.
    now: Template,
    axis: Option<Axis>,
    background: Background,
    /// Number of frames since the body was seen.
    hidden: usize,
    /// First frame without the body.
    since: usize,
    /// Index of the first sighting of the present motion.
    begin: usize,
    /// Usual fraction of the ring around the body that does not show the background: smear, a rod.
    around: f32,
    moving: Moving,
    rivals: Rivals,
}

/// Result of the search in a frame.
struct Sighting {
    found: Found,
    agreement: f64,
    aside: bool,
    free: bool,
    /// Position of another thing that looks like the body, px.
    rival: Option<[f64; 2]>,
}

/// Maximum radius in px in a picture of `high` rows.
fn greatest(high: f64) -> f64 {
    (high / 3.0).clamp(3.0, 100.0)
}

/// Minimum and maximum radius in px of a body in a stored picture of `high` rows.
pub fn radii(high: f64) -> [f64; 2] {
    [disc::SMALLEST, greatest(high)]
}

/// Tracker of a body.
pub struct Body {
    settings: Settings,
    size: Option<(usize, usize)>,
    /// Time of the last frame (s), and the step to it, whose sign is the direction.
    last: Option<(f64, f64)>,
    templates: Vec<Template>,
    /// One per template: true once its disc has moved as a whole.
    moved: Vec<bool>,
    tracker: Option<Tracker>,
    /// The click and the frames from there on, until the body has left its first place.
    start: Option<Start>,
    seen: Vec<Seen>,
    cameras: Vec<Similarity>,
    bytes: usize,
    lost: Option<usize>,
    refining: Option<Refining>,
    track: Option<Track>,
}

impl Body {
    /// State before the first frame.
    pub fn new(settings: Settings) -> Body {
        Body {
            settings,
            size: None,
            last: None,
            templates: Vec::new(),
            moved: Vec::new(),
            tracker: None,
            start: None,
            seen: Vec::new(),
            cameras: Vec::new(),
            bytes: 0,
            lost: None,
            refining: None,
            track: None,
        }
    }

    /// Takes the next frame. `time` in s, monotonic in either direction. `camera`: motion of the camera since the first
    /// frame ([`Similarity::IDENTITY`] on a tripod).
    ///
    /// # Errors
    ///
    /// A [`Refusal`] if a click lies outside the picture or on a uniform area, the frame has another size or is out of
    /// order, or the film is too long.
    pub fn take(&mut self, frame: usize, time: f64, plane: &Plane, camera: Similarity) -> Result<Sight, Refusal> {
        self.admit(frame, time, plane)?;
        let sight = self.follow(frame, time, plane, camera)?;
        let Some(start) = self.start.take() else { return Ok(sight) };
        Ok(self.leave(start, Shot { frame, time, plane: plane.clone(), camera })?.unwrap_or(sight))
    }

    /// Checks that the pixels around the body will fit into memory after `frames` further frames. Until the radius is certain, any number fits.
    ///
    /// # Errors
    ///
    /// [`Refusal::Long`] with the number of frames that fit, `taken` of which have been taken.
    pub(crate) fn check(&self, taken: usize, frames: usize) -> Result<(), Refusal> {
        let Some(last) = self.seen.last().filter(|_| self.start.is_none() && self.tracker.is_some()) else {
            return Ok(());
        };
        let most = BYTES.saturating_sub(self.bytes) / last.part.plane.grey().len().max(1);
        if frames > most { Err(Refusal::Long { frames: taken + most }) } else { Ok(()) }
    }

    /// Finds the body in the next frame.
    fn follow(&mut self, frame: usize, time: f64, plane: &Plane, camera: Similarity) -> Result<Sight, Refusal> {
        let key = self.settings.keys.iter().rev().find(|key| key.frame == frame).copied();
        let sighting = self.find(plane, time);
        let sighting = match key {
            Some(click) => Some(self.begin(plane, click.position, sighting)?),
            None => sighting,
        };
        self.sight(frame, time, (plane, camera), sighting)
    }

    /// Keeps what was found in a frame.
    fn sight(
        &mut self,
        frame: usize,
        time: f64,
        (plane, camera): (&Plane, Similarity),
        sighting: Option<Sighting>,
    ) -> Result<Sight, Refusal> {
        let Some(tracker) = &mut self.tracker else {
            return Ok(if self.templates.is_empty() { Sight::Before } else { Sight::Lost });
        };
        let Some(Sighting { found, agreement, aside, free, .. }) = sighting else {
            if tracker.hidden == 0 {
                tracker.since = frame;
            }
            tracker.hidden += 1;
            if tracker.hidden > HIDDEN {
                self.lost = self.lost.or(Some(tracker.since));
                self.tracker = None;
                return Ok(Sight::Lost);
            }
            return Ok(Sight::Hidden);
        };
        tracker.hidden = 0;
        let reach = self.templates.last().map_or(0.0, |template| template.disc.reach());
        // A body that was found lies in the picture.
        let part = Part::around(plane, found.position, reach + MARGIN, tracker.axis.as_ref()).ok_or(Refusal::Plain)?;
        self.bytes += part.plane.grey().len();
        if self.bytes > BYTES {
            return Err(Refusal::Long { frames: self.seen.len() });
        }
        let key = self.templates.len().saturating_sub(1);
        if let Some(Template { disc, .. }) = self.templates.last() {
            tracker.moving.take(&tracker.background, (plane, found.position), *disc, self.seen.len());
        }
        if let Some(moved) = self.moved.last_mut() {
            *moved |= tracker.moving.moved;
        }
        let moves = !tracker.moving.rests;
        if !moves {
            let since = self.seen.iter_mut().skip(tracker.moving.last + 1).rev().take_while(|one| one.moves);
            since.for_each(|one| one.moves = false);
        }
        let alone = tracker.rivals.are_apart();
        self.seen.push(Seen { frame, time, key, part, first: found, now: found, agreement, aside, free, moves, alone });
        self.cameras.push(camera);
        (self.refining, self.track) = (None, None);
        Ok(Sight::At(found.position, found.score))
    }

    fn admit(&mut self, frame: usize, time: f64, plane: &Plane) -> Result<(), Refusal> {
        let size = (plane.width(), plane.height());
        if *self.size.get_or_insert(size) != size {
            return Err(Refusal::Size { frame });
        }
        let step = self.last.map_or(0.0, |(last, _)| time - last);
        let turned = self.last.is_some_and(|(_, sense)| step == 0.0 || step * sense < 0.0);
        if !time.is_finite() || turned {
            return Err(Refusal::Order { frame });
        }
        self.last = Some((time, step));
        Ok(())
    }

    /// Finds the body near its predicted position; `None` if nothing there resembles it.
    fn find(&mut self, plane: &Plane, time: f64) -> Option<Sighting> {
        let (tracker, template) = (self.tracker.as_mut()?, self.templates.last()?);
        let disc = template.disc;
        let trail = self.seen.get(tracker.begin..).unwrap_or_default();
        let trail = trail.get(trail.len().saturating_sub(TOUCHED + 4)..).unwrap_or_default();
        // Bodies that touch disturb one another's positions: the prediction uses those before.
        let touched = trail.iter().rev().take_while(|one| !one.free).count();
        let counts = |one: &&Seen| one.free || touched >= TOUCHED || trail.len() < 4;
        let trail: Vec<(f64, [f64; 2])> =
            trail.iter().filter(counts).map(|one| (one.time, one.first.position)).collect();
        let course = course(&trail, time, disc.outline)?;
        let reach = course.reach * (1.0 + 0.4 * tracker.hidden as f64);
        let mut found = tracker.find(plane, template, (course.place, reach), AGREES);
        if found.is_none() && trail.len() > 1 {
            let around = (course.last, course.way + 0.5 * disc.outline + 2.0);
            found = tracker.find(plane, template, around, PUSHED).map(|one| Sighting { aside: true, ..one });
        }
        if let Some(one) = &found {
            let was_apart = tracker.rivals.are_apart();
            let told = tracker.rivals.take(&trail, ((time, one.found.position), disc.outline), (one.rival, one.free));
            if was_apart && !tracker.rivals.are_apart() {
                // The other body has touched this one before it was seen.
                self.seen.iter_mut().rev().take_while(|one| !one.free).for_each(|one| one.alone = false);
            }
            let met = self.seen.iter_mut().skip(tracker.begin).rev().take_while(|one| !one.alone);
            match told {
                Some(Told::Same(curve)) => {
                    let limit = NEAR.0.max(NEAR.1 * disc.outline);
                    let is_near = |one: &Seen| {
                        curve.as_ref().map_or(one.free, |curve| curve.off(one.time, one.first.position) < limit)
                    };
                    met.filter(|one| is_near(one)).for_each(|one| one.alone = true);
                }
                Some(Told::Other(place)) => {
                    found = tracker.find(plane, template, (place, disc.outline + 2.0), AGREES);
                    tracker.begin = self.seen.len();
                }
                None => {}
            }
        }
        let outside = ([course.place[0] + disc.shift[0], course.place[1] + disc.shift[1]], disc.radius + reach);
        let (body, uncovered) = match &found {
            Some(sighting) => ((disc.middle(sighting.found.position), disc.radius), (outside.0, 5.0 * disc.radius)),
            None => (outside, (outside.0, 0.0)),
        };
        tracker.background.learn(plane, body, uncovered);
        found
    }

    /// Continues the refinement by `steps` steps of about the work of one frame. Returns true once the track is
    /// complete.
    pub fn advance(&mut self, steps: usize) -> bool {
        let refining = self.refining.get_or_insert_with(|| Refining::new(self.templates.clone()));
        for _ in 0..steps {
            if self.track.is_some() {
                break;
            }
            if self.seen.is_empty() || refining.step(&mut self.seen) {
                let height = self.size.map_or(1.0, |(_, height)| height as f64);
                let seen = (self.seen.as_slice(), self.cameras.as_slice());
                self.track =
                    Some(joined(self.settings.readout, (&self.templates, &self.moved), height, seen, self.lost));
            }
        }
        self.track.is_some()
    }

    /// Completes the refinement.
    pub fn finish(&mut self) -> Track {
        while !self.advance(usize::MAX) {}
        self.track.clone().unwrap_or_default()
    }

    /// Radius of the last outline, px; `None` before the first click.
    pub fn radius(&self) -> Option<f64> {
        self.templates.last().map(|template| template.disc.outline)
    }

    /// Track, once it is complete.
    pub fn track(&self) -> Option<&Track> {
        self.track.as_ref()
    }
}

impl Tracker {
    /// Finds the body within `reach` px of a point, with an agreement of at least `part_of_best` times the best
    /// possible one.
    fn find(
        &mut self,
        plane: &Plane,
        first: &Template,
        (around, reach): ([f64; 2], f64),
        part_of_best: f32,
    ) -> Option<Sighting> {
        let disc = first.disc;
        let compared = self.background.compare(plane);
        let (middle, mut agreement) = self.look.search(&compared, disc.middle(around), reach);
        let place = [middle[0] - disc.shift[0], middle[1] - disc.shift[1]];
        let part = Part::around(plane, place, disc.reach() + MARGIN, self.axis.as_ref())?;
        let mut found = first.align(&part, place, 2.0);
        if found.score < CLEAR {
            let now = self.now.align(&part, place, 2.0);
            if now.score > found.score {
                found = now;
            }
        }
        let own = self.look.at(&compared, disc.middle(found.position));
        if found.score < SCORE || own.score < agreement.score - 0.1 {
            // Position by the outline only, accurate to about 1 px.
            found = Found { position: place, variance: [1.0; 2], settled: true, light: [1.0, 0.0], ..found };
        } else {
            agreement = own;
        }
        let seen = agreement.best > DISTINCT || found.score >= SCORE;
        if !seen || agreement.score < part_of_best * agreement.best {
            return None;
        }
        let free = agreement.outside < self.around + TOUCH;
        // A body that comes slowly would become part of the appearance.
        if free && !self.rivals.have_met() {
            self.around = if self.around < 1.0 {
                self.around + 0.2 * (agreement.outside - self.around)
            } else {
                agreement.outside
            };
        }
        if free && found.score >= SCORE && agreement.score > WHOLE * agreement.best {
            self.now.follow(&part, &found, PACE);
            self.look.follow(&compared, disc.middle(found.position));
        }
        let agreement = f64::from(agreement.score / agreement.best.max(f32::MIN_POSITIVE));
        let around = (disc.middle(found.position), disc.outline);
        let rival = self.look.rival(&compared, around, self.rivals.range(disc.outline));
        let rival = rival.map(|[x, y]| {
            let place = [x - disc.shift[0], y - disc.shift[1]];
            let part = Part::around(plane, place, disc.reach() + MARGIN, self.axis.as_ref());
            let aligned = part.map(|part| first.align(&part, place, 2.0)).filter(|found| found.score >= CLEAR);
            aligned.map_or(place, |found| found.position)
        });
        Some(Sighting { found, agreement, aside: self.hidden > 0, free, rival })
    }
}
