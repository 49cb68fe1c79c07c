//! A second body of the same look, which is followed beside the body, so that neither is taken for the other.

use crate::tracking::body::appearance::{AGREES, Appearance, Sighting};
use crate::tracking::body::background::Compared;
use crate::tracking::body::course::{Course, course};
use crate::tracking::body::exchanges::{Assigned, Vector, exchanges};
use crate::tracking::body::frame::Frame;
use crate::tracking::body::meeting::{Sides, far};
use crate::tracking::body::part::{MARGIN, Part};
use crate::tracking::body::refining::Seen;
use crate::tracking::body::template::Template;
use crate::tracking::crossing::Place;

/// Minimum agreement away from the predicted position, where similar objects may be. The body may have been pushed.
const PUSHED: f32 = 0.7;
/// Number of frames after which a touching object counts as part of the appearance.
const TOUCHED: usize = 5;
/// Number of positions below which those of a body that something touched are used, too.
const FEWEST: usize = 3;
/// Maximum number of frames in which a hidden body is sought.
pub(super) const HIDDEN: usize = 10;
/// A body of which another one covers more than this is not seen.
pub(super) const COVERED: f32 = 0.85;
/// Relative way in radii after which a rival that was covered must have come out.
const PASSED: f64 = 8.0;
/// Maximum number of frames in which a covered rival is awaited.
const AWAITED: usize = 60;
/// Numbers of positions on each side of a meeting by which the motion distinguishes the bodies, and the greatest one.
const SIDES: [usize; 5] = [5, 8, 12, 16, MOST];
pub(super) const MOST: usize = 24;
/// Maximum distance from the smooth curve through a meeting, px and relative to the radius, of a position that is certain.
const NEAR: (f64, f64) = (2.5, 0.1);
/// Number of frames in which the motion of a body is about straight.
const EARLY: usize = 8;
/// Distance in radii below which bodies cover one another in part.
const COVERING: f64 = 2.0;
/// Distance in radii beyond which a body was at the click if it has passed since, and number of frames until it touched the other one.
const AWAY: f64 = 4.0;
const ALONE: usize = 4;
/// A thing that was seen in fewer frames may be a pattern of the background.
const SIGHTINGS: usize = 3;

/// Positions that predictions use: those of bodies that nothing touches, or of a body that has been touched for long.
pub(super) fn trail(seen: &[Seen]) -> Vec<Place> {
    let trail = seen.get(seen.len().saturating_sub(TOUCHED + 4)..).unwrap_or_default();
    // Bodies that touch disturb one another's positions: the prediction uses those before.
    let touched = trail.iter().rev().take_while(|one| !one.free).count();
    let free = trail.iter().filter(|one| one.free).count();
    let counts = |one: &&Seen| one.free || touched >= TOUCHED || free < FEWEST;
    trail.iter().filter(counts).map(Seen::place).collect()
}

/// Motion that predicts a position, with the number of positions and of frames since the last one.
pub(super) struct Expected {
    pub course: Course,
    known: usize,
    hidden: usize,
}

impl Expected {
    /// `None` without positions.
    pub(super) fn new(trail: &[Place], time: f64, radius: f64, hidden: usize) -> Option<Expected> {
        Some(Expected { course: course(trail, time, radius)?, known: trail.len(), hidden })
    }

    /// Radius of the search, px.
    pub(super) fn reach(&self) -> f64 {
        self.course.reach * (1.0 + 0.4 * self.hidden as f64)
    }

    /// Finds a body where its motion leads, or else near its last position, since it may have been pushed. `other`: position of a body of the
    /// same look, px.
    pub(super) fn seek(
        &self,
        appearance: &Appearance,
        (compared, first): (&Compared<'_>, &Template),
        other: Option<[f64; 2]>,
    ) -> Option<Sighting> {
        let Course { place, last, way, .. } = self.course;
        let found = appearance.seek((compared, first), (place, self.reach()), AGREES, other);
        if found.is_some() || self.known < 2 {
            return found.map(|one| Sighting { aside: self.hidden > 0, ..one });
        }
        let around = (last, way + 0.5 * first.disc.outline + 2.0);
        appearance.seek((compared, first), around, PUSHED, other).map(|one| Sighting { aside: true, ..one })
    }
}

/// A second body, and the meeting with it.
pub(super) struct Rival {
    /// Where it was seen: since a meeting began and in some frames before.
    pub seen: Vec<Seen>,
    /// Number of frames since it was seen.
    pub hidden: usize,
    meeting: Option<Meeting>,
}

/// Meeting after which it is not certain which body is which. Indices of the sightings of both.
struct Meeting {
    /// The first ones of the meeting.
    from: [usize; 2],
    /// The first ones since the bodies are apart.
    apart: [usize; 2],
    /// Speed at which they came together, px a frame.
    closing: f64,
}

impl Rival {
    pub(super) fn new() -> Rival {
        Rival { seen: Vec::new(), hidden: 0, meeting: None }
    }

    /// A rival in the frame of a click; `None` outside the picture. `key`: index of the template.
    pub(super) fn at(frame: Frame<'_>, key: usize, one: &Sighting, appearance: &Appearance) -> Option<Rival> {
        let mut rival = Rival::new();
        rival.see(frame, key, one, appearance)?;
        Some(rival)
    }

    /// Adds a sighting; `None` outside the picture.
    pub(super) fn see(&mut self, frame: Frame<'_>, key: usize, one: &Sighting, appearance: &Appearance) -> Option<()> {
        let reach = appearance.now.disc.reach() + MARGIN;
        let part = Part::around(frame.plane, one.found.position, reach, appearance.axis.as_ref())?;
        self.hidden = 0;
        self.seen.push(Seen::new(frame, key, part, one));
        if self.meeting.is_none() && self.seen.len() > 2 * MOST {
            self.seen.drain(..self.seen.len() - MOST);
        }
        Some(())
    }

    /// True while it is not certain which of the bodies this one is.
    pub(super) fn has_met(&self) -> bool {
        self.meeting.is_some()
    }

    /// Index of the first sighting of the body since the meeting began.
    pub(super) fn from(&self) -> Option<usize> {
        self.meeting.as_ref().map(|meeting| meeting.from[0])
    }

    /// True once the other body has not been seen for long, or the motion after a meeting has not shown which is which. `radius` in px.
    pub(super) fn is_over(&self, own: &[Seen], radius: f64) -> bool {
        let (slow, apart) = self.meeting.as_ref().map_or((0.0, 0), |meeting| {
            (PASSED * radius / meeting.closing.max(0.1), own.len().saturating_sub(meeting.apart[0]))
        });
        self.hidden > HIDDEN.max((slow as usize).min(AWAITED)) || apart > MOST
    }

    /// Gives each body its own sightings, and marks those of the body in the meeting.
    pub(super) fn assign(&mut self, own: &mut Vec<Seen>, settled: Settled) {
        for one in &settled.between {
            let other = one.other.filter(|_| one.assigned.is_exchanged).and_then(|other| self.seen.get_mut(other));
            if let Some((own, other)) = own.get_mut(one.own).zip(other) {
                std::mem::swap(own, other);
            }
            if let Some(own) = own.get_mut(one.own) {
                own.alone = one.assigned.is_certain || one.may_be_near;
                own.aside |= !one.assigned.is_certain;
            }
        }
        let [apart, other] = settled.apart;
        own.iter_mut().skip(apart).for_each(|one| one.alone = true);
        if settled.is_exchanged {
            let [tail, other] = [own.split_off(apart.min(own.len())), self.seen.split_off(other.min(self.seen.len()))];
            own.extend(other);
            self.seen.extend(tail);
        }
    }

    /// Takes the next frame, in which both bodies may have been exchanged or not. `own`: where the body was seen up to this frame, without the
    /// sightings before `begin`. `was_covered`: one of them covered the other at the click. Returns the assignment, once the motion shows it.
    pub(super) fn take(
        &mut self,
        (own, begin): (&[Seen], usize),
        (may_be_exchanged, was_covered): (bool, bool),
        radius: f64,
    ) -> Option<Settled> {
        let now = [own.len().saturating_sub(1), self.seen.len().saturating_sub(usize::from(self.hidden == 0))];
        let come_out = self.come_out(own.get(begin..).unwrap_or_default(), radius);
        let come_out = if was_covered { come_out.or(Some(0)) } else { come_out.filter(|_| self.meeting.is_none()) };
        if let Some(from) = come_out {
            let closing = self.closing(own);
            self.meeting = Some(Meeting { from: [begin + from, 0], apart: now.map(|now| now + 1), closing });
            return None;
        }
        if may_be_exchanged {
            let closing = self.closing(own);
            let meeting = self.meeting.get_or_insert_with(|| {
                // The other body has touched this one before it was seen.
                let touched = own[..now[0]].iter().skip(begin).rev().take_while(|one| !one.free).count();
                Meeting { from: [now[0] - touched, now[1]], apart: now, closing }
            });
            meeting.apart = now.map(|now| now + 1);
            return None;
        }
        let meeting = self.meeting.as_ref().filter(|_| self.hidden == 0)?;
        let count = own.len().saturating_sub(meeting.apart[0]);
        if !SIDES.contains(&count) {
            return None;
        }
        self.settle((own, begin), count, radius)
    }

    /// Ends the meeting if the motion shows the assignment by so many positions on each side.
    pub(super) fn settle(&mut self, (own, begin): (&[Seen], usize), count: usize, radius: f64) -> Option<Settled> {
        let Meeting { from, apart, .. } = self.meeting.as_ref()?;
        let (from, apart) = (*from, *apart);
        let first = |k: usize, begin: usize| from[k].saturating_sub(count).max(begin);
        // Both in the same frame: indices of the sightings.
        let pairs: Vec<(usize, Option<usize>)> = (first(0, begin)..own.len())
            .map(|at| {
                let other = self.seen.iter().rposition(|other| other.frame == own[at].frame);
                (at, other)
            })
            .collect();
        let both: Vec<(usize, usize)> = pairs.iter().filter_map(|(at, other)| Some((*at, (*other)?))).collect();
        let middle = |k: usize| {
            let (one, two) = both.get(k).map(|(at, other)| (own[*at].place().1, self.seen[*other].place().1))?;
            Some([0, 1].map(|k| (one[k] + two[k]) / 2.0))
        };
        let vector = |k: usize| {
            let (at, other) = both[k];
            let ((time, one), (_, two)) = (own[at].place(), self.seen[other].place());
            let (before, after) = (k.saturating_sub(1), (k + 1).min(both.len() - 1));
            let frames = own[both[after].0].frame.abs_diff(own[both[before].0].frame).max(1) as f64;
            let motion = middle(before)
                .zip(middle(after))
                .map_or([0.0; 2], |(from, to)| [0, 1].map(|k| (to[k] - from[k]) / frames));
            Vector { time, between: [two[0] - one[0], two[1] - one[1]], motion }
        };
        let vectors: Vec<Vector> = (0..both.len()).map(vector).collect();
        let index = |end: usize| both.partition_point(|(at, _)| *at < end);
        let meeting = index(from[0])..index(apart[0]);
        let met = pairs.iter().filter(|(at, _)| (from[0]..apart[0]).contains(at));
        if let Some((assigned, is_exchanged)) = exchanges(&vectors, meeting, radius) {
            let mut assigned = assigned.into_iter();
            // A body that covers the other one is near where its motion leads.
            let between = met.map(|(own, other)| Between {
                own: *own,
                other: *other,
                assigned: other.and_then(|_| assigned.next()).unwrap_or_default(),
                may_be_near: true,
            });
            self.meeting = None;
            return Some(Settled { is_exchanged, between: between.collect(), apart });
        }
        let places = |seen: &[Seen], range: std::ops::Range<usize>| -> Vec<Place> {
            seen.get(range).unwrap_or_default().iter().map(Seen::place).collect()
        };
        let sides = Sides {
            before: [places(own, first(0, begin)..from[0]), places(&self.seen, first(1, 0)..from[1])],
            after: [
                places(own, apart[0]..own.len().min(apart[0] + count)),
                places(&self.seen, apart[1]..self.seen.len().min(apart[1] + count)),
            ],
        };
        let is_pattern = self.seen.len() < SIGHTINGS && self.hidden > 0;
        let (is_exchanged, curve) = match sides.told(radius) {
            Some((is_exchanged, curve)) => (is_exchanged, Some(curve)),
            None if is_pattern => (false, None),
            None => return None,
        };
        let limit = NEAR.0.max(NEAR.1 * radius);
        let off = |one: &Seen| {
            let (time, position) = one.place();
            curve.as_ref().map_or(if one.free { 0.0 } else { f64::INFINITY }, |curve| curve.off(time, position))
        };
        let between = met.map(|(at, other)| {
            let (one, two) = (off(&own[*at]), other.map_or(f64::INFINITY, |other| off(&self.seen[other])));
            let is_exchanged = curve.is_some() && two < one;
            let assigned = Assigned { is_exchanged, is_certain: one.min(two) < limit };
            Between { own: *at, other: *other, assigned, may_be_near: false }
        });
        let between = between.collect();
        self.meeting = None;
        Some(Settled { is_exchanged, between, apart })
    }

    /// Index of the first sighting of the other one in which this body, which has just been seen twice, may have covered a part of it: that at its
    /// click, unless it has passed later. `own`: all sightings of the other one.
    fn come_out(&self, own: &[Seen], radius: f64) -> Option<usize> {
        let (start, [first, second]) = (own.first()?, self.seen.as_slice()) else { return None };
        let ((late, from), (later, to)) = (first.place(), second.place());
        let (back, step) = ((start.time - late) / (later - late), [0, 1].map(|k| to[k] - from[k]));
        if own.len() > MOST || back == 0.0 {
            return None;
        }
        if own.len() <= EARLY {
            let place = [0, 1].map(|k| from[k] + back * step[k]);
            return (far(place, start.first.position) < COVERING * radius).then_some(0);
        }
        // The motion of many frames is not straight; the bodies separate slowly.
        let at = |one: &Seen| own.iter().rfind(|other| other.frame == one.frame).map(|other| other.first.position);
        let (before, now) = at(first).zip(at(second))?;
        let (from, to) = ([from[0] - before[0], from[1] - before[1]], [to[0] - now[0], to[1] - now[1]]);
        let step = [to[0] - from[0], to[1] - from[1]];
        let square = (step[0] * step[0] + step[1] * step[1]).max(f64::MIN_POSITIVE);
        // Number of frames since the least distance, not before the start.
        let since = ((from[0] * step[0] + from[1] * step[1]) / square).min(-back);
        let apart = |since: f64| far([from[0] - since * step[0], from[1] - since * step[1]], [0.0; 2]);
        if since <= 0.0 || apart(since) >= COVERING * radius {
            return None;
        }
        let touched = own.iter().rev().take_while(|one| !one.free).count();
        let has_passed = own.len() - touched >= ALONE && touched > 0 && apart(-back) > AWAY * radius;
        Some(if has_passed { own.len() - touched } else { 0 })
    }

    /// Change of the distance of both bodies, px a frame.
    fn closing(&self, own: &[Seen]) -> f64 {
        let distance = |back: usize| {
            let at = |seen: &[Seen]| Some(seen.get(seen.len().checked_sub(back)?)?.first.position);
            Some(far(at(own)?, at(&self.seen)?))
        };
        distance(1).zip(distance(2)).map_or(0.0, |(now, before)| (before - now).abs())
    }
}

/// Assignment in a meeting and afterwards.
pub(super) struct Settled {
    /// True if the bodies are exchanged after the meeting.
    is_exchanged: bool,
    between: Vec<Between>,
    /// Indices of the first sightings of both after the meeting.
    apart: [usize; 2],
}

/// Assignment in a frame of a meeting: indices of the sightings of both.
struct Between {
    own: usize,
    other: Option<usize>,
    assigned: Assigned,
    /// True if the positions before and after may show that an uncertain position is right.
    may_be_near: bool,
}
