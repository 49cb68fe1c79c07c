//! A second body of the same look, for which the one that is followed may be taken once they have met.
//!
//! Nothing but their motion distinguishes two bodies of the same look. Once they are apart again, a smooth curve through the positions
//! before and after the meeting shows which of them is which: that of the same body is smooth, that of the other one is not.

use crate::tracking::body::background::Compared;
use crate::tracking::body::crossing::{Curve, Place};
use crate::tracking::body::look::Look;

/// Distances in radii at which a rival is sought: least, greatest, and greatest during a meeting, after which it may be fast.
const SOUGHT: [f64; 3] = [1.2, 4.0, 8.0];
/// Bodies that are closer than so many radii, or will be in the next frame, have met.
const MET: f64 = 2.6;
/// A rival is where the agreement reaches this part of what it can reach.
const AGREES: f32 = 0.7;
/// The scatter about the curve of the other body is at least so many times larger.
const CLOSER: f64 = 3.0;
/// Maximum scatter about a smooth curve, px and relative to the radius.
const SMOOTH: (f64, f64) = (1.0, 0.05);
/// Factor by which the scatter must be smaller if the other body was not seen afterwards.
const ALONE_SMOOTH: f64 = 4.0;
/// A meeting is over if no rival has been seen in so many frames in which nothing touched the body.
const ALONE: usize = 10;
/// Relative way in radii after which a rival that is not seen has passed.
const PASSED: f64 = 16.0;
/// A thing that was seen in fewer frames of a meeting may be a pattern of the background.
const SIGHTINGS: usize = 3;
/// Number of positions before and after a meeting.
const SIDE: usize = 8;
/// Number of positions after a meeting that suffice if another one follows.
const FEW: usize = 5;

/// A meeting with a body of the same look. Positions of both before it, and since they are apart.
#[derive(Default)]
struct Meeting {
    before: Vec<Place>,
    own: Vec<Place>,
    other: Vec<Place>,
    /// Speed at which the bodies came together, px a frame.
    closing: f64,
    /// True once the bodies were so close that they disturb one another's positions, or the other one was not seen.
    together: bool,
    /// Number of frames of the meeting in which the other body was seen.
    sightings: usize,
    /// Frames since the other body was seen, and those of them in which nothing touched the body.
    unseen: usize,
    alone: usize,
}

/// The body that the motion shows after a meeting.
pub(super) enum Told {
    /// It is the body that was followed before, along this curve if the bodies were apart then.
    Same(Option<Curve>),
    /// The body that was followed is at this place, px.
    Other([f64; 2]),
}

/// Meetings with bodies of the same look.
#[derive(Default)]
pub(super) struct Rivals {
    /// The meeting that lasts.
    meeting: Option<Meeting>,
    /// Distance of the rival in the last frame, px.
    away: Option<f64>,
    /// True from a meeting on after which the motion does not show which body is which.
    mistaken: bool,
}

impl Rivals {
    /// True if it is certain which body is followed.
    pub(super) fn are_apart(&self) -> bool {
        self.meeting.is_none() && !self.mistaken
    }

    /// True while a meeting lasts.
    pub(super) fn have_met(&self) -> bool {
        self.meeting.is_some()
    }

    /// Distances in px from the body at which a rival is sought.
    pub(super) fn range(&self, radius: f64) -> std::ops::Range<f64> {
        SOUGHT[0] * radius..SOUGHT[if self.meeting.is_some() { 2 } else { 1 }] * radius
    }

    /// Takes the position in the next frame and that of the rival. `trail` has the positions before; `free`: nothing touches the body.
    pub(super) fn take(
        &mut self,
        trail: &[Place],
        ((time, position), radius): (Place, f64),
        (rival, free): (Option<[f64; 2]>, bool),
    ) -> Option<Told> {
        if self.mistaken {
            return None;
        }
        let away = rival.map(|rival| far(rival, position));
        // A rival that is seen for the first time may be as fast as the body.
        let step = trail.last().filter(|_| self.meeting.is_none()).map_or(0.0, |(_, last)| far(*last, position));
        let before = std::mem::replace(&mut self.away, away);
        let closing = away.map_or(0.0, |away| before.map_or(2.0 * step, |before| before - away).max(0.0));
        let is_near = away.is_some_and(|away| away - closing < MET * radius);
        let is_apart = away.is_some_and(|away| away >= MET * radius);
        let Some(meeting) = &mut self.meeting else {
            if is_near {
                self.meeting = Some(Meeting::new(trail, closing, !is_apart));
            }
            return None;
        };
        if !meeting.together && meeting.own.is_empty() {
            meeting.before = latest(trail);
            meeting.together = !is_apart;
        }
        if is_near && meeting.own.len() < FEW {
            (meeting.own, meeting.other, meeting.unseen, meeting.alone) = Default::default();
            return None;
        }
        if is_near {
            let told = self.tell(radius);
            self.meeting = Some(Meeting::new(trail, closing, !is_apart));
            return told;
        }
        meeting.sightings += usize::from(rival.is_some());
        let is_unseen = rival.is_none();
        meeting.unseen = if is_unseen { meeting.unseen + 1 } else { 0 };
        meeting.alone = if is_unseen { meeting.alone + usize::from(free) } else { 0 };
        let has_passed = meeting.unseen as f64 * meeting.closing > PASSED * radius;
        if rival.is_some() || !meeting.own.is_empty() || has_passed {
            meeting.own.push((time, position));
            meeting.other.extend(rival.map(|rival| (time, rival)));
        } else if meeting.alone >= ALONE {
            self.meeting = None;
            return Some(Told::Same(None));
        }
        if meeting.own.len() < SIDE {
            return None;
        }
        self.tell(radius)
    }

    /// Ends the meeting.
    fn tell(&mut self, radius: f64) -> Option<Told> {
        let meeting = self.meeting.take()?;
        let told = meeting.told(SMOOTH.0.max(SMOOTH.1 * radius));
        if told.is_none() && meeting.sightings < SIGHTINGS {
            return Some(Told::Same(None));
        }
        self.mistaken = told.is_none();
        told
    }
}

impl Meeting {
    fn new(trail: &[Place], closing: f64, together: bool) -> Meeting {
        Meeting { before: latest(trail), closing, together, ..Meeting::default() }
    }

    /// The body that the curves show; `None` if neither or both are smooth.
    fn told(&self, smooth: f64) -> Option<Told> {
        let (own, other) = (Curve::through(&self.before, &self.own), Curve::through(&self.before, &self.other));
        let scatter = |curve: &Option<Curve>| curve.as_ref().map_or(f64::INFINITY, |curve| curve.scatter);
        let (same, exchanged) = (scatter(&own), scatter(&other));
        let smooth = if self.other.is_empty() { smooth / ALONE_SMOOTH } else { smooth };
        if same < smooth && CLOSER * same < exchanged {
            Some(Told::Same(own))
        } else if exchanged < smooth && CLOSER * exchanged < same {
            other.zip(self.own.last()).map(|(other, (now, _))| Told::Other(other.at(*now)))
        } else {
            None
        }
    }
}

/// The last positions.
fn latest(trail: &[Place]) -> Vec<Place> {
    trail[trail.len().saturating_sub(SIDE)..].to_vec()
}

fn far(one: [f64; 2], other: [f64; 2]) -> f64 {
    libm::hypot(one[0] - other[0], one[1] - other[1])
}

impl Look {
    /// The middle of the best agreement within a range of distances around a body, px.
    pub(super) fn rival(
        &self,
        frame: &Compared<'_>,
        (middle, radius): ([f64; 2], f64),
        range: std::ops::Range<f64>,
    ) -> Option<[f64; 2]> {
        let step = (radius / 3.0).max(1.0);
        let steps = (range.end / step) as i64;
        let places = (-steps..=steps).flat_map(|row| (-steps..=steps).map(move |column| [column, row]));
        let places = places
            .map(|place| [0, 1].map(|k| middle[k] + step * place[k] as f64))
            .filter(|place| range.contains(&far(*place, middle)) && frame.holds(*place));
        let agreements = places.filter_map(|place| {
            let agreement = self.at_once(frame, place)?;
            (agreement.score >= AGREES * agreement.best).then_some((place, agreement.score))
        });
        let (place, _) = agreements.max_by(|one, other| one.1.total_cmp(&other.1))?;
        Some(self.refined(frame, place, step))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The body that the motion shows where two bodies meet and turn back without passing one another. `exchanged`: the positions go on with the
    /// other body.
    fn told(radius: f64, bend: f64, exchanged: bool) -> (bool, Option<bool>) {
        let mut rivals = Rivals::default();
        let mut trail = Vec::new();
        let mut told = None;
        for frame in 0..60 {
            let late = f64::from(frame) - 30.0;
            let far = radius * (0.8 + bend * late * late);
            let [own, other] = if exchanged && late > 0.0 { [far, -far] } else { [-far, far] };
            let rival = rivals.range(radius).contains(&(2.0 * far)).then_some([other, 0.0]);
            let place = (f64::from(frame), [own, 0.0]);
            match rivals.take(&trail, (place, radius), (rival, true)) {
                Some(Told::Same(_)) => told = Some(true),
                Some(Told::Other(place)) => told = Some((place[0] > 0.0) == exchanged),
                None => {}
            }
            trail.push(place);
        }
        (rivals.are_apart(), told)
    }

    #[test]
    fn the_motion_shows_the_body_after_a_meeting() {
        for radius in [4.0, 11.0, 30.0] {
            for bend in [0.01, 0.03, 0.1] {
                assert_eq!(told(radius, bend, false), (true, Some(true)), "radius {radius}, bend {bend}");
                assert_eq!(told(radius, bend, true), (true, Some(false)), "radius {radius}, bend {bend}");
            }
        }
    }
}
