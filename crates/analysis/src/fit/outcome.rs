//! What is known when a fit is finished.

use super::covariance::Covariance;
use super::curve::Derived;
use super::driver::Fit;
use super::elsewhere::Rival;
use super::identify::{Undetermined, undetermined};
use super::linear::Jacobian;
use super::observed::{ObservationFit, Outside};
use super::plan::{Plan, alike, witness};
use super::problem::Problem;
use super::search::Search;
use super::statistics::{self, RunsTest};
use super::task::Target;
use model::Model;
use std::sync::Arc;
use units::Unit;

/// The result of a fit. All numbers are SI; display units stand beside them.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// Whether the search came to its end.
    pub converged: bool,
    /// From how many starts was searched; 1 for a fit that was made again from its answer.
    pub starts: usize,
    /// Another minimum that fits as well within the noise, if a search has ended in one.
    pub rival: Option<Rival>,
    /// How often the profile of a number has met a lower sum of squares, so that the fit was made again from there.
    pub improved: usize,
    /// How many independent values were fitted: a column made from another one does not count.
    pub n: usize,
    /// Degrees of freedom: `n` minus the numbers that were determined.
    pub dof: usize,
    /// The weighted sum of squares.
    pub chi2: f64,
    /// The root of the mean square of the residuals of the first observation, over all records.
    pub rmse: f64,
    /// The unit to show it in.
    pub rmse_unit: Unit,
    /// The sum of squares by degree of freedom, where errors were given.
    pub chi2_reduced: Option<f64>,
    /// The coefficient of determination.
    pub r2: f64,
    /// Akaike's criterion for small samples (Hurvich & Tsai, Biometrika 76 (1989) 297); the variance counts as a parameter
    /// where errors were not given (Burnham & Anderson, Model Selection, 2002, section 2.2). `None` for too few values.
    pub aicc: Option<f64>,
    /// The Bayesian criterion of Schwarz (Ann. Statist. 6 (1978) 461).
    pub bic: f64,
    /// Durbin and Watson's statistic of the first observation's residuals.
    pub durbin_watson: f64,
    /// The correlation of each of them with the one before.
    pub autocorrelation: f64,
    /// The test of their signs.
    pub runs: Option<RunsTest>,
    /// What was varied, in the order of the search.
    pub parameters: Vec<Estimate>,
    /// The document's derived quantities that depend on it.
    pub derived: Vec<Estimate>,
    /// The correlations of the parameters, row by row; NaN where there is none.
    pub correlation: Vec<f64>,
    /// What the data cannot determine.
    pub undetermined: Vec<Undetermined>,
    /// By record and observation.
    pub observations: Vec<ObservationFit>,
    /// By record: the reading of its clock at which the initial values of equations of motion hold. Empty for formulas.
    pub origins: Vec<f64>,
    /// All parameters of the model by record, with the fitted values.
    pub settings: Vec<Vec<f64>>,
}

/// A number found by a fit.
#[derive(Clone, Debug, PartialEq)]
pub struct Estimate {
    /// Its name: the parameter's, `t_origin`, or `y_offset`.
    pub name: String,
    /// The document's label.
    pub label: Option<String>,
    /// The unit to show it in.
    pub unit: Unit,
    /// The model's parameter, if it is one.
    pub parameter: Option<usize>,
    /// The record it belongs to; `None` if it holds for all.
    pub record: Option<usize>,
    /// The value; where it is not determined, the one at which the search ended.
    pub value: f64,
    /// Whether the data determine it.
    pub determined: bool,
    /// Whether it was stopped by the end of its range, so that it has no uncertainty.
    pub at_bound: bool,
    /// The standard error if residuals knew nothing of each other.
    pub stderr: Option<f64>,
    /// The standard error for residuals as they are, correlated in time.
    pub stderr_hac: Option<f64>,
}

/// Whether the model is compatible with the data.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// Residuals look like chance and, where errors were given, have their size.
    Compatible,
    /// Residuals look like chance but are larger than the given errors.
    TooLarge,
    /// Residuals look like chance but are smaller than the given errors.
    TooSmall,
    /// Residuals cling together: the model misses something, or the measurement does.
    Structured,
    /// There are too few values to tell.
    Unknown,
}

impl Outcome {
    /// What the residuals say.
    pub fn verdict(&self) -> Verdict {
        let Some(runs) = self.runs else { return Verdict::Unknown };
        // 2.6 standard deviations: one in a hundred by chance.
        let by_chance = 2.6 / (self.n as f64).sqrt();
        if runs.z < -2.6 || self.autocorrelation > by_chance {
            return Verdict::Structured;
        }
        match self.chi2_reduced {
            // Chi-square has the variance of twice its degrees of freedom.
            Some(reduced) if reduced > 1.0 + 2.6 * (2.0 / self.dof as f64).sqrt() => Verdict::TooLarge,
            Some(reduced) if reduced < 1.0 - 2.6 * (2.0 / self.dof as f64).sqrt() => Verdict::TooSmall,
            _ => Verdict::Compatible,
        }
    }

    /// The parameter or derived quantity of this name, in the first record that has it.
    pub fn estimate(&self, name: &str) -> Option<&Estimate> {
        self.parameters.iter().chain(&self.derived).find(|estimate| estimate.name == name)
    }

    /// The root of the mean square of what was predicted of the first observation outside the fitted part, over all
    /// records; `None` where all was fitted.
    pub fn predicted(&self) -> Option<f64> {
        let outside = self.observations.iter().filter(|one| one.observation == 0).filter_map(|one| one.outside);
        Some(Outside::together(outside)).filter(|all| all.n > 0).map(|all| all.rmse)
    }

    /// The residuals of an observation in the fitted part, measured minus fitted.
    pub fn residuals(&self, observation: usize) -> Vec<f64> {
        self.observations.get(observation).map(ObservationFit::inside_residuals).unwrap_or_default()
    }
}

pub(super) fn outcome(fit: &mut Fit) -> Option<Outcome> {
    let best = fit.best.take()?;
    let outcome = outcome_of(fit, &best);
    fit.best = Some(best);
    Some(outcome)
}

fn outcome_of(fit: &mut Fit, best: &Search) -> Outcome {
    let errors_given = fit.problem.task.errors_given();
    let values = fit.problem.independent_values();
    let covariance = fit.covariance(best);
    let observations = observations(fit, best);
    let (parameters, derived) = estimates(&fit.problem, &fit.model, best, &covariance);
    let names: Vec<String> = parameters.iter().map(|estimate| full_name(estimate, &fit.problem)).collect();
    let first: Vec<Vec<f64>> =
        observations.iter().filter(|one| one.observation == 0).map(ObservationFit::inside_residuals).collect();
    let first: Vec<&[f64]> = first.iter().map(Vec::as_slice).collect();
    let count: usize = first.iter().map(|residuals| residuals.len()).sum();
    let squares: f64 = first.iter().flat_map(|residuals| residuals.iter()).map(|value| value * value).sum();
    let total = fit.problem.spread_sum();
    let (aicc, bic) = criteria(&fit.problem, &observations, best, &covariance, errors_given, values);
    Outcome {
        converged: fit.converged,
        starts: fit.starts,
        rival: fit.rival.clone(),
        improved: fit.improved,
        n: values as usize,
        dof: covariance.dof.max(0.0) as usize,
        chi2: best.sum,
        rmse: (squares / count.max(1) as f64).sqrt(),
        rmse_unit: observations.first().map_or_else(Unit::dimensionless, |one| one.unit.clone()),
        chi2_reduced: (errors_given && covariance.dof > 0.0).then(|| best.sum / covariance.dof),
        r2: 1.0 - best.sum / total,
        aicc,
        bic,
        durbin_watson: statistics::durbin_watson(&first),
        autocorrelation: statistics::autocorrelation(&first),
        runs: statistics::runs_test(&first),
        correlation: correlation(&covariance.textbook, best.x.len()),
        undetermined: undetermined(&covariance.flat, &names, &best.x),
        settings: (0..fit.problem.task.records.len()).map(|record| fit.problem.parameters(record, &best.x)).collect(),
        origins: origins(&fit.problem, best),
        parameters,
        derived,
        observations,
    }
}

fn origins(problem: &Problem, best: &Search) -> Vec<f64> {
    let plans = problem.plans.iter().enumerate().filter(|_| problem.curve.has_states());
    plans.map(|(record, plan)| problem.origin(record, plan, &best.x)).collect()
}

/// A name that tells the record as well, where the number has a value in each.
fn full_name(estimate: &Estimate, problem: &Problem) -> String {
    match estimate.record.and_then(|record| problem.task.records.get(record)) {
        Some(record) => format!("{} ({})", estimate.name, record.name),
        None => estimate.name.clone(),
    }
}

fn estimates(
    problem: &Problem,
    model: &Model,
    best: &Search,
    covariance: &Covariance,
) -> (Vec<Estimate>, Vec<Estimate>) {
    let size = best.x.len();
    let error = |gradient: &[f64], matrix: &[f64]| Covariance::variance(matrix, gradient).sqrt();
    let mut parameters = Vec::with_capacity(size);
    for (number, column) in problem.columns.iter().enumerate() {
        let mut gradient = vec![0.0; size];
        gradient[number] = 1.0;
        let at_bound = best.at_bound(number);
        let determined = covariance.determines(&gradient);
        let certain = determined && !at_bound && covariance.dof > 0.0;
        let (name, label, unit, parameter) = describe(problem, model, column.target);
        parameters.push(Estimate {
            name,
            label,
            unit,
            parameter,
            record: column.record,
            value: best.x[number],
            determined,
            at_bound,
            stderr: certain.then(|| error(&gradient, &covariance.textbook)),
            stderr_hac: certain.then(|| error(&gradient, &covariance.robust)),
        });
    }
    let varied: Vec<usize> = parameters.iter().filter_map(|estimate| estimate.parameter).collect();
    let mut distinct = varied;
    distinct.dedup();
    let mut derived_values = Derived::new(model, &distinct);
    let mut derived = Vec::new();
    let own_values = problem.columns.iter().any(|column| column.record.is_some());
    let records = if own_values { problem.task.records.len() } else { 1 };
    for record in 0..records {
        let (values, slopes) = derived_values.evaluate(&problem.parameters(record, &best.x));
        for (place, &quantity) in derived_values.quantities.iter().enumerate() {
            let quantity = &model.quantities[quantity];
            let mut gradient = vec![0.0; size];
            for (number, column) in problem.columns.iter().enumerate() {
                if column.belongs_to(record)
                    && let Target::Parameter(index) = column.target
                    && let Some(slope) = distinct.iter().position(|&known| known == index)
                {
                    gradient[number] = slopes[place][slope];
                }
            }
            let determined = values[place].is_finite()
                && gradient.iter().all(|value| value.is_finite())
                && covariance.determines(&gradient);
            let certain = determined && covariance.dof > 0.0;
            derived.push(Estimate {
                name: quantity.name.clone(),
                label: quantity.label.clone(),
                unit: quantity.value.unit.clone(),
                parameter: None,
                record: own_values.then_some(record),
                value: values[place],
                determined,
                at_bound: false,
                stderr: certain.then(|| error(&gradient, &covariance.textbook)),
                stderr_hac: certain.then(|| error(&gradient, &covariance.robust)),
            });
        }
    }
    (parameters, derived)
}

/// Name, label, unit and, for a parameter, its number.
fn describe(problem: &Problem, model: &Model, target: Target) -> (String, Option<String>, Unit, Option<usize>) {
    match target {
        Target::Parameter(index) => match model.parameters.get(index) {
            Some(parameter) => (parameter.name.clone(), parameter.label.clone(), parameter.unit.clone(), Some(index)),
            None => (String::new(), None, Unit::dimensionless(), Some(index)),
        },
        Target::Origin => (format!("{}_origin", model.independent.name), None, model.independent.unit.clone(), None),
        Target::Offset(number) => {
            let observation = problem.task.records.iter().find_map(|record| record.observations.get(number));
            match observation {
                Some(one) => (format!("{}_offset", one.name), None, one.observed.unit.clone(), None),
                None => ("offset".to_owned(), None, Unit::dimensionless(), None),
            }
        }
    }
}

fn correlation(covariance: &[f64], size: usize) -> Vec<f64> {
    let deviation: Vec<f64> = (0..size).map(|k| covariance[k * size + k].sqrt()).collect();
    let mut correlation = vec![f64::NAN; size * size];
    for row in 0..size {
        for column in 0..size {
            let scale = deviation[row] * deviation[column];
            if scale > 0.0 {
                correlation[row * size + column] = covariance[row * size + column] / scale;
            }
        }
    }
    correlation
}

/// Every observation beside the curve, in and outside the fitted part.
fn observations(fit: &mut Fit, best: &Search) -> Vec<ObservationFit> {
    let whole = fit.problem.plan(|_| true);
    let count = |plans: &[Plan]| plans.iter().map(|plan| plan.points.len()).sum::<usize>();
    // Where nothing lies outside, the search has left all residuals.
    let known = fit.finished && count(&whole) == count(&fit.problem.plans);
    let plans = if known { fit.problem.plans.clone() } else { Arc::new(whole) };
    let mut searched = best.residuals.as_slice();
    let mut fits = Vec::new();
    for (record, plan) in plans.iter().enumerate() {
        let residuals = match searched.split_at_checked(plan.points.len()).filter(|_| known) {
            Some((own, rest)) => {
                searched = rest;
                own.to_vec()
            }
            None => residuals_of(&mut fit.problem, record, plan, &best.x),
        };
        let task = &fit.problem.task;
        for (observation, one) in task.records[record].observations.iter().enumerate() {
            let early = fit.problem.too_early(record, observation);
            let mut fit = ObservationFit {
                record,
                observation,
                name: one.name.clone(),
                unit: one.observed.unit.clone(),
                derived: witness(&task.records[record], observation) != observation,
                times: Vec::with_capacity(one.times.len()),
                measured: Vec::with_capacity(one.times.len()),
                fitted: Vec::with_capacity(one.times.len()),
                inside: Vec::with_capacity(one.times.len()),
                early: 0,
                rmse: 0.0,
                r2: 0.0,
                outside: None,
            };
            fit.add_early(&early);
            for (point, residual) in
                plan.points.iter().zip(&residuals).filter(|(point, _)| point.observation == observation)
            {
                let time = plan.times[point.row];
                fit.times.push(time);
                fit.measured.push(point.value);
                fit.fitted.push(point.value + residual / point.weight);
                fit.inside.push(task.covers(time));
            }
            fit.summarise();
            fits.push(fit);
        }
    }
    fits
}

/// The weighted residuals of a record; NaN where the curve does not reach.
fn residuals_of(problem: &mut Problem, record: usize, plan: &Plan, x: &[f64]) -> Vec<f64> {
    let mut residuals = vec![f64::NAN; plan.points.len()];
    let mut jacobian = Jacobian::new(residuals.len(), x.len());
    problem.record_residuals(record, plan, x, 0, &mut residuals, &mut jacobian);
    residuals
}

/// AICc and BIC from the likelihood of normal residuals: with the given errors, or with a variance of its own for each
/// observation, at its most likely value.
fn criteria(
    problem: &Problem,
    observations: &[ObservationFit],
    best: &Search,
    covariance: &Covariance,
    errors_given: bool,
    values: f64,
) -> (Option<f64>, f64) {
    let numbers = (best.x.len() - covariance.flat.len()) as f64;
    let (deviance, k) = if errors_given {
        (best.sum, numbers)
    } else {
        let mut deviance = 0.0;
        let mut variances = 0.0;
        for one in observations {
            let record = &problem.task.records[one.record];
            let alike = alike(record, one.observation) as f64;
            let n = one.inside.iter().filter(|inside| **inside).count() as f64;
            if n > 0.0 {
                deviance += n / alike * libm::log(one.rmse * one.rmse);
                variances += 1.0 / alike;
            }
        }
        (deviance, numbers + variances)
    };
    let room = values - k - 1.0;
    let aicc = (room > 0.0).then(|| deviance + 2.0 * k + 2.0 * k * (k + 1.0) / room);
    (aicc, deviance + k * libm::log(values))
}
