//! How large a body is.

use crate::tracking::body::part::Part;

/// The smallest radius of a body in pixels.
const SMALLEST: usize = 3;
/// Directions in which an outline is sought.
const DIRECTIONS: u32 = 40;
/// How far the middle of a body is from the click at most, as a part of the greatest radius.
const BESIDE: f64 = 0.1;
/// The template reaches beyond the outline by this part of its radius and so many pixels, for the edge itself.
const MARGIN: (f64, f64) = (0.2, 2.0);

/// A disc that contains a body and its outline.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Disc {
    /// From the click to its middle.
    pub shift: [f64; 2],
    pub radius: f64,
}

impl Disc {
    /// The greatest distance of a pixel from the click, to the right or downwards.
    pub(crate) fn reach(&self) -> f64 {
        self.radius + self.shift[0].abs().max(self.shift[1].abs())
    }
}

/// The disc around the ring, near a point, on which the mean grey value changes most.
pub(crate) fn around(part: &Part, [x, y]: [f64; 2], greatest: f64) -> Disc {
    let circle: Vec<(f64, f64)> =
        (0..DIRECTIONS).map(|k| libm::sincos(std::f64::consts::TAU * f64::from(k) / f64::from(DIRECTIONS))).collect();
    let reach = (BESIDE * greatest).ceil().clamp(1.0, 10.0) as i32;
    let mut best = (0.0, Disc { shift: [0.0; 2], radius: greatest });
    for shift in (-reach..=reach).flat_map(|v| (-reach..=reach).map(move |u| [f64::from(u), f64::from(v)])) {
        let value = |radius: f64| {
            let place = |(sine, cosine): &(f64, f64)| {
                part.plane.linear(
                    x + shift[0] + radius * cosine - part.corner[0],
                    y + shift[1] + radius * sine - part.corner[1],
                )
            };
            circle.iter().map(place).sum::<f64>() / f64::from(DIRECTIONS)
        };
        let rings: Vec<f64> = (0..=greatest as u32 + 1).map(|radius| value(f64::from(radius))).collect();
        for (radius, three) in (1_usize..).zip(rings.windows(3)).skip(SMALLEST - 1) {
            let change = (three[2] - three[0]).abs();
            if change > best.0 {
                best = (change, Disc { shift, radius: radius as f64 * (1.0 + MARGIN.0) + MARGIN.1 });
            }
        }
    }
    best.1
}
