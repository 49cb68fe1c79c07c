//! Search for a second body of the same look around the first one.

use std::ops::Range;

use crate::tracking::body::background::{Around, Compared};
use crate::tracking::body::look::Look;
use crate::tracking::body::meeting::far;

/// Distances in radii at which a rival is sought: least, and greatest.
const SOUGHT: [f64; 2] = [1.2, 4.0];
/// Number of frames before a meeting at which a rival is sought that comes as fast as the body.
const AHEAD: f64 = 6.0;
/// A rival is where the agreement reaches this part of what it can reach.
pub(super) const RIVAL: f32 = 0.7;
/// A rival in the frame of a click, whose background is not known yet, is at least so much like the body.
pub(super) const LIKE: f32 = 0.6;

/// Distances in px from a body at which a rival is sought. `way`: motion of the body in a frame, px.
pub(super) fn sought(radius: f64, way: f64) -> Range<f64> {
    SOUGHT[0] * radius..SOUGHT[1] * radius + 2.0 * AHEAD * way
}

/// Places (px) in a square around a middle: so many steps of so many px in each direction.
fn square(middle: [f64; 2], steps: i64, step: f64) -> impl Iterator<Item = [f64; 2]> {
    let offsets = (-steps..=steps).flat_map(move |row| (-steps..=steps).map(move |column| [column, row]));
    offsets.map(move |place| [0, 1].map(|k| middle[k] + step * place[k] as f64))
}

impl Look {
    /// The middle of what is most like the body, whatever the background, within a range of distances around it, px; `None` if its likeness is less
    /// than `least`.
    pub(super) fn likest(
        &self,
        frame: &Compared<'_>,
        own: Around,
        (range, least): (Range<f64>, f32),
    ) -> Option<[f64; 2]> {
        let (middle, radius) = own;
        let step = (radius / 4.0).max(1.0);
        let steps = (range.end / step) as i64;
        let best = |places: &mut dyn Iterator<Item = [f64; 2]>| {
            let places = places.filter(|place| range.contains(&far(*place, middle)) && frame.holds(*place));
            let likeness = places.map(|place| (place, self.likeness(frame, place, own)));
            likeness.max_by(|one, other| one.1.total_cmp(&other.1))
        };
        let (place, value) = best(&mut square(middle, steps, step))?;
        let (place, value) =
            if value > least / 2.0 { best(&mut square(place, step as i64, 1.0))? } else { (place, value) };
        (value > least).then_some(place)
    }

    /// The middle of the best agreement within a range of distances around a body, px; `None` if it is less than `least` of what it can reach.
    pub(super) fn rival(
        &self,
        frame: &Compared<'_>,
        (middle, radius): ([f64; 2], f64),
        (range, least): (Range<f64>, f32),
    ) -> Option<[f64; 2]> {
        let step = (radius / 3.0).max(1.0);
        let steps = (range.end / step) as i64;
        let places =
            square(middle, steps, step).filter(|place| range.contains(&far(*place, middle)) && frame.holds(*place));
        let agreements = places.filter_map(|place| {
            let agreement = self.at_once(frame, place)?;
            (agreement.score >= least * agreement.best).then_some((place, agreement.score))
        });
        let (place, _) = agreements.max_by(|one, other| one.1.total_cmp(&other.1))?;
        Some(self.refined(frame, place, step))
    }
}
