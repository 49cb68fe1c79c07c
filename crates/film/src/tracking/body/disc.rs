//! Size of a body from one picture.

use crate::plane::Plane;
use crate::tracking::body::background::distance;
use crate::tracking::body::shape::{Mask, Shape};
use crate::tracking::median::median_shade;

/// Minimum radius of a body, px.
pub(crate) const SMALLEST: f64 = 3.0;
/// Number of directions in which the outline is examined.
const DIRECTIONS: u32 = 32;
/// Maximum distance of a click from the middle of the body, relative to the radius.
pub(crate) const BESIDE: f64 = 0.7;
/// Distance of the samples inside and outside from the outline, px.
const ACROSS: f64 = 1.5;
/// Weight of the unevenness of the shades inside.
const UNEVEN: f64 = 0.7;
/// Margin between the outline and the edge of the template: fraction of the radius, and additional px.
const MARGIN: (f64, f64) = (0.2, 2.0);

/// Weight of the squared distance of a circle from the click, relative to its radius.
const ASIDE: f64 = 0.15;
/// Outer radius of the ring around a circle: multiple of the radius, and additional px.
const RING: (f64, f64) = (1.25, 2.0);
/// Radius in which pixels show the body in part at least: multiple of the radius, and additional px.
const BLURRED: (f64, f64) = (1.1, 1.0);

/// Disc with a body and a margin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Disc {
    /// Vector from the click to the middle, px.
    pub shift: [f64; 2],
    /// Radius of the compared disc, px.
    pub radius: f64,
    /// Radius of the outline, px.
    pub outline: f64,
}

impl Disc {
    /// Disc with an outline of this radius (px), and a margin.
    pub(crate) fn of(shift: [f64; 2], outline: f64) -> Disc {
        Disc { shift, radius: outline * (1.0 + MARGIN.0) + MARGIN.1, outline }
    }

    /// Circle around a shape, with a margin.
    pub(super) fn around_shape(shift: [f64; 2], shape: &Shape) -> Disc {
        let outline = shape.radius;
        Disc { shift, radius: shape.extent + outline * MARGIN.0 + MARGIN.1, outline }
    }

    /// Maximum distance of a pixel from the click along a coordinate, px.
    pub(crate) fn reach(&self) -> f64 {
        self.radius + self.shift[0].abs().max(self.shift[1].abs())
    }

    /// Radius in which pixels show the body in part at least, px.
    pub(crate) fn blurred(&self) -> f64 {
        BLURRED.0 * self.outline + BLURRED.1
    }

    /// Difference of the middles or of the radii of the outlines, whichever is larger, px.
    pub(crate) fn difference(&self, other: Disc) -> f64 {
        let off = libm::hypot(self.shift[0] - other.shift[0], self.shift[1] - other.shift[1]);
        off.max((self.outline - other.outline).abs())
    }

    /// Middle of the disc for a click at this point, px.
    pub(crate) fn middle(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [x + self.shift[0], y + self.shift[1]]
    }
}

/// Circle with the largest contrast in most directions, around a click (px). `greatest`: maximum radius, px.
pub(crate) fn around(plane: &Plane, [x, y]: [f64; 2], greatest: f64) -> Disc {
    let circle: Vec<(f64, f64)> =
        (0..DIRECTIONS).map(|k| libm::sincos(std::f64::consts::TAU * f64::from(k) / f64::from(DIRECTIONS))).collect();
    let shade = |x: f64, y: f64| plane.shade(x.floor() as i64, y.floor() as i64).map(f32::from);
    let value = |[x, y]: [f64; 2], radius: f64| {
        let mut roots = 0.0;
        let mut inside = [[0.0_f32; 3]; DIRECTIONS as usize];
        for ((sine, cosine), inside) in circle.iter().zip(&mut inside) {
            let at = |radius: f64| shade(x + radius * cosine, y + radius * sine);
            *inside = at(radius - ACROSS);
            roots += f64::from(distance(*inside, at(radius + ACROSS), 0.0)).sqrt().min(60.0).sqrt();
        }
        let usual = median_shade(&inside, f32::total_cmp);
        let uneven = inside.iter().map(|shade| f64::from(distance(*shade, usual, 0.0)).sqrt().min(60.0)).sum::<f64>();
        let mean = roots / f64::from(DIRECTIONS);
        mean * mean - UNEVEN * uneven / f64::from(DIRECTIONS)
    };
    let mut best = (0.0, [x, y], SMALLEST);
    let seek = |best: &mut (f64, [f64; 2], f64), middle: [f64; 2], radius: f64| {
        let off = libm::hypot(middle[0] - x, middle[1] - y) / radius;
        if radius < SMALLEST || radius > greatest || off > BESIDE {
            return;
        }
        // Prefers circles about the click, and large outlines, which are less often accidental.
        let own = value(middle, radius) * (1.0 - 0.15 * off * off) * (1.0 - 1.0 / radius);
        if own > best.0 {
            *best = (own, middle, radius);
        }
    };
    let mut radius = SMALLEST;
    while radius <= greatest {
        let step = (radius / 8.0).max(1.0);
        let steps = (BESIDE * radius / step).ceil() as i32;
        for row in -steps..=steps {
            for column in -steps..=steps {
                seek(&mut best, [x + step * f64::from(column), y + step * f64::from(row)], radius);
            }
        }
        radius += (radius / 12.0).max(1.0);
    }
    let (_, middle, radius) = best;
    let extent = (radius / 8.0).ceil() as i32;
    for change in -extent..=extent {
        for row in -extent..=extent {
            for column in -extent..=extent {
                seek(
                    &mut best,
                    [middle[0] + f64::from(column), middle[1] + f64::from(row)],
                    radius + f64::from(change),
                );
            }
        }
    }
    let (_, middle, radius) = best;
    Disc::of([middle[0] - x, middle[1] - y], radius)
}

/// Middle (offset from the click) and radius of the circle about the click that has most of some pixels inside, and fewest around it.
pub(super) fn fitted(pixels: &Mask, greatest: f64) -> ([f64; 2], f64) {
    let half = pixels.half();
    let side = (2 * half + 1) as usize;
    let mut sums = Vec::with_capacity(side * (side + 1));
    for row in -half..=half {
        let mut sum = 0.0;
        sums.push(sum);
        sums.extend((-half..=half).map(|column| {
            sum += f64::from(u8::from(pixels.holds([column, row])));
            sum
        }));
    }
    let within = |[x, y]: [f64; 2], radius: f64| {
        let [x, y] = [x, y].map(|at| at + half as f64 + 0.5);
        let limit = |at: f64| at.round().clamp(0.0, side as f64) as usize;
        let (mut sum, mut count) = (0.0, 0.0);
        for row in limit(y - radius)..limit(y + radius) {
            let down = row as f64 + 0.5 - y;
            let across = (radius * radius - down * down).max(0.0).sqrt();
            let (from, to) = (limit(x - across), limit(x + across));
            let sum_at = |place: usize| sums.get(row * (side + 1) + place).copied().unwrap_or(0.0);
            (sum, count) = (sum + sum_at(to) - sum_at(from), count + (to - from) as f64);
        }
        (sum, count)
    };
    let mut best = (f64::NEG_INFINITY, [0.0; 2], SMALLEST);
    let seek = |best: &mut (f64, [f64; 2], f64), middle: [f64; 2], radius: f64| {
        let off = libm::hypot(middle[0], middle[1]) / radius;
        if off > BESIDE || !(SMALLEST..=greatest).contains(&radius) {
            return;
        }
        let [inside, gap, ring] = [radius, radius + 1.0, RING.0 * radius + RING.1].map(|radius| within(middle, radius));
        let around = (ring.0 - gap.0) / (ring.1 - gap.1).max(1.0);
        let value = (inside.0 / inside.1.max(1.0) - around) * radius * (1.0 - ASIDE * off * off);
        if value > best.0 {
            *best = (value, middle, radius);
        }
    };
    let mut radius = SMALLEST;
    while radius <= greatest {
        let step = (radius / 5.0).max(1.0);
        let steps = (BESIDE * radius / step).ceil() as i32;
        for row in -steps..=steps {
            (-steps..=steps).for_each(|column| seek(&mut best, [column, row].map(|at| step * f64::from(at)), radius));
        }
        radius += (radius / 8.0).max(1.0);
    }
    for step in [2.0, 1.0, 0.5, 0.5] {
        let (_, [x, y], radius) = best;
        for (u, v, w) in [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)] {
            let [u, v, w] = [u, v, w].map(|at| step * f64::from(at));
            seek(&mut best, [x + u, y + v], radius + w);
        }
    }
    (best.1, best.2)
}
