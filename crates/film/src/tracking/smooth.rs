//! Where the neighbours of a point lead. Motions are smooth except where a body bounces.

use crate::tracking::crossing::{CLOSE, Curve, Place};
use crate::tracking::median::median;

/// Maximum duration of the neighbours that are used, in median intervals between points.
const SPAN: f64 = 8.5;
/// Number of instants between two points at which the motions before and after are compared.
const INSTANTS: u32 = 40;
/// Maximum number of points on each side among which usable ones are sought.
const NEAR: usize = 8;

/// Maximum number of points on each side of a doubt that may settle it, and maximum distance in median intervals.
const AROUND: (usize, f64) = (6, 12.5);

/// Positions of a track, px, and their times.
pub(crate) struct Motion {
    times: Vec<f64>,
    positions: Vec<[f64; 2]>,
    span: f64,
    interval: f64,
}

impl Motion {
    /// Motion through positions in the order of time.
    pub(crate) fn new(times: Vec<f64>, positions: Vec<[f64; 2]>) -> Motion {
        let interval = median(times.windows(2).map(|pair| pair[1] - pair[0]).collect());
        Motion { times, positions, span: SPAN * interval, interval }
    }

    /// Value at a time of the polynomial through some points.
    fn curve(&self, through: &[usize], time: f64) -> [f64; 2] {
        let mut sum = [0.0; 2];
        for one in through {
            let others = through.iter().filter(|other| *other != one).map(|other| self.times[*other]);
            let weight: f64 = others.map(|other| (time - other) / (self.times[*one] - other)).product();
            (0..2).for_each(|k| sum[k] += weight * self.positions[*one][k]);
        }
        sum
    }

    /// Vector from the first point to where some others lead, px.
    pub(crate) fn back(&self, through: &[usize]) -> [f64; 2] {
        let led = self.curve(through, self.times[0]);
        [0, 1].map(|k| led[k] - self.positions[0][k])
    }

    /// The nearest `count` usable points before an index, the nearest one first.
    fn before(&self, at: usize, count: usize, usable: &impl Fn(usize) -> bool) -> Vec<usize> {
        (at.saturating_sub(NEAR)..at).rev().filter(|one| usable(*one)).take(count).collect()
    }

    /// The nearest `count` usable points from an index on.
    fn after(&self, at: usize, count: usize, usable: &impl Fn(usize) -> bool) -> Vec<usize> {
        (at..self.times.len().min(at + NEAR)).filter(|one| usable(*one)).take(count).collect()
    }

    /// True if as many points were found as were sought, and none is far from an index.
    fn are_near(&self, at: usize, (found, count): (&[usize], usize)) -> bool {
        let time = self.times[at];
        found.len() == count && found.iter().all(|one| (self.times[*one] - time).abs() < self.span / 2.0)
    }

    /// Difference of a position from a polynomial, along both coordinates.
    fn off(&self, at: usize, through: &[usize]) -> [f64; 2] {
        let led = self.curve(through, self.times[at]);
        [0, 1].map(|k| (self.positions[at][k] - led[k]).abs())
    }

    /// Distance of a point from the cubic through two usable points on each side, along both coordinates. `None` near ends and gaps.
    pub(crate) fn between(&self, at: usize, usable: impl Fn(usize) -> bool) -> Option<[f64; 2]> {
        let both = [self.before(at, 2, &usable), self.after(at + 1, 2, &usable)].concat();
        self.are_near(at, (&both, 4)).then(|| self.off(at, &both))
    }

    /// Distance of a point from where its usable neighbours lead, along both coordinates: by the cubic through two on each side, or by the
    /// parabola through three on one side, whichever is closest. `None` near ends and gaps.
    pub(crate) fn distance(&self, at: usize, usable: impl Fn(usize) -> bool) -> Option<[f64; 2]> {
        let both = self.between(at, &usable)?;
        let sides = [self.before(at, 3, &usable), self.after(at + 1, 3, &usable)];
        let sides = sides.into_iter().filter(|side| self.are_near(at, (side, 3))).map(|side| self.off(at, &side));
        sides.chain([both]).min_by(|one, other| libm::hypot(one[0], one[1]).total_cmp(&libm::hypot(other[0], other[1])))
    }

    /// Distance of a point from the smooth curve through usable points on both sides, px, which may be further away than those of
    /// [`Motion::distance`]; the less of both. `None` with too few of them.
    pub(crate) fn through(&self, at: usize, usable: impl Fn(usize) -> bool) -> Option<f64> {
        let near = self.distance(at, &usable).map(|[x, y]| libm::hypot(x, y));
        let [before, after] = self.around(at, AROUND.0, usable);
        let far = Curve::through(&before, &after).map(|curve| curve.off(self.times[at], self.positions[at]));
        near.into_iter().chain(far).min_by(f64::total_cmp)
    }

    /// Distance of a point from a curve that follows the nearest usable points on both sides closely, px. `None` with too few of them.
    pub(crate) fn closely(&self, at: usize, usable: impl Fn(usize) -> bool) -> Option<f64> {
        let [before, after] = self.around(at, CLOSE, usable);
        Curve::close(&before, &after).map(|curve| curve.off(self.times[at], self.positions[at]))
    }

    /// The nearest usable points on each side, at most `most`, in the order of time.
    fn around(&self, at: usize, most: usize, usable: impl Fn(usize) -> bool) -> [Vec<Place>; 2] {
        let is_near = |one: &usize| (self.times[*one] - self.times[at]).abs() < AROUND.1 * self.interval;
        let place = |one: usize| -> Place { (self.times[one], self.positions[one]) };
        let before = (0..at).rev().take_while(is_near).filter(|one| usable(*one)).take(most).map(place);
        let after = (at + 1..self.times.len()).take_while(is_near).filter(|one| usable(*one)).take(most).map(place);
        let (mut before, after): (Vec<Place>, Vec<Place>) = (before.collect(), after.collect());
        before.reverse();
        [before, after]
    }

    /// True if the motion before a point meets the motion after it within an interval of the point, and one of them leads to the point, both
    /// to within half of `limit` (px).
    pub(crate) fn bounces(&self, at: usize, limit: f64) -> bool {
        let (all, limit) = (|_: usize| true, limit / 2.0);
        let is_led = self.distance(at, all).is_some_and(|off| libm::hypot(off[0], off[1]) <= limit);
        let meets = |at: usize| self.step(at, all).is_some_and(|step| step <= limit);
        is_led && (at.checked_sub(1).is_some_and(meets) || meets(at))
    }

    /// Distance between the motion up to an index and the motion from the next one on, at the instant between the two at which it is least.
    /// `None` near ends and gaps.
    fn step(&self, at: usize, usable: impl Fn(usize) -> bool) -> Option<f64> {
        let (before, after) = (self.before(at + 1, 3, &usable), self.after(at + 1, 3, &usable));
        if !self.are_near(at, (&before, 3)) || !self.are_near(at, (&after, 3)) {
            return None;
        }
        let (from, to) = (self.times[at], self.times[at + 1]);
        let apart = (0..=INSTANTS).map(|k| {
            let time = from + (to - from) * f64::from(k) / f64::from(INSTANTS);
            let (one, other) = (self.curve(&before, time), self.curve(&after, time));
            libm::hypot(one[0] - other[0], one[1] - other[1])
        });
        apart.min_by(f64::total_cmp)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A body that moves by `speed` px a frame and bounces back at frame 10.4, and then is elsewhere by `shift` px.
    fn bounced(speed: f64, shift: f64) -> Motion {
        let place = |k: i32| {
            let late = f64::from(k) - 10.4;
            [100.0 - speed * late.abs(), 50.0 + 0.2 * late * late + if late > 0.0 { shift } else { 0.0 }]
        };
        Motion::new((0..21).map(f64::from).collect(), (0..21).map(place).collect())
    }

    #[test]
    fn a_bounce_leaves_no_distance() {
        for speed in [0.0, 5.0, 40.0] {
            let motion = bounced(speed, 0.0);
            for at in 0..21 {
                let off = motion.distance(at, |_| true).map(|off| off[0].max(off[1]));
                assert_eq!(off.is_some(), (2..19).contains(&at), "{at}");
                assert!(off.is_none_or(|off| off < 1e-9), "{speed}, {at}: {off:?}");
                assert!(motion.step(at, |_| true).is_none_or(|step| step < 0.1 * speed + 1e-9), "{speed}, {at}");
            }
        }
    }

    #[test]
    fn certain_frames_on_both_sides_lead_through_a_run_of_others() {
        let place = |k: i32| [100.0 * libm::cos(0.12 * f64::from(k)), 40.0 * libm::sin(0.12 * f64::from(k))];
        let mut motion = Motion::new((0..40).map(f64::from).collect(), (0..40).map(place).collect());
        let is_certain = |one: usize| !(15..24).contains(&one);
        for at in 15..24 {
            let off = motion.through(at, is_certain).expect("a distance");
            assert!(off < 1.0, "{at}: {off}");
            motion.positions[at][0] += 5.0;
            let off = motion.through(at, is_certain).expect("a distance");
            assert!(off > 4.0, "{at}: {off}");
        }
        assert_eq!(motion.through(20, |one| one < 15), None);
        assert_eq!(motion.through(20, |one| !(5..36).contains(&one)), None);
    }

    #[test]
    fn a_fast_swing_is_led_closely_through_frames_without_the_body() {
        let place = |k: i32| [130.0 * libm::cos(0.22 * f64::from(k)), 15.0 * libm::sin(0.44 * f64::from(k))];
        // Every second frame of a swing with 29 frames a period.
        let motion = Motion::new((0..30).map(|k| f64::from(2 * k)).collect(), (0..30).map(|k| place(2 * k)).collect());
        for at in 4..26 {
            let off = motion.closely(at, |_| true).expect("a distance");
            assert!(off < 1.6, "{at}: {off}");
        }
        assert_eq!(motion.closely(3, |_| true), None);
    }

    #[test]
    fn a_step_is_seen_between_its_frames_and_a_wrong_position_in_its_own() {
        let step = bounced(0.0, 9.0).step(10, |_| true).expect("a step");
        assert!((step - 9.0).abs() < 1e-9, "{step}");
        let mut motion = bounced(5.0, 0.0);
        motion.positions[6][1] += 9.0;
        for at in 2..19 {
            let off = motion.distance(at, |one| one != 6).expect("a distance");
            assert!((off[1] - if at == 6 { 9.0 } else { 0.0 }).abs() < 1e-9, "{at}: {off:?}");
        }
    }
}
