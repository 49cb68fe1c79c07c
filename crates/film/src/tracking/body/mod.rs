//! Tracking of a body such as a ball or the bob of a pendulum.
//!
//! [`Body::take`] searches each frame near the predicted position for shades of the body that differ from the
//! background, and keeps the pixels around it. [`Body::advance`] then improves the positions with the mean of those
//! pixels.
//!
//! A body is found near where its motion leads (`course.rs`), by pixels that are nearer to its look (`look.rs`) than to what
//! stands still behind it (`background.rs`), and then by the mean of what all frames show of it. Colours are read frame by
//! frame; what is kept around the body is one byte a pixel (`part.rs`).
//!
//! A second body of the same look is followed beside it (`alike.rs`, `rival.rs`). After they have met, the vector between
//! them shows exchanges (`exchanges.rs`), or smooth curves do where one was not seen before (`meeting.rs`,
//! `tracking/crossing.rs`). A second body that is nowhere in the frame of the click was covered there (`covering.rs`).
//! `joining.rs` has the doubts of frames, `evidence.rs` those of whole templates.

mod alike;
mod appearance;
mod background;
mod course;
mod covering;
mod disc;
mod evidence;
mod exchanges;
mod finding;
mod frame;
mod joining;
mod look;
mod meeting;
mod moving;
mod outline;
mod part;
mod refining;
mod region;
mod rival;
mod shape;
mod start;
mod starting;
mod template;

use appearance::{Appearance, Sighting};
use background::Background;
pub(crate) use disc::Disc;
use evidence::Evidence;
use moving::Moving;
pub(crate) use part::{MARGIN, Part};
pub(crate) use shape::Shape;
pub(crate) use template::Template;

use crate::plane::Plane;
use crate::tracking::column::Click;
use crate::tracking::refusal::Refusal;
use crate::tracking::similarity::Similarity;
use crate::tracking::track::{Known, Track};
use frame::Frame;
use joining::joined;
use refining::{Refining, Seen};
use rival::{HIDDEN, Rival};
use start::{Shot, Start};

/// Maximum radius of a body relative to the height of the picture, if it is not given.
const RADIUS: f64 = 1.0 / 9.0;
/// Maximum size of the kept pixels in bytes.
const BYTES: usize = 96 << 20;

/// Settings of the tracking of a body.
#[derive(Clone, Debug, PartialEq)]
pub struct Settings {
    /// Clicks on the body: in the first frame, and in key frames that supply further templates. Positions in px.
    pub keys: Vec<Click>,
    /// Radius of the outline, px. Default: that of what has moved at the click; until it has left that place, that of the circle around the click
    /// with the largest contrast.
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
    appearance: Appearance,
    background: Background,
    /// Number of frames since the body was seen.
    hidden: usize,
    /// First frame without the body.
    since: usize,
    /// Index of the first sighting of the present motion.
    begin: usize,
    moving: Moving,
    /// A second body of the same look.
    rival: Option<Rival>,
    /// True if it may be exchanged for the body in the last frame.
    exchangeable: bool,
    /// Frame and position (px) of the click, until a second body has been sought there.
    clicked: Option<(Plane, [f64; 2])>,
    /// True from a meeting on after which the motion does not show which body is which.
    is_mistaken: bool,
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
    /// One per template.
    evidence: Vec<Evidence>,
    tracker: Option<Tracker>,
    /// The click and the frames from there on, until the body has left its first place.
    start: Option<Start>,
    seen: Vec<Seen>,
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
            evidence: Vec::new(),
            tracker: None,
            start: None,
            seen: Vec::new(),
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
        let sight = self.follow(Frame { number: frame, time, plane, camera })?;
        let Some(start) = self.start.take() else { return Ok(sight) };
        Ok(self.leave(start, Shot { number: frame, time, plane: plane.clone(), camera })?.unwrap_or(sight))
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
    fn follow(&mut self, frame: Frame<'_>) -> Result<Sight, Refusal> {
        let key = self.settings.keys.iter().rev().find(|key| key.frame == frame.number).copied();
        let sighting = self.find(frame);
        let sighting = match key {
            Some(click) => Some(self.begin(frame, click.position, sighting)?),
            None => sighting,
        };
        let sight = self.sight(frame, sighting)?;
        self.distinguish();
        Ok(sight)
    }

    /// Keeps what was found in a frame.
    fn sight(&mut self, frame: Frame<'_>, sighting: Option<Sighting>) -> Result<Sight, Refusal> {
        let Some(tracker) = &mut self.tracker else {
            return Ok(if self.templates.is_empty() { Sight::Before } else { Sight::Lost });
        };
        let Some(one) = sighting else {
            if tracker.hidden == 0 {
                tracker.since = frame.number;
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
        let position = one.found.position;
        let axis = tracker.appearance.axis.as_ref();
        let part = Part::around(frame.plane, position, reach + MARGIN, axis).ok_or(Refusal::Plain)?;
        self.bytes += part.plane.grey().len();
        if self.bytes > BYTES {
            return Err(Refusal::Long { frames: self.seen.len() });
        }
        let key = self.templates.len().saturating_sub(1);
        if let Some(Template { disc, .. }) = self.templates.last() {
            tracker.moving.take(&tracker.background, (frame.plane, position), *disc, self.seen.len());
        }
        if let Some(evidence) = self.evidence.last_mut() {
            evidence.moved |= tracker.moving.moved;
        }
        let moves = !tracker.moving.rests;
        if !moves {
            let since = self.seen.iter_mut().skip(tracker.moving.last + 1).rev().take_while(|one| one.moves);
            since.for_each(|one| one.moves = false);
        }
        let seen = Seen::new(frame, key, part, &one);
        self.seen.push(Seen { moves, alone: !tracker.is_mistaken, ..seen });
        (self.refining, self.track) = (None, None);
        Ok(Sight::At(position, one.found.score))
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

    /// Continues the refinement by `steps` steps of about the work of one frame. Returns true once the track is
    /// complete.
    pub fn advance(&mut self, steps: usize) -> bool {
        // An error leaves the track as it is.
        let _ = self.end();
        let refining = self.refining.get_or_insert_with(|| Refining::new(self.templates.clone()));
        for _ in 0..steps {
            if self.track.is_some() {
                break;
            }
            if self.seen.is_empty() || refining.step(&mut self.seen) {
                let height = self.size.map_or(1.0, |(_, height)| height as f64);
                let templates = (self.templates.as_slice(), self.evidence.as_slice());
                self.track = Some(joined(self.settings.readout, templates, height, &self.seen, self.lost));
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
