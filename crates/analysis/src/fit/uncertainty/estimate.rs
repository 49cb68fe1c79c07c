//! The numbers that a fit finds, with their errors: what was varied, and what follows from it.

use super::covariance::Covariance;
use super::student::student;
use crate::fit::search::Search;
use crate::fit::search::curve::Derived;
use crate::fit::search::problem::Problem;
use crate::fit::task::Target;
use program::Model;
use units::Unit;

/// A number found by a fit.
#[derive(Clone, Debug, PartialEq)]
pub struct Estimate {
    /// Its name: the parameter's, `t_origin`, or `y_offset`.
    pub name: String,
    /// The document's label.
    pub label: Option<String>,
    /// The unit to show it in.
    pub unit: Unit,
    /// What was varied; none for a quantity that follows from it.
    pub target: Option<Target>,
    /// The record it belongs to; `None` if it holds for all.
    pub record: Option<usize>,
    /// The value; where it is not determined, the one at which the search ended.
    pub value: f64,
    /// Whether the data determine it.
    pub determined: bool,
    /// Whether it was stopped by the end of its range, so that it has no standard error; of a quantity that follows from others,
    /// whether all those were.
    pub at_bound: bool,
    /// The standard error for independent residuals.
    pub stderr: Option<f64>,
    /// The standard error for residuals as they are, correlated in time and of uneven size.
    pub stderr_hac: Option<f64>,
    /// The degrees of freedom of that error: few where a record is short for the correlation of its residuals.
    pub freedom: f64,
}

/// The probability that the interval shown beside a standard error misses the true value.
const MISSED: f64 = 0.05;

impl Estimate {
    /// The model's parameter, if it is one that was varied.
    pub fn parameter(&self) -> Option<usize> {
        match self.target {
            Some(Target::Parameter(index)) => Some(index),
            _ => None,
        }
    }

    /// So many standard errors to either side hold the true value with a probability of 95 %: Student's t.
    pub fn coverage_factor(&self) -> f64 {
        student(MISSED, self.freedom)
    }

    /// The interval that holds the true value with a probability of 95 %, SI.
    pub fn interval(&self) -> Option<(f64, f64)> {
        let reach = self.stderr_hac.filter(|error| error.is_finite())? * self.coverage_factor();
        Some((self.value - reach, self.value + reach))
    }
}

/// The uncertainty of what changes along a gradient.
struct Uncertainty {
    stderr: Option<f64>,
    stderr_hac: Option<f64>,
    freedom: f64,
}

impl Uncertainty {
    /// `certain` says whether there is any.
    fn along(gradient: &[f64], covariance: &Covariance, certain: bool) -> Self {
        Self {
            stderr: certain.then(|| Covariance::variance(&covariance.textbook, gradient).sqrt()),
            stderr_hac: certain.then(|| covariance.robust(gradient).sqrt()),
            freedom: if certain { covariance.freedom(gradient) } else { covariance.dof },
        }
    }
}

/// A name that tells the record as well, where the number has a value in each.
pub(in crate::fit) fn full_name(estimate: &Estimate, problem: &Problem) -> String {
    match estimate.record.and_then(|record| problem.task.records.get(record)) {
        Some(record) => format!("{} ({})", estimate.name, record.name),
        None => estimate.name.clone(),
    }
}

/// What was varied, and the derived quantities of the document that depend on it.
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
    let own_values = problem.columns.iter().any(|column| !column.is_scale() && column.record.is_some());
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

/// Name, label and unit.
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

/// The correlations of the first `count` columns of a covariance of `size`; NaN where there is none.
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
