//! The scale of a film as a further number of a fit, with a prior.
//!
//! All lengths of a film come from one ruler: its error is shared by them and is no error of each point. So each record whose scale
//! has a known relative standard error u takes a factor s of all measured lengths with the prior N(1, u): the model's value f of an
//! observation is compared as s^p f, p being the exponent of the length in its dimension (1 for a position or a velocity, 0 for a
//! time or an angle), and the row (s - 1)/u is added to the residuals.
//!
//! The factor multiplies the model and does not divide the data: that would make the residuals of a large s small, and draw the
//! fit towards it (G. D'Agostini, Nucl. Instrum. Meth. A 346 (1994) 306).
//!
//! The row of the prior counts as a value and s as a number that the values determine, so that both cancel in the degrees of
//! freedom, and neither is counted by AICc and BIC.

use super::columns::Column;
use super::covariance::Covariance;
use super::linear::Jacobian;
use super::plan::Point;
use super::problem::Problem;
use super::search::Search;
use super::task::{Observation, Task};
use super::weights::EXACT;

/// The scale of a record's film, as a fit has found it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FilmScale {
    /// Which record.
    pub record: usize,
    /// By which factor its measured lengths are too large.
    pub value: f64,
    /// The standard error of the factor; `None` where the fit leaves no degree of freedom.
    pub stderr: Option<f64>,
    /// The standard error that it had before the fit.
    pub prior: f64,
}

/// The numbers of the search that are scales: one for each record in which lengths have a known error.
pub(super) fn columns(task: &Task) -> impl Iterator<Item = Column> + '_ {
    let scaled = |(_, record): &(usize, &super::Record)| {
        record.scale_error.is_some() && record.observations.iter().any(|one| power(one) != 0.0)
    };
    let column = |(record, _)| Column { varied: None, record: Some(record) };
    task.records.iter().enumerate().filter(scaled).map(column)
}

/// How many of the columns are scales.
pub(super) fn count(columns: &[Column]) -> usize {
    columns.iter().filter(|column| column.is_scale()).count()
}

/// The exponent of the length in the dimension of what is observed.
fn power(observation: &Observation) -> f64 {
    let dimension = observation.observed.unit.dimension;
    dimension.base().find(|(symbol, _)| *symbol == "m").map_or(0.0, |(_, exponent)| exponent.to_number())
}

impl Problem {
    /// The scale of a record, if it has one: the number of its column, and its value.
    pub(super) fn scale(&self, record: usize, x: &[f64]) -> Option<(usize, f64)> {
        let column = |column: &Column| column.is_scale() && column.belongs_to(record);
        let number = self.columns.iter().position(column)?;
        Some((number, x[number]))
    }

    /// By observation of a record: which power of the scale it is proportional to.
    pub(super) fn powers(&self, record: usize) -> Vec<f64> {
        self.task.records[record].observations.iter().map(power).collect()
    }

    /// The prior errors of the scales, in the order of their columns.
    fn scale_errors(&self) -> impl Iterator<Item = (usize, usize, f64)> + '_ {
        self.columns.iter().enumerate().filter_map(|(number, column)| {
            let record = column.record.filter(|_| column.is_scale())?;
            Some((number, record, self.task.records[record].scale_error?))
        })
    }
}

/// Multiplies the model's values of a record and their weighted derivatives by the power of the scale, and sets its own column; all
/// from row `base` on.
pub(super) fn apply(
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

/// Adds the rows of the priors, from row `base` on. They are weighed as the values are: by the standard deviation of a residual.
pub(super) fn add_priors(problem: &Problem, x: &[f64], base: usize, residuals: &mut [f64], jacobian: &mut Jacobian) {
    for (row, (number, _, error)) in (base..).zip(problem.scale_errors()) {
        residuals[row] = problem.deviation * (x[number] - 1.0) / error;
        for column in 0..jacobian.columns {
            jacobian.column_mut(column)[row] = if column == number { problem.deviation / error } else { 0.0 };
        }
    }
}

/// The standard deviation of a weighted residual: 1 where errors are given, else by the `residuals` at the end of a search, but not
/// below that of an exact fit.
pub(super) fn deviation(problem: &Problem, residuals: &[f64]) -> f64 {
    let scales = problem.scales();
    if scales == 0 || problem.task.errors_given() {
        return 1.0;
    }
    let values = &residuals[..residuals.len() - scales];
    let squares = values.iter().fold(0.0, |sum, residual| sum + residual * residual);
    let freedom = problem.independent_values() - (problem.own.len() - scales) as f64;
    let least = EXACT * (problem.total / values.len() as f64).sqrt();
    (squares / freedom.max(1.0)).sqrt().max(least).max(f64::MIN_POSITIVE)
}

/// The scales at the end of a search.
pub(super) fn found(problem: &Problem, best: &Search, covariance: &Covariance) -> Vec<FilmScale> {
    let scale = |(number, record, prior): (usize, usize, f64)| {
        let mut gradient = vec![0.0; best.x.len()];
        gradient[number] = 1.0;
        let stderr = (covariance.dof > 0.0).then(|| covariance.robust(&gradient).sqrt());
        FilmScale { record, value: best.x[number], stderr, prior }
    };
    problem.scale_errors().map(scale).collect()
}
