//! How large a body is.

use crate::plane::Plane;
use crate::tracking::body::background::distance;

/// The smallest radius of a body in pixels.
pub(crate) const SMALLEST: f64 = 3.0;
/// Directions in which an outline is sought.
const DIRECTIONS: u32 = 32;
/// A click is off the middle of a body by at most this part of its radius.
pub(crate) const BESIDE: f64 = 0.7;
/// Pixels between the two sides of an outline.
const ACROSS: f64 = 1.5;
/// How much it counts against an outline that the shades inside it are uneven.
const UNEVEN: f64 = 0.7;
/// The template reaches beyond the outline by this part of its radius and so many pixels, for the edge itself.
const MARGIN: (f64, f64) = (0.2, 2.0);

/// A disc that contains a body and its outline.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Disc {
    /// From the click to its middle.
    pub shift: [f64; 2],
    /// Of the disc that is compared.
    pub radius: f64,
    /// Of the outline.
    pub outline: f64,
}

impl Disc {
    /// With an outline of this radius, and a margin.
    pub(crate) fn of(shift: [f64; 2], outline: f64) -> Disc {
        Disc { shift, radius: outline * (1.0 + MARGIN.0) + MARGIN.1, outline }
    }

    /// The greatest distance of a pixel from the click, to the right or downwards.
    pub(crate) fn reach(&self) -> f64 {
        self.radius + self.shift[0].abs().max(self.shift[1].abs())
    }

    /// The middle, if the click is at this point.
    pub(crate) fn middle(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [x + self.shift[0], y + self.shift[1]]
    }
}

/// The middle value of each part of some shades.
pub(crate) fn median(shades: &[[f32; 3]]) -> [f32; 3] {
    [0, 1, 2].map(|k| {
        let mut values: Vec<f32> = shades.iter().map(|shade| shade[k]).collect();
        let middle = values.len() / 2;
        if values.is_empty() { 0.0 } else { *values.select_nth_unstable_by(middle, f32::total_cmp).1 }
    })
}

/// The circle around a click across which the shades differ most, in most directions.
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
            roots += f64::from(distance(*inside, at(radius + ACROSS))).sqrt().min(60.0).sqrt();
        }
        let usual = median(&inside);
        let uneven = inside.iter().map(|shade| f64::from(distance(*shade, usual)).sqrt().min(60.0)).sum::<f64>();
        let mean = roots / f64::from(DIRECTIONS);
        mean * mean - UNEVEN * uneven / f64::from(DIRECTIONS)
    };
    let mut best = (0.0, [x, y], SMALLEST);
    let seek = |best: &mut (f64, [f64; 2], f64), middle: [f64; 2], radius: f64| {
        let off = libm::hypot(middle[0] - x, middle[1] - y) / radius;
        if radius < SMALLEST || radius > greatest || off > BESIDE {
            return;
        }
        // A click near the middle is more likely, and a large outline is less so by accident.
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
