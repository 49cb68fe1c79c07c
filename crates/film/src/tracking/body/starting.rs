//! Start of a track: template of a click, and the disc of the body once it has left its first place.

use crate::plane::Plane;
use crate::tracking::body::alike::{LIKE, sought};
use crate::tracking::body::appearance::{AGREES, Appearance, Sighting};
use crate::tracking::body::background::Background;
use crate::tracking::body::disc::{Disc, around};
use crate::tracking::body::evidence::Evidence;
use crate::tracking::body::frame::Frame;
use crate::tracking::body::look::Look;
use crate::tracking::body::meeting::far;
use crate::tracking::body::moving::Moving;
use crate::tracking::body::outline::Outline;
use crate::tracking::body::part::{Axis, MARGIN, Part};
use crate::tracking::body::refining::Seen;
use crate::tracking::body::region::{Region, completed, disc_region, region};
use crate::tracking::body::rival::Rival;
use crate::tracking::body::shape::Shape;
use crate::tracking::body::start::{Shot, Start};
use crate::tracking::body::template::{Found, Template};
use crate::tracking::body::{Body, RADIUS, Sight, Tracker, greatest, radii};
use crate::tracking::refusal::Refusal;

/// Numbers of frames after a click at which the body may have left its place, and the last one.
const AGES: [usize; 8] = [4, 8, 12, 16, 24, 32, 48, LATEST];
const LATEST: usize = 64;
/// Maximum difference of the discs after two numbers of frames, relative to the radius.
const STABLE: f64 = 0.125;
/// Numbers of sightings that show the whole body: about so many are compared, and no fewer than the second.
const SIGHTINGS: usize = 12;
const FEWEST: usize = 4;
/// Width in px of the ring around the body that is taken for covered, too.
const UNCOVERED: f64 = 8.0;
/// Maximum difference of a disc from that of a template, relative to the radius, for which the track stays as it is.
const SAME: f64 = 0.1;
/// Maximum size of the kept frames in bytes.
const BYTES: usize = 64 << 20;

impl Body {
    /// Disc with the given radius, if any, in a picture of `high` rows.
    pub(super) fn given(&self, high: f64) -> Option<Disc> {
        let given = self.settings.radius.filter(|radius| radius.is_finite());
        let [least, greatest] = radii(high);
        given.map(|radius| Disc::of([0.0; 2], radius.clamp(least, greatest)))
    }

    /// Makes the template of a key frame. If the previous template finds the body near the click, the same point of the
    /// body is tracked further.
    pub(super) fn begin(
        &mut self,
        frame: Frame<'_>,
        [x, y]: [f64; 2],
        sighting: Option<Sighting>,
    ) -> Result<Sighting, Refusal> {
        let plane = frame.plane;
        let (wide, high) = (plane.width() as f64, plane.height() as f64);
        if !(0.0..=wide).contains(&x) || !(0.0..=high).contains(&y) {
            return Err(Refusal::Click { x, y });
        }
        let given = self.given(high);
        let disc = match given {
            Some(disc) => disc,
            None => around(plane, [x, y], (RADIUS * high).clamp(3.0, greatest(high))),
        };
        let near = |one: &Sighting| {
            let [u, v] = one.found.position;
            (u - x).abs().max((v - y).abs()) < 0.3 * disc.radius
        };
        let continued = sighting.filter(near);
        let position = continued.as_ref().map_or([x, y], |one| one.found.position);
        let background = self.tracker.take().filter(|_| continued.is_some()).map(|tracker| tracker.background);
        let moved = continued.is_some() && self.evidence.last().is_some_and(|evidence| evidence.moved);
        if continued.is_none() {
            self.start = Some(Start::new(position, (self.seen.len(), self.templates.len()), self.lost));
        }
        let body = (disc, Shape::disc(disc.outline));
        let found = self.start(frame, position, body, background).map_err(|refusal| match given {
            Some(Disc { outline, .. }) if refusal == Refusal::Plain => Refusal::PlainDisc { radius: outline },
            _ => refusal,
        })?;
        if let Some(evidence) = self.evidence.last_mut() {
            evidence.moved = moved;
        }
        let begin = if continued.is_some() { self.seen.len().saturating_sub(3) } else { self.seen.len() };
        if let Some(tracker) = &mut self.tracker {
            tracker.begin = begin;
            if continued.is_some() {
                tracker.clicked = None;
            }
        }
        let aside = continued.is_some_and(|one| one.aside);
        Ok(Sighting::clicked(found, aside))
    }

    /// Makes the template of the body at a position, px.
    pub(super) fn start(
        &mut self,
        frame: Frame<'_>,
        position: [f64; 2],
        (disc, shape): (Disc, Shape),
        background: Option<Background>,
    ) -> Result<Found, Refusal> {
        let plane = frame.plane;
        let middle = disc.middle(position);
        let is_found = background.is_some() && self.settings.radius.is_none();
        let mut background = background.unwrap_or_else(|| Background::new(plane, (middle, disc.radius)));
        let compared = background.compare(plane);
        let look = Look::new(&compared, middle, &shape);
        let axis = plane.colour().and_then(|_| {
            let [body, around] = look.shades(&compared, middle);
            Axis::between(body, around)
        });
        let part = Part::around(plane, position, disc.reach() + MARGIN, axis.as_ref()).ok_or(Refusal::Plain)?;
        let template = Template::new(&part, position, disc, &shape);
        if template.plain() {
            return Err(Refusal::Plain);
        }
        let found = template.align(&part, position, 0.5, None);
        let now = template.clone();
        let moving = Moving::new(plane, position, self.seen.len());
        let outline = is_found.then(|| Outline::new(shape, &compared, middle));
        let appearance = Appearance { look, now, axis, outline, around: 1.0 };
        let near = sought(disc.outline, 0.0);
        let twin = appearance.look.likest(&background.compare(plane), (middle, disc.outline), (near, LIKE));
        let rival = twin.and_then(|twin| {
            background.hide((twin, disc.radius));
            let place = [twin[0] - disc.shift[0], twin[1] - disc.shift[1]];
            let one = appearance.seek((&background.compare(plane), &template), (place, 2.0), AGREES, Some(position))?;
            Rival::at(frame, self.templates.len(), &one, &appearance)
        });
        let is_alone = rival.is_none();
        self.tracker = Some(Tracker {
            appearance,
            background,
            hidden: 0,
            since: 0,
            begin: 0,
            moving,
            rival,
            exchangeable: false,
            clicked: Some((plane.clone(), position)).filter(|_| is_alone),
            is_mistaken: false,
        });
        self.templates.push(template);
        let is_outline_certain = self.given(plane.height() as f64).is_some();
        self.evidence.push(Evidence { moved: false, is_outline_certain });
        Ok(Found { position, ..found })
    }

    /// Keeps a frame after a click. Once the body has left its place there, its shape and the background behind it are
    /// known, and it is followed again from the click. Returns the new result of this frame.
    pub(super) fn leave(&mut self, mut start: Start, shot: Shot) -> Result<Option<Sight>, Refusal> {
        let size = shot.plane.grey().len() * if shot.plane.colour().is_some() { 3 } else { 2 } / 2;
        start.shots.push(shot);
        let age = start.shots.len() - 1;
        let is_full = age >= LATEST || (age + 2) * size > BYTES;
        if !AGES.contains(&age) {
            self.start = Some(start).filter(|_| !is_full);
            return Ok(None);
        }
        let found = self.region(&start);
        let is_like = |one: &Region, other: &Option<Region>| {
            let most = (STABLE * one.disc.outline).max(1.0);
            other.as_ref().is_some_and(|other| one.disc.difference(other.disc) < most)
        };
        let [last, earlier] = &start.regions;
        // Where the body has been in most frames it is taken for the background: then its shape changes slowly.
        let is_certain = |one: &Region| is_like(one, last) && (one.is_vacated || one.has_left && is_like(one, earlier));
        let certain = found.clone().filter(is_certain);
        let [last, _] = std::mem::take(&mut start.regions);
        start.regions = [found, last];
        match certain {
            Some(region) => self.repeat(start, region),
            None => {
                self.start = Some(start).filter(|_| !is_full);
                Ok(None)
            }
        }
    }

    /// Uses the frames after a click at which the film has ended.
    pub(super) fn end(&mut self) -> Result<(), Refusal> {
        let Some(start) = self.start.take() else { return Ok(()) };
        match self.region(&start).filter(|region| region.has_left) {
            Some(region) => self.repeat(start, region).map(|_| ()),
            None => Ok(()),
        }
    }

    /// The clicked body by the frames since then.
    fn region(&self, start: &Start) -> Option<Region> {
        let planes = start.planes();
        let high = planes.first()?.height() as f64;
        match self.given(high) {
            Some(disc) => disc_region(&planes, start.click, disc),
            None => region(&planes, start.click, (RADIUS * high).clamp(3.0, greatest(high))),
        }
    }

    /// Follows the body again from the click, with its shape and the background behind it.
    fn repeat(&mut self, start: Start, region: Region) -> Result<Option<Sight>, Refusal> {
        // Later key frames continue this one.
        self.evidence.iter_mut().skip(start.templates).for_each(|evidence| evidence.moved = true);
        // One of two equal bodies covered the other at the click: what has moved there are both.
        let is_of_two = self.tracker.as_ref().is_some_and(|tracker| tracker.rival.as_ref().is_some_and(Rival::has_met))
            && self.seen.iter().skip(start.seen).all(|one| !one.alone);
        if is_of_two {
            return Ok(None);
        }
        // What is still found at the click is not the body, which has left that place.
        let has_left = self.seen.last().is_some_and(|one| far(one.first.position, start.click) > region.disc.outline);
        let is_given = self.settings.radius.is_some();
        let is_same = self
            .templates
            .get(start.templates)
            .is_some_and(|template| is_given || template.disc.difference(region.disc) < SAME * region.disc.outline);
        let followed = self.tracker.as_mut().filter(|tracker| has_left && is_same && tracker.hidden == 0);
        if let Some((tracker, shot)) = followed.zip(start.shots.last()) {
            if let Some(evidence) = self.evidence.get_mut(start.templates) {
                evidence.is_outline_certain = true;
            }
            if let Some(one) = self.seen.last().filter(|_| !is_given) {
                let middle = region.disc.middle(one.first.position);
                let compared = tracker.background.compare(&shot.plane);
                tracker.appearance.outline = Some(Outline::new(region.shape, &compared, middle));
            }
            return Ok(None);
        }
        let sight = self.replay(&start, (region.disc, region.shape.clone()))?;
        match self.completed(&start, &region) {
            Some(body) => self.replay(&start, body),
            None => Ok(sight),
        }
    }

    /// The body with what moved beside it since the click, if anything did.
    fn completed(&self, start: &Start, region: &Region) -> Option<(Disc, Shape)> {
        let tracker = self.tracker.as_ref().filter(|_| self.settings.radius.is_none())?;
        let of = |one: &Seen| start.shots.iter().find(|shot| shot.number == one.frame).map(|shot| &shot.plane);
        let found = self.seen.iter().skip(start.seen).filter(|one| one.key == start.templates);
        let seen: Vec<(&Plane, [f64; 2])> = found.filter_map(|one| Some((of(one)?, one.first.position))).collect();
        let stride = (seen.len() / SIGHTINGS).max(1);
        let seen: Vec<(&Plane, [f64; 2])> = seen.into_iter().step_by(stride).collect();
        (seen.len() >= FEWEST).then(|| completed((region.disc, &region.shape), &tracker.background, &seen)).flatten()
    }

    /// Follows a body from the click through the kept frames.
    fn replay(&mut self, start: &Start, body: (Disc, Shape)) -> Result<Option<Sight>, Refusal> {
        let Some(first) = start.shots.first() else { return Ok(None) };
        let planes = start.planes();
        let near = (body.0.middle(start.click), body.0.radius + UNCOVERED);
        let mut background = Background::new(&first.plane, near);
        background.reveal(&planes, near);
        self.seen.truncate(start.seen);
        self.templates.truncate(start.templates);
        self.evidence.truncate(start.templates);
        self.bytes = self.seen.iter().map(Seen::bytes).sum();
        self.lost = start.lost;
        let found = self.start(first.frame(), start.click, body, Some(background))?;
        if let Some(evidence) = self.evidence.last_mut() {
            *evidence = Evidence { moved: true, is_outline_certain: true };
        }
        if let Some(tracker) = &mut self.tracker {
            tracker.begin = start.seen;
        }
        let sighting = Sighting::clicked(found, false);
        let mut sight = self.sight(first.frame(), Some(sighting))?;
        for shot in start.shots.iter().skip(1) {
            sight = self.follow(shot.frame())?;
        }
        Ok(Some(sight))
    }
}
