//! Result of a fit.

use super::judgement::criteria::{Criteria, criteria};
use super::judgement::statistics::RunsTest;
use super::judgement::undersampled::undersampled;
use super::judgement::{Judgement, Outlier};
use super::linear::{Jacobian, dot};
use super::observed::{ObservationFit, Outside};
use super::search::Search;
use super::search::elsewhere::Rival;
use super::search::loss::Loss;
use super::search::problem::Problem;
use super::search::robust;
use super::search::robust::{Reweighted, Reweighting};
use super::task::film_scale;
use super::task::film_scale::FilmScale;
use super::task::plan::{Plan, independent};
use super::uncertainty::estimate;
use super::uncertainty::estimate::Estimate;
use super::uncertainty::identify;
use super::uncertainty::identify::{Lack, Undetermined};
use serde::{Deserialize, Serialize};
use std::sync::Arc;
use units::Unit;

/// Starts that a person has given to a fit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Scan {
    /// Number of starts from each of which the fit was made.
    pub starts: usize,
    /// Number of these fits that ended at the answer.
    pub ended: usize,
}

/// Result of a fit. All numbers are SI; units for display are given separately.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Outcome {
    /// True if the search converged.
    pub converged: bool,
    /// Number of starts that were searched; 1 for a fit resumed from a known answer ([`super::Fit::again`]).
    pub starts: usize,
    /// Starts given by a person, if there were several.
    pub scan: Option<Scan>,
    /// Another minimum that fits as well within the noise, if the search has found one.
    pub rival: Option<Rival>,
    /// Period of an oscillation that the residuals of a model with several frequencies hold, SI: another minimum may exist.
    pub unexplained: Option<f64>,
    /// Number of times a profile found a lower sum of squares, so that the fit was restarted there.
    pub improved: usize,
    /// True if trials were given up because they needed more computation than a trial may take.
    pub gave_up: bool,
    /// Number of independent fitted values: a column computed from another one does not count.
    pub n: usize,
    /// Degrees of freedom: `n` minus the number of values that the data determine. A number at a bound of its range does
    /// not count as determined.
    pub dof: usize,
    /// Weighted sum of squares, including the priors of film scales.
    pub chi2: f64,
    /// Root mean square of the residuals of the first observation over all records, SI.
    pub rmse: f64,
    /// Display unit of `rmse`.
    pub rmse_unit: Unit,
    /// Sum of squares per degree of freedom; `None` unless errors were given and the loss is the square.
    pub chi2_reduced: Option<f64>,
    /// Coefficient of determination; NaN with a robust loss, which does not maximise it.
    pub r2: f64,
    /// True if the residuals are rounding errors: below 1e-9 of the scatter of the values.
    pub exact: bool,
    /// Akaike's criterion for small samples (Hurvich & Tsai, Biometrika 76 (1989) 297); `None` for too few values. It
    /// counts the numbers that the data determine, `n - dof`, and the variance where errors were not given (Burnham &
    /// Anderson, Model Selection, 2002, section 2.2). With a robust loss the likelihood is that of Student's distribution
    /// with four degrees of freedom, else that of normal residuals.
    pub aicc: Option<f64>,
    /// Bayesian criterion of Schwarz (Ann. Statist. 6 (1978) 461).
    pub bic: f64,
    /// Values far beyond the scatter of the others.
    pub outliers: Vec<Outlier>,
    /// True if the outliers lie so far from all other values that the curve follows them and does not describe the others.
    /// Then only these are listed in `outliers`.
    pub misled: bool,
    /// Number of values judged by `durbin_watson`, `autocorrelation` and `runs`: those of all measured observations,
    /// without outliers.
    pub judged: usize,
    /// Durbin-Watson statistic of the residuals, each observation in units of its own scatter.
    pub durbin_watson: f64,
    /// Correlation of each residual with the one before.
    pub autocorrelation: f64,
    /// Runs test of the signs of the residuals.
    pub runs: Option<RunsTest>,
    /// Effective number of independent values for a slow change, allowing for the autocorrelation of the errors.
    pub independent: f64,
    /// True if the errors cannot be distinguished from a random walk: the record is too short to determine their
    /// correlation.
    pub wanders: bool,
    /// Varied numbers, in the order of the search.
    pub parameters: Vec<Estimate>,
    /// Film scales of the records with a known error of their lengths, in the order of the records.
    pub scales: Vec<FilmScale>,
    /// Derived quantities of the document that depend on the varied numbers.
    pub derived: Vec<Estimate>,
    /// Correlation matrix of the parameters, row by row; NaN where undefined.
    pub correlation: Vec<f64>,
    /// Numbers and combinations that the data cannot determine.
    pub undetermined: Vec<Undetermined>,
    /// Records whose fitted curve oscillates faster than their samples can show; empty until the fit is finished.
    pub undersampled: Vec<usize>,
    /// Effect of a robust loss; `None` for least squares.
    pub reweighted: Option<Reweighted>,
    /// Measured and fitted values, by record and observation.
    pub observations: Vec<ObservationFit>,
    /// One value per record: the reading of its clock at the model's 0, where the initial values of equations of motion hold. Empty
    /// for formulas, unless a clock that begins late was moved.
    pub origins: Vec<f64>,
    /// Values of all parameters of the model, one row per record, with the fitted values.
    pub settings: Vec<Vec<f64>>,
}

impl Outcome {
    /// Numbers that the search stopped at a bound of their range.
    pub fn stopped(&self) -> impl Iterator<Item = &Estimate> {
        self.parameters.iter().filter(|one| one.at_bound && one.determined)
    }

    /// Parameter or derived quantity of this name, in the first record that has it.
    pub fn estimate(&self, name: &str) -> Option<&Estimate> {
        self.parameters.iter().chain(&self.derived).find(|estimate| estimate.name == name)
    }

    /// Root mean square of measured minus predicted for the first observation outside the fitted part, over all records,
    /// SI; `None` if all values were fitted.
    pub fn predicted(&self) -> Option<f64> {
        let outside = self.observations.iter().filter(|one| one.observation == 0).filter_map(|one| one.outside);
        Some(Outside::together(outside)).filter(|all| all.n > 0).map(|all| all.rmse)
    }

    /// Residuals in the fitted part, measured minus fitted, of the entry of [`Outcome::observations`] with this index.
    pub fn residuals(&self, observation: usize) -> Vec<f64> {
        self.observations.get(observation).map(ObservationFit::inside_residuals).unwrap_or_default()
    }
}

/// Progress of a fit.
#[derive(Clone, Debug, Default)]
pub(super) struct Course {
    /// True if the fit is finished.
    pub finished: bool,
    /// See [`Outcome::converged`].
    pub converged: bool,
    /// See [`Outcome::starts`].
    pub starts: usize,
    /// See [`Outcome::rival`].
    pub rival: Option<Rival>,
    /// See [`Outcome::unexplained`].
    pub unexplained: Option<f64>,
    /// See [`Outcome::improved`].
    pub improved: usize,
    /// Pairs of columns of the search whose values can be exchanged.
    pub exchanges: Vec<[usize; 2]>,
}

/// Result of the fit if the search `best` is its answer.
pub(super) fn outcome(problem: &mut Problem, best: &Search, reweighting: &Reweighting, course: &Course) -> Outcome {
    let errors_given = problem.task.errors_given();
    let values = problem.independent_values();
    let covariance = reweighting.covariance(problem, best);
    let observations = observations(problem, best, course.finished);
    let scales = film_scale::found(problem, best, &covariance);
    let (parameters, derived) = estimate::estimates(problem, best, &covariance);
    let mut names: Vec<String> = parameters.iter().map(|one| estimate::full_name(one, problem)).collect();
    names.resize(best.x.len(), "film_scale".to_owned());
    let mut lacks = identify::undetermined(&covariance.flat, &names, &best.x);
    lacks.extend(identify::weak(best, &covariance, &names));
    let determined = |column: &usize| parameters.get(*column).is_some_and(|one| one.determined);
    let exchanged = course.exchanges.iter().filter(|pair| pair.iter().all(determined));
    lacks.extend(exchanged.map(|pair| Undetermined {
        lack: Lack::Exchange,
        names: pair.map(|column| names[column].clone()).to_vec(),
        combinations: Vec::new(),
    }));
    let first = observations.iter().filter(|one| one.observation == 0);
    let rmse = Outside::together(first.map(|one| one.error_where(|_, inside| inside))).rmse;
    let residuals = robust::plain_residuals(problem, best);
    let chi2 = dot(&residuals, &residuals);
    let priors = dot(&residuals[residuals.len() - scales.len()..], &residuals[residuals.len() - scales.len()..]);
    let reweighted = reweighting.reweighted(problem);
    // With a robust loss, outliers have no weight and do not pull the curve.
    let basis = if reweighted.is_none() { &covariance.basis[..] } else { &[] };
    let judgement = Judgement::new(problem, &problem.plans, &observations, residuals, basis);
    let determined = covariance.basis.len() - scales.len();
    let Criteria { aicc, bic, exact } = criteria(problem, &observations, determined, chi2, values);
    Outcome {
        converged: course.converged,
        starts: course.starts,
        scan: None,
        rival: course.rival.clone(),
        unexplained: course.unexplained,
        improved: course.improved,
        gave_up: problem.curve.gave_up(),
        n: values as usize,
        dof: covariance.dof.max(0.0) as usize,
        chi2,
        rmse,
        rmse_unit: observations.first().map_or_else(Unit::dimensionless, |one| one.unit.clone()),
        chi2_reduced: (errors_given && reweighted.is_none() && covariance.dof > 0.0).then(|| chi2 / covariance.dof),
        r2: if reweighted.is_none() { 1.0 - (chi2 - priors) / problem.total } else { f64::NAN },
        exact,
        aicc,
        bic,
        outliers: judgement.outliers,
        misled: judgement.misled,
        judged: judgement.count,
        durbin_watson: judgement.durbin_watson,
        autocorrelation: judgement.autocorrelation,
        runs: judgement.runs,
        independent: covariance.independent(),
        wanders: covariance.wanders(),
        correlation: estimate::correlation(&covariance.textbook, best.x.len(), parameters.len()),
        undetermined: lacks,
        undersampled: if course.finished { undersampled(problem, best) } else { Vec::new() },
        settings: (0..problem.task.records.len()).map(|record| problem.settings(record, &best.x)).collect(),
        origins: origins(problem, best),
        parameters,
        scales,
        derived,
        observations,
        reweighted,
    }
}

fn origins(problem: &Problem, best: &Search) -> Vec<f64> {
    let counts = problem.curve.has_states() || problem.layout.moved.contains(&true);
    let plans = problem.plans.iter().enumerate().filter(|_| counts);
    plans.map(|(record, plan)| problem.origin(record, plan, &best.x)).collect()
}

/// Measured and fitted values of every observation, in and outside the fitted part.
fn observations(problem: &mut Problem, best: &Search, finished: bool) -> Vec<ObservationFit> {
    let whole = problem.whole_plans();
    let count = |plans: &[Plan]| plans.iter().map(|plan| plan.points.len()).sum::<usize>();
    // If no value lies outside, the residuals of the search cover all values.
    let plain = problem.task.loss == Loss::Squares;
    let known = plain && finished && count(&whole) == count(&problem.plans);
    let plans = if known { problem.plans.clone() } else { Arc::new(whole) };
    let mut searched = best.residuals.as_slice();
    let mut fits = Vec::new();
    for (record, plan) in plans.iter().enumerate() {
        let residuals = match searched.split_at_checked(plan.points.len()).filter(|_| known) {
            Some((own, rest)) => {
                searched = rest;
                own.to_vec()
            }
            None => residuals_of(problem, record, plan, &best.x),
        };
        let task = &problem.task;
        for (observation, one) in task.records[record].observations.iter().enumerate() {
            let early = problem.layout.too_early(task, record, observation);
            let mut fit = ObservationFit {
                record,
                observation,
                name: one.name.clone(),
                unit: one.observed.unit.clone(),
                derived: independent(&task.records[record], observation) != observation,
                times: Vec::with_capacity(one.times.len()),
                measured: Vec::with_capacity(one.times.len()),
                fitted: Vec::with_capacity(one.times.len()),
                inside: Vec::with_capacity(one.times.len()),
                excluded: Vec::with_capacity(one.times.len()),
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
                fit.inside.push(task.covers(time) && !point.excluded);
                fit.excluded.push(point.excluded);
            }
            fit.summarise();
            fits.push(fit);
        }
    }
    fits
}

/// Weighted residuals of a record; NaN where the curve has no value.
fn residuals_of(problem: &mut Problem, record: usize, plan: &Plan, x: &[f64]) -> Vec<f64> {
    let mut residuals = vec![f64::NAN; plan.points.len()];
    let mut jacobian = Jacobian::new(residuals.len(), x.len());
    problem.record_residuals(record, plan, x, &mut residuals, &mut jacobian);
    residuals
}
