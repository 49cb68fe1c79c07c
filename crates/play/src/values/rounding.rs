//! Rounding errors among the values shown: what is left where large numbers cancel.

use super::Shown;
use units::Dimension;

/// Largest rounding error, relative to the greatest value of the same dimension.
const RELATIVE: f64 = 4.0 * f64::EPSILON;

/// The greatest magnitude of each dimension in the run, SI.
pub(super) struct Rounding(Vec<(Dimension, f64)>);

impl Rounding {
    /// Of the parameters, states and quantities of a run.
    pub fn of(shown: &Shown) -> Self {
        let (model, course) = (shown.basis.model(), shown.line.course());
        let mut greatest = Self(Vec::new());
        for (parameter, value) in model.parameters.iter().zip(course.parameters()) {
            greatest.widen(parameter.unit.dimension, *value);
        }
        for (index, state) in model.states.iter().enumerate() {
            greatest.widen(state.unit.dimension, shown.line.greatest(index));
        }
        for (quantity, scale) in model.quantities.iter().zip(&shown.values.quantity_scales) {
            greatest.widen(quantity.value.unit.dimension, *scale);
        }
        greatest
    }

    fn widen(&mut self, dimension: Dimension, value: f64) {
        let value = if value.is_finite() { value.abs() } else { 0.0 };
        match self.0.iter_mut().find(|(known, _)| *known == dimension) {
            Some((_, greatest)) => *greatest = greatest.max(value),
            None => self.0.push((dimension, value)),
        }
    }

    /// The value, or 0 if it is not more than a rounding error.
    pub fn cleared(&self, value: f64, dimension: Dimension) -> f64 {
        let greatest = self.0.iter().find(|(known, _)| *known == dimension).map_or(0.0, |(_, greatest)| *greatest);
        if value.abs() <= RELATIVE * greatest { 0.0 } else { value }
    }
}
