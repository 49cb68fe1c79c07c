//! Estimates with their errors: the varied numbers and the derived quantities.

use super::covariance::Covariance;
use super::student::student;
use crate::fit::search::Search;
use crate::fit::search::curve::Derived;
use crate::fit::search::problem::Problem;
use crate::fit::task::Target;
use program::Model;
use serde::{Deserialize, Serialize};
use units::Unit;

/// Estimate of a number by a fit.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Estimate {
    /// Name of the parameter, `t_origin`, or `y_offset`.
    pub name: String,
    /// Label in the document.
    pub label: Option<String>,
    /// Display unit.
    pub unit: Unit,
    /// Target that was varied; `None` for a derived quantity.
    pub target: Option<Target>,
    /// Index of its record; `None` if it holds for all.
    pub record: Option<usize>,
    /// Value, SI; if it is not determined, the one at the end of the search.
    pub value: f64,
    /// True if the data determine it.
    pub determined: bool,
    /// True if it was stopped by a bound of its range, so that it has no standard error. For a derived quantity: true if
    /// all numbers it depends on were stopped.
    pub at_bound: bool,
    /// Standard error for independent residuals, SI; `None` if not determined or stopped, or without degrees of freedom.
    pub stderr: Option<f64>,
    /// Standard error for autocorrelated residuals of uneven size, SI; `None` as for `stderr`.
    pub stderr_hac: Option<f64>,
    /// Degrees of freedom of `stderr_hac`: few if the record is short for the correlation of its residuals.
    pub freedom: f64,
}

/// Probability that the interval shown beside a standard error misses the true value.
const MISSED: f64 = 0.05;

impl Estimate {
    /// Index of the varied parameter of the model; `None` for other targets.
    pub fn parameter(&self) -> Option<usize> {
        match self.target {
            Some(Target::Parameter(index)) => Some(index),
            _ => None,
        }
    }

    /// Factor of the standard error for an interval of 95 % confidence: Student's t.
    pub fn coverage_factor(&self) -> f64 {
        student(MISSED, self.freedom)
    }

    /// Interval of 95 % confidence, SI; `None` without a finite standard error.
    pub fn interval(&self) -> Option<(f64, f64)> {
        let reach = self.stderr_hac.filter(|error| error.is_finite())? * self.coverage_factor();
        Some((self.value - reach, self.value + reach))
    }
}

/// Uncertainty of a quantity with a given gradient.
struct Uncertainty {
    stderr: Option<f64>,
    stderr_hac: Option<f64>,
    freedom: f64,
}

impl Uncertainty {
    /// Uncertainty along `gradient`; without standard errors unless `certain`.
    fn along(gradient: &[f64], covariance: &Covariance, certain: bool) -> Self {
        Self {
            stderr: certain.then(|| Covariance::variance(&covariance.textbook, gradient).sqrt()),
            stderr_hac: certain.then(|| covariance.robust(gradient).sqrt()),
            freedom: if certain { covariance.freedom(gradient) } else { covariance.dof },
        }
    }
}

/// Name, followed by that of the record if the number has a value in each.
pub(in crate::fit) fn full_name(estimate: &Estimate, problem: &Problem) -> String {
    match estimate.record.and_then(|record| problem.task.records.get(record)) {
        Some(record) => format!("{} ({})", estimate.name, record.name),
        None => estimate.name.clone(),
    }
}

/// Estimates of the varied numbers, and of the derived quantities of the document that depend on them.
pub(in crate::fit) fn estimates(
    problem: &Problem,
    best: &Search,
    covariance: &Covariance,
) -> (Vec<Estimate>, Vec<Estimate>) {
    let model = &problem.model;
    let size = best.x.len();
    let mut parameters = Vec::with_capacity(size);
    for (number, column) in problem.columns.iter().enumerate() {
        let Some(target) = column.target() else { continue };
        let mut gradient = vec![0.0; size];
        gradient[number] = 1.0;
        let at_bound = best.at_bound(number);
        let determined = covariance.determines(&gradient);
        let certain = determined && !at_bound && covariance.dof > 0.0;
        let Uncertainty { stderr, stderr_hac, freedom } = Uncertainty::along(&gradient, covariance, certain);
        let (name, label, unit) = describe(problem, model, target);
        parameters.push(Estimate {
            name,
            label,
            unit,
            target: Some(target),
            record: column.record,
            value: best.x[number],
            determined,
            at_bound,
            stderr,
            stderr_hac,
            freedom,
        });
    }
    let varied: Vec<usize> = parameters.iter().filter_map(Estimate::parameter).collect();
    let mut distinct = varied;
    distinct.dedup();
    let mut derived_values = Derived::new(model, &distinct);
    let mut derived = Vec::new();
    let varied = problem.columns.iter().any(|column| !column.is_scale() && column.record.is_some());
    let own_values = problem.task.records.len() > 1
        && (varied || problem.task.records.iter().any(|record| !record.fixed.is_empty()));
    let records = if own_values { problem.task.records.len() } else { 1 };
    for record in 0..records {
        let (values, slopes) = derived_values.evaluate(&problem.parameters(record, &best.x));
        for (place, &quantity) in derived_values.quantities.iter().enumerate() {
            let quantity = &model.quantities[quantity];
            let mut gradient = vec![0.0; size];
            for (number, column) in problem.columns.iter().enumerate() {
                if column.belongs_to(record)
                    && let Some(Target::Parameter(index)) = column.target()
                    && let Some(slope) = distinct.iter().position(|&known| known == index)
                {
                    gradient[number] = slopes[place][slope];
                }
            }
            let determined = values[place].is_finite()
                && gradient.iter().all(|value| value.is_finite())
                && covariance.determines(&gradient);
            let (stopped, free): (Vec<usize>, Vec<usize>) =
                (0..size).filter(|&number| gradient[number] != 0.0).partition(|&number| best.at_bound(number));
            let certain = determined && !free.is_empty() && covariance.dof > 0.0;
            let Uncertainty { stderr, stderr_hac, freedom } = Uncertainty::along(&gradient, covariance, certain);
            derived.push(Estimate {
                name: quantity.name.clone(),
                label: quantity.label.clone(),
                unit: quantity.value.unit.clone(),
                target: None,
                record: own_values.then_some(record),
                value: values[place],
                determined,
                at_bound: free.is_empty() && !stopped.is_empty(),
                stderr,
                stderr_hac,
                freedom,
            });
        }
    }
    (parameters, derived)
}

/// Name, label and unit of a target.
fn describe(problem: &Problem, model: &Model, target: Target) -> (String, Option<String>, Unit) {
    match target {
        Target::Parameter(index) => match model.parameters.get(index) {
            Some(parameter) => (parameter.name.clone(), parameter.label.clone(), parameter.unit.clone()),
            None => (String::new(), None, Unit::dimensionless()),
        },
        Target::Origin => (format!("{}_origin", model.independent.name), None, model.independent.unit.clone()),
        Target::Offset(number) => {
            let observation = problem.task.records.iter().find_map(|record| record.observations.get(number));
            match observation {
                Some(one) => (format!("{}_offset", one.name), None, one.observed.unit.clone()),
                None => ("offset".to_owned(), None, Unit::dimensionless()),
            }
        }
    }
}

/// Correlations of the first `count` columns of a covariance matrix of `size`; NaN where a variance is zero.
pub(in crate::fit) fn correlation(covariance: &[f64], size: usize, count: usize) -> Vec<f64> {
    let deviation: Vec<f64> = (0..count).map(|k| covariance[k * size + k].sqrt()).collect();
    let mut correlation = vec![f64::NAN; count * count];
    for row in 0..count {
        for column in 0..count {
            let scale = deviation[row] * deviation[column];
            if scale > 0.0 {
                let rounded = covariance[row * size + column] / scale;
                correlation[row * count + column] = if row == column { 1.0 } else { rounded };
            }
        }
    }
    correlation
}
