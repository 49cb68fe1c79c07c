//! Tables whose curve the reader draws.

use crate::{Course, Interpolation};
use serde::{Deserialize, Serialize};

/// What the reader may draw, and the curve that is there before. All SI.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Drawn {
    /// The least value.
    pub low: f64,
    /// The greatest value.
    pub high: f64,
    /// The least argument.
    pub from: f64,
    /// The greatest argument.
    pub until: f64,
    /// How the curve goes from point to point.
    pub course: Course,
    /// The values at [`Self::POINTS`] arguments that are equally far apart.
    pub values: Vec<f64>,
}

impl Drawn {
    /// How many points a drawn curve has.
    pub const POINTS: usize = 51;

    /// The argument of a point.
    pub fn argument(&self, point: usize) -> f64 {
        let last = Self::POINTS - 1;
        if point == last { self.until } else { self.from + (self.until - self.from) * (point as f64 / last as f64) }
    }

    /// Whether these can be the values of its points.
    pub fn takes(&self, values: &[f64]) -> bool {
        values.len() == Self::POINTS && values.iter().all(|value| (self.low..=self.high).contains(value))
    }

    /// Whether it can be drawn at all.
    pub(crate) fn is_sound(&self) -> bool {
        let finite = [self.low, self.high, self.from, self.until].iter().all(|number| number.is_finite());
        finite && self.low < self.high && self.from < self.until && self.takes(&self.values)
    }

    /// The curve with these values, which it takes.
    pub fn curve(&self, values: &[f64]) -> Option<Interpolation> {
        let points: Vec<[f64; 2]> =
            values.iter().enumerate().map(|(point, &value)| [self.argument(point), value]).collect();
        Interpolation::through_points(self.course, &points)
    }
}
