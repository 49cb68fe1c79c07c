//! Outline of a body that was found by its motion: the position at which the pixels in it differ from the background and those around it do not.

use crate::tracking::body::background::Compared;
use crate::tracking::body::look::{ALIKE, offsets};
use crate::tracking::body::shape::Shape;

/// Approximate number of pixels inside that are compared.
const FEW: usize = 200;
/// Maximum number of steps to the best position.
const STEPS: usize = 12;

/// Ratio of sizes that are compared, and increase of the agreement from which the size has changed.
const RATIO: f64 = 1.06;
const GROWS: f32 = 0.01;
/// Minimum agreement of an outline that shows the size.
const CLEAR: f32 = 0.55;
/// Maximum number of these ratios from the size at the click, and to the size that agrees best there.
const MOST: i32 = 18;
const AT_CLICK: i32 = 6;
/// Change of the size from which there is a new template.
const RESIZED: f64 = 0.2;
/// Number of successive frames in which the size has changed so much.
const LASTING: usize = 3;

/// Outline of a body, with its present size.
pub(super) struct Outline {
    pub shape: Shape,
    /// Present size at which the outline agrees best, and that at the click, as powers of [`RATIO`]: a blurred edge belongs to the body in part.
    size: i32,
    first: i32,
    /// Number of frames since the size last was that of the template.
    other: usize,
    /// Pixels at the sizes that have been compared.
    scaled: Vec<(i32, Pixels)>,
}

/// Offsets of some pixels of a body and of the ring around it.
struct Pixels {
    inside: Vec<[i64; 2]>,
    ring: Vec<[i64; 2]>,
}

impl Outline {
    /// Outline of the body at a place (px) of a frame.
    pub(super) fn new(shape: Shape, frame: &Compared<'_>, middle: [f64; 2]) -> Outline {
        let mut outline = Outline { shape, size: 0, first: 0, other: 0, scaled: Vec::new() };
        outline.prepare();
        (0..AT_CLICK).for_each(|_| outline.follow(frame, middle));
        outline.first = outline.size;
        outline
    }

    /// Follows the size of the body at a place (px) of a frame.
    pub(super) fn follow(&mut self, frame: &Compared<'_>, middle: [f64; 2]) {
        let place = middle.map(|at| at.floor().clamp(-1e6, 1e6) as i64);
        let value = |size: i32| self.pixels(size).and_then(|pixels| pixels.at(frame, place)).unwrap_or(-1.0);
        let usual = value(self.size) + GROWS;
        let (best, size) = [-1, 1]
            .map(|by| (value(self.size + by), self.size + by))
            .into_iter()
            .fold((usual, self.size), |best, one| if one.0 > best.0 { one } else { best });
        if best > usual.max(CLEAR) && (size - self.first).abs() <= MOST {
            self.size = size;
            self.prepare();
        }
    }

    /// Shape of the present size once it has differed from the size of the template for some frames.
    pub(super) fn resized(&mut self) -> Option<Shape> {
        let ratio = libm::pow(RATIO, f64::from(self.size - self.first));
        self.other = if (ratio - 1.0).abs() > RESIZED { self.other + 1 } else { 0 };
        (self.other >= LASTING).then(|| self.shape.scaled(ratio))
    }

    /// Makes the pixels at the present size and its neighbours.
    fn prepare(&mut self) {
        for size in self.size - 1..=self.size + 1 {
            if self.pixels(size).is_none() {
                let shape = self.shape.scaled(libm::pow(RATIO, f64::from(size)));
                self.scaled.push((size, Pixels::new(&shape)));
            }
        }
    }

    fn pixels(&self, size: i32) -> Option<&Pixels> {
        self.scaled.iter().find(|(other, _)| *other == size).map(|(_, pixels)| pixels)
    }

    /// Agreement at a pixel of the outline at its present size.
    pub(super) fn at(&self, frame: &Compared<'_>, place: [i64; 2]) -> Option<f32> {
        self.pixels(self.size)?.at(frame, place)
    }

    /// Position in px of the best agreement near a point, at most `reach` px from it along each coordinate, and that agreement.
    pub(super) fn near(&self, frame: &Compared<'_>, start: [f64; 2], reach: f64) -> Option<([f64; 2], f32)> {
        let first = start.map(|at| at.floor().clamp(-1e6, 1e6) as i64);
        let mut place = first;
        let mut value = self.at(frame, place)?;
        let most = reach.ceil() as i64;
        let mut sides = [[value; 2]; 2];
        for _ in 0..STEPS {
            let mut best = (value, place);
            for k in 0..2 {
                for (side, by) in [-1, 1].into_iter().enumerate() {
                    let mut other = place;
                    other[k] += by;
                    let own = self.at(frame, other).unwrap_or(-1.0);
                    sides[k][side] = own;
                    if own > best.0 && (other[k] - first[k]).abs() <= most {
                        best = (own, other);
                    }
                }
            }
            if best.1 == place {
                break;
            }
            (value, place) = best;
        }
        let part = |k: usize| {
            let [before, after] = sides[k];
            let bend = 2.0 * value - before - after;
            let step = if bend > 0.0 { f64::from((after - before) / (2.0 * bend)).clamp(-0.5, 0.5) } else { 0.0 };
            place[k] as f64 + 0.5 + step
        };
        Some(([part(0), part(1)], value))
    }
}

impl Pixels {
    fn new(shape: &Shape) -> Pixels {
        let [inside, ring] = offsets(shape);
        let stride = (inside.len() / FEW).max(1);
        let [inside, ring] = [inside, ring].map(|all| all.into_iter().step_by(stride).collect());
        Pixels { inside, ring }
    }

    /// Agreement at a pixel with what differs from the background, whatever its look: 1 if all pixels of the body differ and none around it;
    /// `None` where most of the background is unknown.
    fn at(&self, frame: &Compared<'_>, [column, row]: [i64; 2]) -> Option<f32> {
        let alike = ALIKE * frame.noise * ALIKE * frame.noise;
        let mean = |offsets: &[[i64; 2]]| {
            let (mut sum, mut known, mut all) = (0.0, 0.0_f32, 0.0_f32);
            for [u, v] in offsets {
                let (x, y) = (column + u, row + v);
                all += 1.0;
                if let Some(behind) = frame.still(frame.shade(x, y), x, y) {
                    sum += behind / (behind + alike);
                    known += 1.0;
                }
            }
            (2.0 * known > all).then_some(sum / known)
        };
        Some(mean(&self.inside)? - mean(&self.ring)?)
    }
}
