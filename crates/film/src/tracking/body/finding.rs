//! Search for a body, and for a second one of the same look, in the next frame.

use crate::tracking::body::alike::{RIVAL, sought};
use crate::tracking::body::appearance::Sighting;
use crate::tracking::body::background::{Around, Compared};
use crate::tracking::body::frame::Frame;
use crate::tracking::body::meeting::{Pair, far};
use crate::tracking::body::refining::Seen;
use crate::tracking::body::rival::{COVERED, Expected, MOST, Rival, trail};
use crate::tracking::body::template::Template;
use crate::tracking::body::{Body, Tracker};

/// Distance in radii below which bodies disturb one another's positions.
const TOUCHING: f64 = 2.6;

/// Number of frames after a click in which a second body is sought in the whole picture: it may have been covered at the click, and be faster
/// than those that meet.
const SOON: usize = 5;
/// Its agreement is at least this part of that of the body: both may resemble the picture of a click on both equally little.
const AS_LIKE: f32 = 0.85;

/// Both bodies in a frame.
struct Both {
    own: Option<Sighting>,
    own_expected: Expected,
    other: Option<Sighting>,
    other_expected: Option<Expected>,
}

impl Both {
    /// Positions of both, if both are seen.
    fn pair(&self) -> Option<Pair> {
        let (own, other) = self.own.as_ref().zip(self.other.as_ref())?;
        Some(Pair {
            own: own.found.position,
            own_predicted: self.own_expected.course.place,
            other: other.found.position,
            other_predicted: self.other_expected.as_ref().map(|expected| expected.course.place),
        })
    }
}

impl Tracker {
    /// Finds both bodies where their motions lead. Pixels of one do not count for the other.
    fn both(&self, (compared, first): (&Compared<'_>, &Template), own: Expected, other: Option<Expected>) -> Both {
        let radius = first.disc.outline;
        let seek =
            |expected: &Expected, beside: Option<[f64; 2]>| expected.seek(&self.appearance, (compared, first), beside);
        let place = |one: &Option<Sighting>| one.as_ref().map(|one| one.found.position);
        let alone = |own: Expected, other: Option<Expected>| {
            let is_near = |other: &Expected| far(other.course.place, own.course.place) < radius;
            let disturbed = other.as_ref().is_some_and(is_near);
            let found = seek(&own, None).map(|one| Sighting { free: one.free && !disturbed, ..one });
            Both { own: found, own_expected: own, other: None, other_expected: other }
        };
        let Some(expected) = other else { return alone(own, None) };
        let mut found = seek(&own, Some(expected.course.place));
        let mut rival = seek(&expected, Some(place(&found).unwrap_or(own.course.place)));
        if let Some((one, other)) =
            place(&found).zip(place(&rival)).filter(|(one, other)| far(*one, *other) < TOUCHING * radius)
        {
            found = seek(&own, Some(other));
            rival = seek(&expected, Some(place(&found).unwrap_or(one)));
        }
        // A body that the other one covers is not seen, and covers nothing.
        match rival.filter(|one| one.covered < COVERED && one.is_distinct) {
            Some(rival) => Both { own: found, own_expected: own, other: Some(rival), other_expected: Some(expected) },
            None => alone(own, Some(expected)),
        }
    }
}

impl Body {
    /// Finds the body near its predicted position; `None` if nothing there resembles it.
    pub(super) fn find(&mut self, frame: Frame<'_>) -> Option<Sighting> {
        let (tracker, template) = (self.tracker.as_mut()?, self.templates.last()?);
        let (disc, plane) = (template.disc, frame.plane);
        let own_trail = trail(self.seen.get(tracker.begin..).unwrap_or_default());
        let own = Expected::new(&own_trail, frame.time, disc.outline, tracker.hidden)?;
        let (expected_place, expected_reach) = (own.course.place, own.reach());
        // After one position the motion is unknown.
        let way = if own_trail.len() > 1 { own.course.way } else { disc.outline };
        let is_recent = tracker.clicked.is_some() && tracker.rival.is_none() && self.seen.len() - tracker.begin <= SOON;
        let mut range = sought(disc.outline, way);
        if is_recent {
            range.end = libm::hypot(plane.width() as f64, plane.height() as f64);
        }
        let other = tracker
            .rival
            .as_ref()
            .and_then(|rival| Expected::new(&trail(&rival.seen), frame.time, disc.outline, rival.hidden));
        let compared = tracker.background.compare(plane);
        let mut resized = None;
        let mut both = tracker.both((&compared, template), own, other);
        if let Some(own) = &both.own {
            let position = own.found.position;
            let least = if is_recent { RIVAL.min(AS_LIKE * own.agreement as f32) } else { RIVAL };
            let is_away = |other: &Sighting| far(other.found.position, position) > range.end;
            if !tracker.is_mistaken && both.other.as_ref().is_none_or(is_away) {
                let found = tracker.appearance.rival((&compared, template), position, (range.clone(), least));
                let is_known = |one: &Sighting| {
                    both.other
                        .as_ref()
                        .is_some_and(|other| far(other.found.position, one.found.position) < disc.outline)
                };
                // A body that was hidden has come out, or there is a third one.
                if let Some(one) = found.filter(|one| one.is_distinct && !is_known(one)) {
                    tracker.rival = tracker.rival.take().filter(Rival::has_met);
                    if both.other.is_none() || tracker.rival.is_none() {
                        (both.other, both.other_expected) = (Some(one), None);
                    }
                }
            }
            if both.other.as_ref().is_none_or(|other| far(other.found.position, position) > TOUCHING * disc.outline) {
                tracker.appearance.adapt(&compared, own);
                if both.other.is_none() && tracker.rival.is_none() {
                    resized = tracker.appearance.resize(&compared, own);
                }
            }
        }
        let around = |place: [f64; 2], reach: f64| -> Around { (disc.middle(place), disc.radius + reach) };
        let (body, uncovered) = match &both.own {
            Some(own) => (around(own.found.position, 0.0), 5.0 * disc.radius),
            None => (around(expected_place, expected_reach), 0.0),
        };
        let rival = both.other.as_ref().map(|other| around(other.found.position, 0.0));
        let uncovered = (disc.middle(expected_place), uncovered);
        tracker.background.learn(plane, &[Some(body), rival], uncovered);
        tracker.exchangeable = match both.pair() {
            Some(pair) => pair.may_be_exchanged(disc.outline),
            None => tracker.rival.is_some() && both.own.as_ref().is_none_or(|own| !own.free),
        };
        self.take_rival(frame, both.other);
        if let Some((template, evidence)) = resized.zip(self.evidence.last().copied()) {
            self.templates.push(template);
            self.evidence.push(evidence);
        }
        both.own
    }

    /// Takes the sighting of the other body.
    fn take_rival(&mut self, frame: Frame<'_>, sighting: Option<Sighting>) {
        let key = self.templates.len().saturating_sub(1);
        let Some(tracker) = self.tracker.as_mut().filter(|tracker| !tracker.is_mistaken) else { return };
        let Some(one) = sighting else {
            tracker.rival.iter_mut().for_each(|rival| rival.hidden += 1);
            return;
        };
        let rival = tracker.rival.get_or_insert_with(Rival::new);
        if rival.see(frame, key, &one, &tracker.appearance).is_none() {
            rival.hidden += 1;
        }
    }

    /// Decides which of two bodies is which, once they have met and are apart again, from all sightings up to this frame.
    pub(super) fn distinguish(&mut self) {
        let radius = self.templates.last().map_or(0.0, |template| template.disc.outline);
        let was_covered = self.was_covered();
        let Some(tracker) = &mut self.tracker else { return };
        let Some(rival) = &mut tracker.rival else { return };
        let mut settled = rival.take((&self.seen, tracker.begin), (tracker.exchangeable, was_covered), radius);
        let is_over = rival.is_over(&self.seen, radius);
        if is_over {
            settled = settled.or_else(|| rival.settle((&self.seen, tracker.begin), MOST, radius));
        }
        if let Some(from) = rival.from() {
            self.seen.iter_mut().skip(from).for_each(|one| one.alone = false);
        }
        if let Some(settled) = settled {
            rival.assign(&mut self.seen, settled);
            self.bytes = self.seen.iter().map(Seen::bytes).sum();
        }
        if is_over {
            tracker.is_mistaken |= rival.from().is_some();
            tracker.rival = None;
        }
    }
}
