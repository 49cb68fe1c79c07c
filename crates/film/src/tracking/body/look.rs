//! Appearance of a body compared with the stationary background.

use crate::tracking::body::background::{Around, Compared};
use crate::tracking::body::shape::Shape;
use crate::tracking::median::median_shade;

/// Fraction of the deviation by which the appearance is updated in each frame.
const PACE: f32 = 0.2;
/// Minimum squared distance to an unknown background.
const UNKNOWN: f32 = 12.0 * 12.0;
/// Minimum squared distance to an unknown background, in multiples of [`ALIKE`] squared and the noise variance.
const UNKNOWN_ALIKE: f32 = 1.5;
/// Distance of shades in standard deviations of the noise below which they are not distinguished.
pub(crate) const ALIKE: f32 = 4.0;
/// Weight of the ring outside the outline that does not show the background.
const OUTLINE: f32 = 0.4;
/// Weight of the squared distance from the prediction, relative to the radius of the search.
const CLOSE: f32 = 0.4;
/// Squared distance from the usual shade of the body from which a pixel belongs to a spot.
const OTHER: f32 = 30.0 * 30.0;
/// Addition to the squared distance from the usual shades, in multiples of [`ALIKE`] squared and the noise variance.
const TURNED: f32 = 0.25;
/// Number of pixels of a coarse and of a fine comparison.
const FEW: [usize; 2] = [80, 320];
/// Number of pixels of the first rejection of a place.
const FEWEST: usize = 9;

/// Bound of the rounding errors of a score.
const ROUNDED: f32 = 1e-3;

/// Pixel of a body.
#[derive(Clone, Copy)]
struct Spot {
    offset: [i64; 2],
    first: [f32; 3],
    now: [f32; 3],
}

/// Pixels of a body and the ring around it, relative to its middle.
pub(crate) struct Look {
    spots: Vec<Spot>,
    ring: Vec<[i64; 2]>,
    /// Median shades of the body and of its spots.
    usual: [[f32; 3]; 2],
}

/// Offsets of the pixels of a body, and of those of the ring around it.
pub(super) fn offsets(shape: &Shape) -> [Vec<[i64; 2]>; 2] {
    let reach = (shape.extent + 0.35 * shape.radius + 2.0).ceil() as i64;
    let (mut inside, mut ring) = (Vec::new(), Vec::new());
    for v in -reach..=reach {
        for u in -reach..=reach {
            let far = shape.beyond([u as f64, v as f64]);
            if far <= 0.0 {
                inside.push([u, v]);
            } else if far > 0.1 * shape.radius + 1.0 && far <= 0.3 * shape.radius + 2.0 {
                ring.push([u, v]);
            }
        }
    }
    [inside, ring]
}

/// Agreement of a position with the appearance of the body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Agreement {
    /// 1 if all pixels show the body and none the background, negative if the background is visible.
    pub score: f32,
    /// Maximum score at this position; below 1 if body and background are similar.
    pub best: f32,
    /// Fraction of the ring around the body that does not show the background.
    pub outside: f32,
    /// Fraction of the pixels that belong to another body. They add neither to the score nor to its maximum.
    pub covered: f32,
}

impl Agreement {
    /// Score relative to its maximum, where covered pixels count as agreeing.
    pub(crate) fn relative(&self) -> f32 {
        let behind = if self.covered < 1.0 { self.covered * self.best / (1.0 - self.covered) } else { 1.0 };
        (self.score + behind) / (self.best + behind).max(f32::MIN_POSITIVE)
    }
}

/// Less than any agreement.
const NONE: Agreement = Agreement { score: -2.0, best: 1.0, outside: 0.0, covered: 0.0 };

impl Look {
    /// Appearance of the body in a disc of a frame, px.
    pub(crate) fn new(frame: &Compared<'_>, [x, y]: [f64; 2], shape: &Shape) -> Look {
        let (column, row) = (x.floor() as i64, y.floor() as i64);
        let [inside, ring] = offsets(shape);
        let spot = |offset: [i64; 2]| {
            let shade = frame.shade(column + offset[0], row + offset[1]);
            Spot { offset, first: shade, now: shade }
        };
        let spots: Vec<Spot> = inside.into_iter().map(spot).collect();
        let shades: Vec<[f32; 3]> = spots.iter().map(|spot| spot.first).collect();
        let most = median_shade(&shades, f32::total_cmp);
        let others: Vec<[f32; 3]> =
            shades.iter().copied().filter(|shade| frame.distance(*shade, most) > OTHER).collect();
        let usual = [most, if others.len() * 20 > shades.len() { median_shade(&others, f32::total_cmp) } else { most }];
        Look { spots, ring, usual }
    }

    /// Agreement at a pixel, from about `most` pixels of the body; `None` if its score is certain to lie below `least`.
    /// `taken`: pixels of another body.
    fn agreement(
        &self,
        frame: &Compared<'_>,
        [column, row]: [i64; 2],
        (most, least): (usize, f32),
        taken: Option<Around>,
    ) -> Option<Agreement> {
        // From the middle of this body, rounded to pixels; with the square of the radius.
        let taken = taken
            .map(|([x, y], radius)| ([x.floor() as i64 - column, y.floor() as i64 - row], (radius * radius) as i64));
        let is_taken =
            |[u, v]: [i64; 2]| taken.is_some_and(|([x, y], square)| (u - x) * (u - x) + (v - y) * (v - y) <= square);
        let alike = ALIKE * frame.noise * ALIKE * frame.noise;
        let unknown = UNKNOWN.max(UNKNOWN_ALIKE * alike);
        let spots = self.spots.iter().step_by((self.spots.len() / most).max(1));
        let all = spots.len() as f32;
        let (mut score, mut best, mut count, mut covered) = (0.0, 0.0, 0.0_f32, 0.0_f32);
        for spot in spots {
            if is_taken(spot.offset) {
                (count, covered) = (count + 1.0, covered + 1.0);
                continue;
            }
            let (x, y) = (column + spot.offset[0], row + spot.offset[1]);
            let shade = frame.shade(x, y);
            let usual = frame.distance(shade, self.usual[0]).min(frame.distance(shade, self.usual[1]));
            let own = frame.distance(shade, spot.now).min(frame.distance(shade, spot.first));
            let body = own.min(usual + TURNED * alike);
            let behind = frame.still(shade, x, y);
            let apart = behind.and_then(|_| frame.still(spot.now, x, y)).unwrap_or(unknown);
            let behind = behind.unwrap_or(unknown);
            score += (behind - body) / (behind + body + alike);
            best += apart / (apart + alike);
            count += 1.0;
            // A pixel adds less than 1.
            if score + all - count < (least - ROUNDED) * all {
                return None;
            }
        }
        let (mut outside, mut around) = (0.0, 0.0_f32);
        for offset in self.ring.iter().step_by((2 * self.ring.len() / most).max(1)) {
            let (x, y) = (column + offset[0], row + offset[1]);
            if is_taken(*offset) {
                // It neither shows the background nor touches.
            } else if let Some(behind) = frame.still(frame.shade(x, y), x, y) {
                outside += behind / (behind + alike);
            }
            around += 1.0;
        }
        let outside = outside / around.max(1.0);
        let count = count.max(1.0);
        let score = score / count - OUTLINE * outside;
        Some(Agreement { score, best: best / count, outside, covered: covered / count })
    }

    /// Likeness of the pixels at a position (px) to the body, whatever the background: 1 if all pixels of the body and none around it are alike.
    /// Pixels of another body do not count.
    pub(super) fn likeness(&self, frame: &Compared<'_>, place: [f64; 2], ([x, y], radius): Around) -> f32 {
        let [column, row] = place.map(|at| at.floor() as i64);
        let alike = ALIKE * frame.noise * ALIKE * frame.noise;
        let free = |[u, v]: &[i64; 2]| libm::hypot((column + u) as f64 + 0.5 - x, (row + v) as f64 + 0.5 - y) > radius;
        let mean = |values: &mut dyn Iterator<Item = f32>| {
            let (sum, count) =
                values.fold((0.0, 0.0_f32), |(sum, count), far| (sum + alike / (far + alike), count + 1.0));
            sum / count.max(1.0)
        };
        let stride = (self.spots.len() / FEW[0]).max(1);
        let spots = self.spots.iter().step_by(stride).filter(|spot| free(&spot.offset));
        let inside = mean(
            &mut spots
                .map(|spot| frame.distance(frame.shade(column + spot.offset[0], row + spot.offset[1]), spot.first)),
        );
        let ring = self.ring.iter().step_by(stride).filter(|offset| free(offset));
        let around = mean(
            &mut ring.map(|offset| frame.distance(frame.shade(column + offset[0], row + offset[1]), self.usual[0])),
        );
        inside - around
    }

    /// Position with the best agreement within about `reach` px of a prediction. Positions near the prediction are
    /// preferred. `taken`: pixels of another body.
    pub(crate) fn search(
        &self,
        frame: &Compared<'_>,
        around: [f64; 2],
        reach: f64,
        taken: Option<Around>,
    ) -> ([f64; 2], Agreement) {
        let step = ((self.radius() / 4.0) as i64).clamp(1, 5);
        let (place, _) = self.scan(frame, (around, reach), around, (reach.ceil() as i64, step, FEW[0]), taken);
        self.scan(frame, (around, reach), place, (step, 1, FEW[1]), taken)
    }

    /// Place with the best agreement within `extent` px of another one.
    pub(super) fn refined(&self, frame: &Compared<'_>, place: [f64; 2], extent: f64) -> [f64; 2] {
        self.scan(frame, (place, f64::INFINITY), place, (extent as i64, 1, FEW[0]), None).0
    }

    fn radius(&self) -> f64 {
        (self.spots.len() as f64 / std::f64::consts::PI).sqrt()
    }

    fn scan(
        &self,
        frame: &Compared<'_>,
        (expected, reach): ([f64; 2], f64),
        around: [f64; 2],
        (extent, step, most): (i64, i64, usize),
        taken: Option<Around>,
    ) -> ([f64; 2], Agreement) {
        let middle = around.map(|at| at.floor().clamp(-1e6, 1e6) as i64);
        let nearness = |[column, row]: [i64; 2]| {
            let place = [column as f64 + 0.5, row as f64 + 0.5];
            let far = libm::hypot(place[0] - expected[0], place[1] - expected[1]) / reach.max(1.0);
            let is_within = far <= 1.3 && frame.holds(place);
            is_within.then_some(CLOSE * (far * far) as f32)
        };
        let mut found = (around, NONE);
        let mut value = f32::NEG_INFINITY;
        // The first place is the likeliest: places that are certain to agree less are left early.
        let first = nearness(middle)
            .and_then(|penalty| Some(self.agreement(frame, middle, (most, f32::NEG_INFINITY), taken)?.score - penalty));
        let mut least = first.unwrap_or(f32::NEG_INFINITY);
        let steps = extent.min(10_000) / step;
        for row in (-steps..=steps).map(|k| middle[1] + k * step) {
            for column in (-steps..=steps).map(|k| middle[0] + k * step) {
                let Some(penalty) = nearness([column, row]) else { continue };
                let agreement = self.agreement(frame, [column, row], (most, least + penalty), taken);
                let Some(agreement) = agreement else { continue };
                let own = agreement.score - penalty;
                if own > value {
                    (value, found) = (own, ([column as f64 + 0.5, row as f64 + 0.5], agreement));
                    least = least.max(value);
                }
            }
        }
        found
    }

    /// Median shade of the body, and mean shade of the ring around it.
    pub(crate) fn shades(&self, frame: &Compared<'_>, [x, y]: [f64; 2]) -> [[f32; 3]; 2] {
        let (column, row) = (x.floor() as i64, y.floor() as i64);
        let count = self.ring.len().max(1) as f32;
        let mut sum = [0.0; 3];
        for offset in &self.ring {
            let shade = frame.shade(column + offset[0], row + offset[1]);
            sum.iter_mut().zip(shade).for_each(|(sum, part)| *sum += part / count);
        }
        [self.usual[0], sum]
    }

    /// Agreement at a position, px. `taken`: pixels of another body.
    pub(crate) fn at(&self, frame: &Compared<'_>, place: [f64; 2], taken: Option<Around>) -> Agreement {
        let place = place.map(|at| at.floor() as i64);
        self.agreement(frame, place, (FEW[1], f32::NEG_INFINITY), taken).unwrap_or(NONE)
    }

    /// Agreement of a place by a coarse comparison; `None` where the middle shows the background or a few pixels already contradict.
    pub(crate) fn at_once(&self, frame: &Compared<'_>, place: [f64; 2]) -> Option<Agreement> {
        let place = place.map(|at| at.floor() as i64);
        let [column, row] = place;
        let alike = ALIKE * frame.noise * ALIKE * frame.noise;
        if frame.still(frame.shade(column, row), column, row).is_some_and(|behind| behind < alike) {
            return None;
        }
        self.agreement(frame, place, (FEWEST, 0.0), None).filter(|few| few.score > 0.0)?;
        self.agreement(frame, place, (FEW[0], f32::NEG_INFINITY), None)
    }

    /// Updates the appearance from a frame.
    pub(crate) fn follow(&mut self, frame: &Compared<'_>, place: [f64; 2]) {
        let [column, row] = place.map(|at| at.floor() as i64);
        for spot in &mut self.spots {
            let shade = frame.shade(column + spot.offset[0], row + spot.offset[1]);
            for (now, new) in spot.now.iter_mut().zip(shade) {
                *now += PACE * (new - *now);
            }
        }
    }
}
