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
use crate::tracking::body::part::{Axis, MARGIN, Part};
use crate::tracking::body::refining::Seen;
use crate::tracking::body::rival::Rival;
use crate::tracking::body::start::{Shot, Start};
use crate::tracking::body::template::{Found, Template};
use crate::tracking::body::vacated::vacated;
use crate::tracking::body::{Body, RADIUS, Sight, Tracker, greatest, radii};
use crate::tracking::refusal::Refusal;

/// Numbers of frames after a click at which the body may have left its place, and the last one.
const AGES: [usize; 8] = [4, 8, 12, 16, 24, 32, 48, LATEST];
const LATEST: usize = 64;
/// Maximum difference of the discs after two numbers of frames, relative to the radius.
const STABLE: f64 = 0.125;
/// Maximum difference of a disc from that of a template, relative to the radius, for which the track stays as it is.
const SAME: f64 = 0.25;
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
        let found = self.start(frame, position, disc, background).map_err(|refusal| match given {
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
        disc: Disc,
        background: Option<Background>,
    ) -> Result<Found, Refusal> {
        let plane = frame.plane;
        let middle = disc.middle(position);
        let mut background = background.unwrap_or_else(|| Background::new(plane, (middle, disc.radius)));
        let compared = background.compare(plane);
        let look = Look::new(&compared, middle, disc.outline);
        let axis = plane.colour().and_then(|_| {
            let [body, around] = look.shades(&compared, middle);
            Axis::between(body, around)
        });
        let part = Part::around(plane, position, disc.reach() + MARGIN, axis.as_ref()).ok_or(Refusal::Plain)?;
        let template = Template::new(&part, position, disc);
        if template.plain() {
            return Err(Refusal::Plain);
        }
        let found = template.align(&part, position, 0.5, None);
        let now = template.clone();
        let moving = Moving::new(plane, position, self.seen.len());
        let appearance = Appearance { look, now, axis, around: 1.0 };
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

    /// Keeps a frame after a click. Once the body has left its place there, its disc and the background behind it are
    /// known, and it is followed again from the click. Returns the new result of this frame.
    pub(super) fn leave(&mut self, mut start: Start, shot: Shot) -> Result<Option<Sight>, Refusal> {
        let high = shot.plane.height() as f64;
        let size = shot.plane.grey().len() * if shot.plane.colour().is_some() { 3 } else { 2 } / 2;
        start.shots.push(shot);
        let age = start.shots.len() - 1;
        if !AGES.contains(&age) {
            self.start = Some(start).filter(|_| (age + 2) * size <= BYTES);
            return Ok(None);
        }
        let planes: Vec<&Plane> = start.shots.iter().map(|shot| &shot.plane).collect();
        let greatest = (RADIUS * high).clamp(3.0, greatest(high));
        let found = vacated(&planes, start.click, greatest, self.given(high));
        let before = std::mem::replace(&mut start.disc, found.map(|found| found.0));
        let stable = |disc: Disc, before: Disc| disc.difference(before) < (STABLE * disc.outline).max(1.0);
        let certain = found.filter(|(disc, left)| *left && before.is_some_and(|before| stable(*disc, before)));
        let Some((disc, _)) = certain else {
            self.start = Some(start).filter(|_| age < LATEST && (age + 2) * size <= BYTES);
            return Ok(None);
        };
        // Later key frames continue this one.
        self.evidence.iter_mut().skip(start.templates).for_each(|evidence| evidence.moved = true);
        let is_same = |template: &Template| template.disc.difference(disc) < SAME * disc.outline;
        // What is still found at the click is not the body, which has left that place.
        let has_left = self.seen.last().is_some_and(|one| far(one.first.position, start.click) > disc.outline);
        let is_followed = has_left && self.templates.get(start.templates).is_some_and(is_same);
        if is_followed && self.tracker.as_ref().is_some_and(|tracker| tracker.hidden == 0) {
            if let Some(evidence) = self.evidence.get_mut(start.templates) {
                evidence.is_outline_certain = true;
            }
            return Ok(None);
        }
        let Some(first) = start.shots.first() else { return Ok(None) };
        let mut background = Background::new(&first.plane, (disc.middle(start.click), disc.radius));
        background.reveal(&planes, (disc.middle(start.click), disc.radius));
        self.seen.truncate(start.seen);
        self.templates.truncate(start.templates);
        self.evidence.truncate(start.templates);
        self.bytes = self.seen.iter().map(Seen::bytes).sum();
        self.lost = start.lost;
        let found = self.start(first.frame(), start.click, disc, Some(background))?;
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
