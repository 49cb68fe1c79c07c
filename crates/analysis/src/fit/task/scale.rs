//! Scale of a film as a further number of a fit, with a prior.
//!
//! All lengths of a film come from one ruler: its error is common to them and is not an error of each point. So each record
//! whose scale has a known relative standard error u gets a factor s of all measured lengths with the prior N(1, u). The
//! model's value f of an observation is compared as s^p f, where p is the exponent of the length in its dimension (1 for a
//! position or a velocity, 0 for a time or an angle). The row (s - 1)/u is added to the residuals.
//!
//! The factor multiplies the model and does not divide the data: dividing would make the residuals small for a large s and
//! bias the fit towards it (G. D'Agostini, Nucl. Instrum. Meth. A 346 (1994) 306).
//!
//! The row of the prior counts as a value, and s as a number that the values determine. Both cancel in the degrees of
//! freedom, and neither is counted by AICc and BIC.

use super::plan::Point;
use crate::fit::linear::Jacobian;

/// Multiplies the model's values of a record and their weighted derivatives by the power of the scale, and sets the column
/// of the scale, all from row `base` on.
pub(in crate::fit) fn apply(
    powers: Vec<f64>,
    (number, scale): (usize, f64),
    points: &[Point],
    (base, values, jacobian): (usize, &mut [f64], &mut Jacobian),
) {
    let factors: Vec<f64> = powers.iter().map(|power| libm::pow(scale, *power)).collect();
    for column in (0..jacobian.columns).filter(|column| *column != number) {
        let slopes = &mut jacobian.column_mut(column)[base..];
        slopes.iter_mut().zip(points).for_each(|(slope, point)| *slope *= factors[point.observation]);
    }
    let slopes = &mut jacobian.column_mut(number)[base..];
    for ((slope, value), point) in slopes.iter_mut().zip(values).zip(points) {
        *value *= factors[point.observation];
        *slope = point.factor() * powers[point.observation] * *value / scale;
    }
}

/// Prior of a scale.
#[derive(Clone, Copy, Debug)]
pub(in crate::fit) struct Prior {
    /// Column of the scale in the search.
    pub number: usize,
    /// Index of its record.
    pub record: usize,
    /// Standard error of the scale, relative to 1.
    pub error: f64,
}

/// Adds the rows of the priors from row `base` on. Each is multiplied by `deviation`, the standard deviation of a residual,
/// like the values.
pub(in crate::fit) fn add_priors(
    (priors, deviation): (&[Prior], f64),
    x: &[f64],
    base: usize,
    residuals: &mut [f64],
    jacobian: &mut Jacobian,
) {
    for (row, Prior { number, error, .. }) in (base..).zip(priors) {
        residuals[row] = deviation * (x[*number] - 1.0) / error;
        for column in 0..jacobian.columns {
            jacobian.column_mut(column)[row] = if column == *number { deviation / error } else { 0.0 };
        }
    }
}
