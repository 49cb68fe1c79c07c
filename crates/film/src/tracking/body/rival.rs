//! A second body of the same look, for which the one that is followed may be taken once they have met.

use crate::tracking::body::background::Compared;
use crate::tracking::body::course::course;
use crate::tracking::body::look::Look;

/// Distances in radii at which a rival is sought.
const SOUGHT: [f64; 2] = [1.2, 4.0];
/// Bodies closer than so many radii have met.
const MET: f64 = 2.6;
/// A rival is where the agreement reaches this part of what it can reach.
const AGREES: f32 = 0.7;
/// The motion before a meeting tells which body is which if it leads so many times closer to one of them.
const CLOSER: f64 = 2.0;
/// A meeting is over if no rival has been seen in so many frames.
const ALONE: usize = 10;
/// Positions that are needed to tell where a motion leads.
const LEADS: usize = 3;

/// A meeting with a body of the same look.
struct Meeting {
    /// Times and positions before it.
    before: Vec<(f64, [f64; 2])>,
    /// Frames since the other body was seen.
    alone: usize,
}

/// Meetings with bodies of the same look.
#[derive(Default)]
pub(super) struct Rivals {
    /// The meeting that lasts.
    meeting: Option<Meeting>,
    /// True from a meeting on after which both bodies are where the motion may lead.
    mistaken: bool,
}

impl Rivals {
    /// True if it is certain which body is followed.
    pub(super) fn are_apart(&self) -> bool {
        self.meeting.is_none() && !self.mistaken
    }

    /// Takes the position in the next frame. `trail` has the positions before.
    pub(super) fn take(
        &mut self,
        (trail, time): (&[(f64, [f64; 2])], f64),
        (position, radius): ([f64; 2], f64),
        rival: Option<[f64; 2]>,
    ) {
        let away = rival.map(|rival| far(rival, position));
        match (&mut self.meeting, rival.zip(away)) {
            (None, Some((_, away))) if away < MET * radius => {
                self.meeting = Some(Meeting { before: trail.to_vec(), alone: 0 });
            }
            (Some(Meeting { before, .. }), Some((rival, away))) if away >= MET * radius => {
                let led = course(before, time, radius).filter(|_| before.len() >= LEADS);
                self.mistaken |= led.is_none_or(|led| CLOSER * far(position, led.place) > far(rival, led.place));
                self.meeting = None;
            }
            (Some(meeting), None) if meeting.alone < ALONE => meeting.alone += 1,
            (Some(meeting), Some(_)) => meeting.alone = 0,
            _ => self.meeting = None,
        }
    }
}

fn far(one: [f64; 2], other: [f64; 2]) -> f64 {
    libm::hypot(one[0] - other[0], one[1] - other[1])
}

impl Look {
    /// The middle of the best agreement around a body but beside it.
    pub(super) fn rival(&self, frame: &Compared<'_>, middle: [f64; 2], radius: f64) -> Option<[f64; 2]> {
        let step = (radius / 3.0).max(1.0);
        let steps = (SOUGHT[1] * radius / step) as i64;
        let places = (-steps..=steps).flat_map(|row| (-steps..=steps).map(move |column| [column, row]));
        let places = places.map(|place| [0, 1].map(|k| middle[k] + step * place[k] as f64)).filter(|place| {
            let away = far(*place, middle) / radius;
            (SOUGHT[0]..SOUGHT[1]).contains(&away) && frame.holds(*place)
        });
        let agreements = places.filter_map(|place| {
            let agreement = self.at_once(frame, place)?;
            (agreement.score >= AGREES * agreement.best).then_some((place, agreement.score))
        });
        agreements.max_by(|one, other| one.1.total_cmp(&other.1)).map(|found| found.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// True if it is certain which body is followed, after two bodies have met that turn back without passing one another. `exchanged`: the
    /// positions go on with the other body.
    fn are_apart(radius: f64, bend: f64, exchanged: bool) -> bool {
        let mut rivals = Rivals::default();
        let mut trail = Vec::new();
        for frame in 0..40 {
            let late = f64::from(frame) - 20.0;
            let far = radius * (0.8 + bend * late * late);
            let [own, other] = if exchanged && late > 0.0 { [far, -far] } else { [-far, far] };
            let rival = (SOUGHT[0]..SOUGHT[1]).contains(&(2.0 * far / radius)).then_some([other, 0.0]);
            rivals.take((&trail, f64::from(frame)), ([own, 0.0], radius), rival);
            trail.push((f64::from(frame), [own, 0.0]));
        }
        rivals.are_apart()
    }

    #[test]
    fn a_body_is_certain_after_a_meeting_if_its_motion_led_there() {
        for radius in [4.0, 11.0, 30.0] {
            for bend in [0.01, 0.03, 0.1] {
                assert!(are_apart(radius, bend, false), "radius {radius}, bend {bend}");
                assert!(!are_apart(radius, bend, true), "radius {radius}, bend {bend}");
            }
        }
    }
}
