//! Tables whose curve the reader draws.

use crate::{Course, Interpolation};
use serde::{Deserialize, Serialize};

/// Range of a curve that the reader may draw, and its default. All values in SI units.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Drawn {
    /// Minimum value.
    pub low: f64,
    /// Maximum value.
    pub high: f64,
    /// Minimum argument.
    pub from: f64,
    /// Maximum argument.
    pub until: f64,
    /// Interpolation between the points.
    pub course: Course,
    /// Default values at [`Self::POINTS`] equally spaced arguments.
    pub values: Vec<f64>,
}

impl Drawn {
    /// Number of points of a drawn curve.
    pub const POINTS: usize = 51;

    /// Argument of a point, SI units.
    pub fn argument(&self, point: usize) -> f64 {
        let last = Self::POINTS - 1;
        if point == last { self.until } else { self.from + (self.until - self.from) * (point as f64 / last as f64) }
    }

    /// True if these are valid values: one per point, SI, within the range.
    pub fn takes(&self, values: &[f64]) -> bool {
        values.len() == Self::POINTS && values.iter().all(|value| (self.low..=self.high).contains(value))
    }

    /// True if the ranges are finite and not empty and the default is valid.
    pub(crate) fn is_sound(&self) -> bool {
        let finite = [self.low, self.high, self.from, self.until].iter().all(|number| number.is_finite());
        finite && self.low < self.high && self.from < self.until && self.takes(&self.values)
    }

    /// The curve with these values (SI, one per point); `None` if it cannot be built from them.
    pub fn curve(&self, values: &[f64]) -> Option<Interpolation> {
        let points: Vec<[f64; 2]> =
            values.iter().enumerate().map(|(point, &value)| [self.argument(point), value]).collect();
        Interpolation::through_points(self.course, &points)
    }
}
