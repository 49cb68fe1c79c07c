//! A body such as a pendulum's bob or a ball.
//!
//! [`Body::take`] finds the body in each frame by a fixed template from the last key frame, and keeps the pixels around it. Then
//! [`Body::advance`] finds the positions again by the mean of those pixels.

mod disc;
mod part;
mod refining;
mod template;

pub(crate) use disc::Disc;
pub(crate) use part::Part;
use template::Found;
pub(crate) use template::Template;

use crate::plane::Plane;
use crate::tracking::column::Click;
use crate::tracking::errors::{outliers, scaled};
use crate::tracking::motion::motion;
use crate::tracking::refusal::Refusal;
use crate::tracking::similarity::Similarity;
use crate::tracking::track::{Known, Point, Readout, Track};
use refining::{Refining, Seen};

/// Below this correlation a body is lost.
const SCORE: f64 = 0.6;
/// Below this correlation a wider part of the picture is searched.
const CLEAR: f64 = 0.85;
/// A place further away must agree better by this much: other bodies may look alike, and this one may be blurred.
const BETTER: f64 = 0.15;
/// Pixels around the predicted position that are always searched.
const NEAR: f64 = 6.0;
/// The part of the picture's height around the predicted position that is searched where nothing is found near it.
const WIDE: f64 = 1.0 / 6.0;
/// The greatest radius of a body as a part of the picture's height, if it is not given.
const RADIUS: f64 = 1.0 / 9.0;
/// Bytes of the pixels that are kept.
const BYTES: usize = 96 << 20;
/// A point that lies more of its standard errors from what its neighbours predict is doubtful.
const DEVIATION: f64 = 6.0;
/// Pixels around a template that comparisons need: the steps of an alignment, and what interpolation reaches.
pub(crate) const MARGIN: f64 = 5.0;

/// What is known before the first frame.
#[derive(Clone, Debug, PartialEq)]
pub struct Settings {
    /// Where the body was clicked: in the frame where tracking begins, and in key frames, from which further templates are taken.
    pub keys: Vec<Click>,
    /// The radius of the disc that is compared, in pixels; without it that of the ring around the click on which
    /// the grey value changes most, with a margin.
    pub radius: Option<f64>,
    /// The time that the camera takes to read a frame; not estimated for bodies, and zero unless it is known.
    pub readout: Known,
}

/// What a frame shows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Sight {
    /// The body was not clicked yet.
    Before,
    /// The body is at this position of the picture in pixels, with this correlation.
    At([f64; 2], f64),
    /// The body was not found; it is not sought until the next key frame.
    Lost,
}

/// The tracking of a body.
pub struct Body {
    settings: Settings,
    size: Option<(usize, usize)>,
    /// Time and sense of the last frame.
    last: Option<(f64, f64)>,
    templates: Vec<Template>,
    seen: Vec<Seen>,
    cameras: Vec<Similarity>,
    bytes: usize,
    lost: Option<usize>,
    searching: bool,
    refining: Option<Refining>,
    track: Option<Track>,
}

impl Body {
    /// Prepares for the first frame.
    pub fn new(settings: Settings) -> Body {
        Body {
            settings,
            size: None,
            last: None,
            templates: Vec::new(),
            seen: Vec::new(),
            cameras: Vec::new(),
            bytes: 0,
            lost: None,
            searching: false,
            refining: None,
            track: None,
        }
    }

    /// Takes the next frame, in the order of time or against it (seconds). `camera` says how the camera has moved since the
    /// first frame ([`Similarity::IDENTITY`] on a tripod).
    ///
    /// # Errors
    ///
    /// Where a click lies outside the picture or on a uniform place, the frame has another size or does not follow the one
    /// before, or the film is too long.
    pub fn take(&mut self, frame: usize, time: f64, plane: &Plane, camera: Similarity) -> Result<Sight, Refusal> {
        self.admit(frame, time, plane)?;
        let key = self.settings.keys.iter().rev().find(|key| key.frame == frame).copied();
        let found = if self.searching { self.find(plane, time) } else { None };
        let found = match key {
            Some(click) => Some(self.begin(plane, click.position, found)?),
            None => found,
        };
        let Some(found) = found else {
            if !self.searching {
                return Ok(if self.templates.is_empty() { Sight::Before } else { Sight::Lost });
            }
            self.searching = false;
            self.lost = self.lost.or(Some(frame));
            return Ok(Sight::Lost);
        };
        self.searching = true;
        let reach = self.templates.last().map_or(0.0, |template| template.disc.reach());
        // A body that was found lies in the picture.
        let part = Part::around(plane, found.position, reach + MARGIN).ok_or(Refusal::Plain)?;
        self.bytes += part.plane.grey().len();
        if self.bytes > BYTES {
            return Err(Refusal::Long { frames: self.seen.len() });
        }
        self.seen.push(Seen {
            frame,
            time,
            key: self.templates.len().saturating_sub(1),
            part,
            first: found,
            now: found,
        });
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

    /// The template of a key frame. Where the template before it finds the body at the click, too, the same point of the
    /// body is followed further.
    fn begin(&mut self, plane: &Plane, [x, y]: [f64; 2], found: Option<Found>) -> Result<Found, Refusal> {
        let (wide, high) = (plane.width() as f64, plane.height() as f64);
        if !(0.0..=wide).contains(&x) || !(0.0..=high).contains(&y) {
            return Err(Refusal::Click { x, y });
        }
        let given = self.settings.radius.filter(|radius| radius.is_finite());
        let greatest = (high / 3.0).clamp(3.0, 100.0);
        let part = Part::around(plane, [x, y], 1.5 * greatest + MARGIN).ok_or(Refusal::Plain)?;
        let disc = match given {
            Some(radius) => Disc { shift: [0.0; 2], radius: radius.clamp(3.0, greatest) },
            None => disc::around(&part, [x, y], (RADIUS * high).clamp(3.0, greatest)),
        };
        let near = |found: &Found| (found.position[0] - x).abs().max((found.position[1] - y).abs()) < 0.3 * disc.radius;
        let position = found.filter(near).map_or([x, y], |found| found.position);
        let template = Template::new(&part, position, disc);
        if template.plain() {
            return Err(Refusal::Plain);
        }
        let found = template.align(&part, position, 0.5);
        self.templates.push(template);
        // The track before a click after a loss says nothing about the motion after it.
        Ok(Found { position, ..found })
    }

    /// The body near where its motion predicts it; `None` where nothing there resembles it.
    fn find(&self, plane: &Plane, time: f64) -> Option<Found> {
        let template = self.templates.last()?;
        let high = plane.height() as f64;
        let recent = &self.seen[self.seen.len().saturating_sub(3)..];
        let times: Vec<f64> = recent.iter().map(|one| one.time).collect();
        let late = time - times.last()?;
        let coordinate = |k: usize| {
            let values: Vec<f64> = recent.iter().map(|one| one.first.position[k]).collect();
            let last = values.len() - 1;
            let (velocity, acceleration) = match values.len() {
                2 => ((values[1] - values[0]) / (times[1] - times[0]), 0.0),
                _ => motion(&times, &values, last),
            };
            (values[last] + velocity * late + acceleration * late * late / 2.0, (velocity * late).abs())
        };
        let ((x, across), (y, down)) = (coordinate(0), coordinate(1));
        let near = (NEAR + 0.3 * (across + down)).min(WIDE * high);
        let mut best = template.search(plane, [x, y], near);
        if best.1 < CLEAR {
            let last = recent.last()?.first.position;
            let enough = if best.1 < SCORE { best.1 } else { best.1 + BETTER };
            for centre in [[x, y], last] {
                let place = template.search(plane, centre, WIDE * high);
                if place.1 > enough.max(best.1) {
                    best = place;
                }
            }
        }
        let part = Part::around(plane, best.0, template.disc.reach() + MARGIN)?;
        let found = template.align(&part, best.0, 2.0);
        (found.score >= SCORE).then_some(found)
    }

    /// Continues the refinement by as many steps, each of which does the work of about one frame. True once the track is complete.
    pub fn advance(&mut self, steps: usize) -> bool {
        let refining = self.refining.get_or_insert_with(|| Refining::new(self.templates.clone()));
        for _ in 0..steps {
            if self.track.is_some() {
                break;
            }
            if self.seen.is_empty() || refining.step(&mut self.seen) {
                self.track = Some(joined(&self.settings, self.size, &self.seen, &self.cameras, self.lost));
            }
        }
        self.track.is_some()
    }

    /// The whole refinement at once.
    pub fn finish(&mut self) -> Track {
        while !self.advance(usize::MAX) {}
        self.track.clone().unwrap_or_default()
    }

    /// The track, once it is complete.
    pub fn track(&self) -> Option<&Track> {
        self.track.as_ref()
    }
}

/// The track with times and errors, in the order of time.
fn joined(
    settings: &Settings,
    size: Option<(usize, usize)>,
    seen: &[Seen],
    cameras: &[Similarity],
    lost: Option<usize>,
) -> Track {
    let readout = match settings.readout {
        Known::Seconds(seconds) => Some(Readout { seconds, sigma: 0.0 }),
        Known::Estimated => None,
    };
    let seconds = readout.map_or(0.0, |readout| readout.seconds);
    let height = size.map_or(1.0, |(_, height)| height as f64);
    let mut order: Vec<usize> = (0..seen.len()).collect();
    order.sort_by(|a, b| seen[*a].time.total_cmp(&seen[*b].time));
    let mut points: Vec<Point> = Vec::with_capacity(seen.len());
    let mut formal = [Vec::new(), Vec::new()];
    for at in order {
        let (one, camera) = (&seen[at], &cameras[at]);
        let now = one.now;
        for (formal, variance) in formal.iter_mut().zip(now.variance) {
            formal.push(variance.sqrt());
        }
        points.push(Point {
            frame: one.frame,
            time: one.time + seconds * (now.position[1] / height - 0.5),
            position: camera.undo(now.position),
            sigma: [0.0; 2],
            score: now.score,
            doubtful: now.score < SCORE || !now.settled,
        });
    }
    let times: Vec<f64> = points.iter().map(|point| point.time).collect();
    for (k, formal) in formal.iter().enumerate() {
        let values: Vec<f64> = points.iter().map(|point| point.position[k]).collect();
        let sigmas = scaled(&times, &values, formal);
        let outliers = outliers(&times, &values, &sigmas, DEVIATION);
        for ((point, sigma), outlier) in points.iter_mut().zip(sigmas).zip(outliers) {
            point.sigma[k] = sigma;
            point.doubtful |= outlier;
        }
    }
    Track { points, exposure: None, readout, direction: None, lost }
}
