//! A meeting of two bodies of the same look, both of which are followed.
//!
//! Nothing but their motion distinguishes two bodies of the same look. Once they are apart again, smooth curves through the positions of both
//! before and after the meeting show which of them is which: those of the same body are smooth, those from one body to the other are not.

use crate::tracking::crossing::{Curve, Place};

/// Distance in radii below which both positions may be exchanged.
const CLOSE: f64 = 0.4;
/// An exchange is possible unless it makes the deviations from both predictions so many times larger.
const UNLIKE: f64 = 3.0;
/// Error of a predicted position, px and relative to the radius.
const PREDICTED: (f64, f64) = (1.0, 0.05);
/// Minimum ratio of the mean squares about the curves of both assignments, and minimum difference of the sums of squares, in mean squares.
const SMOOTHER: (f64, f64) = (3.0, 100.0);
/// Scatter of positions by noise alone, px.
const NOISE: f64 = 0.1;
/// Maximum scatter about a smooth curve, px and relative to the radius.
const SMOOTH: (f64, f64) = (1.0, 0.05);
/// Factor by which the scatter must be smaller if the other body was not seen afterwards.
const ALONE: f64 = 4.0;
/// Maximum duration without positions, in durations of the positions on each side.
const GAP: f64 = 2.5;

/// Positions of two bodies in a frame, and those that their motions predict, px.
pub(super) struct Pair {
    pub own: [f64; 2],
    pub own_predicted: [f64; 2],
    pub other: [f64; 2],
    /// `None` if the other body is seen for the first time.
    pub other_predicted: Option<[f64; 2]>,
}

impl Pair {
    /// Distance of the bodies, px.
    pub(super) fn distance(&self) -> f64 {
        far(self.own, self.other)
    }

    /// True if the positions may be those of the other body each. `radius` in px.
    pub(super) fn may_be_exchanged(&self, radius: f64) -> bool {
        let off = |own: [f64; 2], other: [f64; 2]| {
            far(own, self.own_predicted) + self.other_predicted.map_or(0.0, |predicted| far(other, predicted))
        };
        let error = PREDICTED.0 + PREDICTED.1 * radius;
        self.distance() < CLOSE * radius || off(self.other, self.own) < UNLIKE * (off(self.own, self.other) + error)
    }
}

/// Positions of two bodies before and after a meeting.
pub(super) struct Sides {
    pub before: [Vec<Place>; 2],
    pub after: [Vec<Place>; 2],
}

impl Sides {
    /// Curves of both bodies, with the positions after the meeting exchanged or not.
    fn curves(&self, is_exchanged: bool) -> [Option<Curve>; 2] {
        let [own, other] = &self.after;
        let after = if is_exchanged { [other, own] } else { [own, other] };
        [0, 1].map(|k| Curve::through(&self.before[k], after[k]))
    }

    /// True if the time without positions is not long compared with those of the positions around it.
    fn is_dense(&self) -> bool {
        let [Some(first), Some(last)] = [self.before[0].first(), self.after[0].last()] else { return false };
        let [Some(start), Some(end)] = [self.before[0].last(), self.after[0].first()] else { return false };
        let side = (start.0 - first.0).abs().min((last.0 - end.0).abs());
        (end.0 - start.0).abs() <= GAP * side
    }

    /// Tells which of the bodies is which. Returns true if they are exchanged, and the curve of the first body; `None` if neither assignment or both are smooth. `radius` in px.
    pub(super) fn told(&self, radius: f64) -> Option<(bool, Curve)> {
        if !self.is_dense() {
            return None;
        }
        let assigned = |is_exchanged: bool| {
            let curves = self.curves(is_exchanged);
            let freedom: f64 = curves.iter().flatten().map(|curve| curve.freedom).sum();
            let squares: f64 = curves.iter().flatten().map(|curve| curve.scatter * curve.scatter * curve.freedom).sum();
            let [own, _] = curves;
            own.map(|own| (squares / freedom, freedom, own))
        };
        let smooth = SMOOTH.0.max(SMOOTH.1 * radius) / if self.after[1].is_empty() { ALONE } else { 1.0 };
        let (same, exchanged) = (assigned(false), assigned(true));
        let square = |one: &Option<(f64, f64, Curve)>| one.as_ref().map_or(f64::INFINITY, |one| one.0);
        let (one, other) = (square(&same), square(&exchanged));
        let freedom = same.as_ref().or(exchanged.as_ref()).map_or(1.0, |one| one.1);
        let is_clear = |own: f64, other: f64| {
            let noise = own.max(NOISE * NOISE);
            own < smooth * smooth && other > noise * SMOOTHER.0.max(1.0 + SMOOTHER.1 / freedom)
        };
        if is_clear(one, other) {
            same.map(|(_, _, curve)| (false, curve))
        } else if is_clear(other, one) {
            exchanged.map(|(_, _, curve)| (true, curve))
        } else {
            None
        }
    }
}

pub(super) fn far(one: [f64; 2], other: [f64; 2]) -> f64 {
    libm::hypot(one[0] - other[0], one[1] - other[1])
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two bodies that pass one another at so many radii a frame. `is_exchanged`: their positions after the meeting are those of the other one
    /// each.
    fn shown(radius: f64, speed: f64, is_exchanged: bool) -> Option<bool> {
        let side = |frames: std::ops::Range<i32>, sign: f64| -> Vec<Place> {
            let place = |frame: f64| (frame, [sign * speed * radius * frame, 0.3 * frame - sign]);
            frames.map(|frame| place(f64::from(frame))).collect()
        };
        let before = [side(-7..-1, 1.0), side(-7..-1, -1.0)];
        let sign = if is_exchanged { -1.0 } else { 1.0 };
        let after = [side(2..8, sign), side(2..8, -sign)];
        Sides { before, after }.told(radius).map(|told| told.0)
    }

    #[test]
    fn the_motion_shows_which_body_is_which_after_a_meeting() {
        for radius in [6.0, 11.0, 30.0] {
            for speed in [0.5, 1.0, 2.0] {
                assert_eq!(shown(radius, speed, false), Some(false), "radius {radius}, speed {speed}");
                assert_eq!(shown(radius, speed, true), Some(true), "radius {radius}, speed {speed}");
            }
        }
        // Both assignments of bodies that hardly move are smooth.
        assert_eq!(shown(4.0, 1e-4, false), None);
    }

    #[test]
    fn bodies_that_pass_close_to_one_another_in_one_frame_may_be_exchanged() {
        let pair = |own: f64, other: f64| Pair {
            own: [own, 0.0],
            own_predicted: [0.0, 0.0],
            other: [other, 0.0],
            other_predicted: Some([40.0, 0.0]),
        };
        assert!(!pair(1.0, 39.0).may_be_exchanged(10.0));
        assert!(pair(15.0, 25.0).may_be_exchanged(10.0));
        assert!(pair(16.0, 32.0).may_be_exchanged(10.0));
    }
}
