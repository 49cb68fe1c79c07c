//! Conversion of points and slow-motion factors of films.

use saved::Number;
use saved::format::Place;

use film::timing::LARGEST_FACTOR;

pub(super) fn place([x, y]: [f64; 2]) -> Place {
    [Number(x), Number(y)]
}

pub(super) fn point([Number(x), Number(y)]: Place) -> [f64; 2] {
    [x, y]
}

/// A slow-motion factor within the allowed range; otherwise `None`.
pub(super) fn factor(Number(factor): Number) -> Option<f64> {
    (1.0 / LARGEST_FACTOR..=LARGEST_FACTOR).contains(&factor).then_some(factor)
}
