//! The course of a fit: which starts are tried, how several observations are weighed, when it ends.

use super::covariance::Covariance;
use super::curve;
use super::elsewhere::{self, Elsewhere, Rival, Texture};
use super::linear::{Decomposition, norm};
use super::outcome::{self, Outcome};
use super::plan::Plan;
use super::problem::{Problem, Window};
use super::robust::{Loss, Reweighting};
use super::search::{Search, Status};
use super::stages::{Current, Stage};
use super::task::{FitError, Target, Task};
use super::{start, symmetry};
use crate::cycles::Estimate;
use program::Model;

/// A fit that goes on one trial at a time.
///
/// It searches from the given or the parameters' own values, then from the frequency and the damping that the data show,
/// then along windows that grow from the beginning of the record, then from starts spread over the ranges. Further starts
/// are only tried while the best one leaves much unexplained; own values that explain nothing come after the estimate. Of a
/// model with events or branches the best answer is then tried from starts around it.
#[derive(Clone, Debug)]
pub struct Fit {
    pub(super) model: Model,
    pub(super) problem: Problem,
    /// The best search so far.
    pub(super) best: Option<Search>,
    /// Whether the best search has come to its end.
    pub(super) converged: bool,
    pub(super) bounds: Vec<(f64, f64)>,
    /// By number of the search: whether equations of motion themselves depend on it, not only how they begin.
    pub(super) moving: Vec<bool>,
    pub(super) own: Vec<f64>,
    pub(super) estimates: Vec<Option<Estimate>>,
    /// What is still to be tried, the last one first.
    pub(super) stages: Vec<Stage>,
    pub(super) current: Option<Current>,
    /// How smooth the sum of squares is.
    pub(super) texture: Texture,
    /// Starts around the best answer.
    pub(super) elsewhere: Option<Elsewhere>,
    /// How many of them have been tried.
    pub(super) tried_elsewhere: usize,
    /// From how many starts was searched.
    pub(super) starts: usize,
    /// Where the searches from these have ended, and how high.
    pub(super) ends: Vec<(Vec<f64>, f64)>,
    /// Another minimum that fits as well.
    pub(super) rival: Option<Rival>,
    /// How often a profile has met a lower sum of squares.
    pub(super) improved: usize,
    /// The weighted sum of squares about the mean of each observation.
    pub(super) total: f64,
    /// In how many directions the curve does not change at the own values.
    flat: usize,
    /// Which of [`curve::TOLERANCES`] holds for equations of motion.
    precision: usize,
    /// Whether all starts have been tried, and the best one is gone on with.
    refined: bool,
    weighings: usize,
    pub(super) reweighting: Reweighting,
    trials: usize,
    pub(super) finished: bool,
}

impl Fit {
    /// The part of the sum of squares that may be left to gain, for formulas.
    const TOLERANCE: f64 = 1e-18;
    /// The same for equations of motion, whose solutions carry the error of the integration: with each of the tolerances of the
    /// curve.
    const TOLERANCES_OF_MOTION: [f64; curve::TOLERANCES.len()] = [1e-8, 1e-10, 1e-12];
    /// Trials of one search.
    pub(super) const TRIALS: usize = 400;
    /// A direction in which the curve changes by less than this part of the greatest change is no direction to search in.
    const FLAT: f64 = 1e-8;
    /// A later start wins only if it lowers the sum of squares by more than this part.
    const BETTER: f64 = 1e-6;
    /// What explains this part of the scatter is not searched further.
    const EXPLAINED: f64 = 0.9;
    /// How often several observations are weighted again by their own scatter, at most.
    const WEIGHINGS: usize = 12;

    /// Checks a task and begins.
    ///
    /// # Errors
    /// Nothing varied or measured, too little or too much of it, a model that cannot be treated.
    pub fn new(model: &Model, task: Task) -> Result<Self, FitError> {
        let mut fit = Self::prepared(model, task)?;
        let own = fit.search(&fit.own.clone(), &fit.problem.plans.clone(), Self::TRIALS);
        fit.flat = flat(&own);
        let explains = own.sum < fit.total || fit.estimates.iter().all(Option::is_none);
        let own = Stage::Own(Box::new(own));
        fit.stages = match (explains, fit.problem.curve.has_states()) {
            (true, _) => vec![Stage::Spread, Stage::Windows, Stage::Estimated, own],
            (false, true) => vec![Stage::Spread, own, Stage::Windows],
            (false, false) => vec![Stage::Spread, Stage::Windows, own, Stage::Estimated],
        };
        fit.begin();
        Ok(fit)
    }

    /// Makes a fit again of which the answer is known: `found` are the values of [`Outcome::parameters`], in their order.
    /// The search goes on from there and from nowhere else. Where they are not as many as the task asks for, nothing is
    /// known, and it begins as [`Fit::new`] does.
    ///
    /// # Errors
    /// As for [`Fit::new`].
    pub fn again(model: &Model, task: Task, found: &[f64]) -> Result<Self, FitError> {
        let mut fit = Self::prepared(model, task)?;
        if found.len() != fit.own.len() {
            return Self::new(model, fit.problem.task);
        }
        found.clone_into(&mut fit.own);
        fit.refined = true;
        fit.starts = 1;
        fit.integrate_to(curve::TOLERANCES.len() - 1);
        let search = fit.search(found, &fit.problem.plans.clone(), Self::TRIALS);
        fit.search_whole(search);
        Ok(fit)
    }

    /// Ready to begin.
    fn prepared(model: &Model, task: Task) -> Result<Self, FitError> {
        let mut problem = Problem::new(model, task)?;
        problem.weigh(&problem.spread());
        Ok(Self {
            model: curve::bare(model),
            bounds: bounds(model, &problem),
            moving: moving(model, &problem),
            texture: elsewhere::texture(model, &problem),
            own: problem.own_start(),
            estimates: start::estimates(&problem),
            total: problem.spread_sum(),
            problem,
            best: None,
            converged: false,
            stages: Vec::new(),
            current: None,
            elsewhere: None,
            tried_elsewhere: 0,
            starts: 0,
            ends: Vec::new(),
            rival: None,
            improved: 0,
            flat: 0,
            precision: 0,
            refined: false,
            weighings: 0,
            reweighting: Reweighting::default(),
            trials: 0,
            finished: false,
        })
    }

    /// Makes one trial; whether the fit is finished.
    pub fn advance(&mut self) -> bool {
        if self.finished {
            return true;
        }
        let Some(mut current) = self.current.take() else {
            self.begin();
            return self.finished;
        };
        self.trials += 1;
        let status = current.search.advance(&mut Window { problem: &mut self.problem, plans: &current.plans });
        if status == Status::Searching {
            self.current = Some(current);
            return false;
        }
        match current.windows.pop() {
            Some(window) => self.current = Some(self.window(&current.search.x, window, current.windows)),
            None => self.settle(current.search),
        }
        self.finished
    }

    /// Goes on to the end.
    pub fn complete(&mut self) {
        while !self.advance() {}
    }

    /// How many trials were made: each computes the model's curve once for all records.
    pub fn trials(&self) -> usize {
        self.trials
    }

    /// The coefficient of determination of the best found so far, 1 where nothing is left unexplained.
    pub fn explained(&self) -> f64 {
        match (&self.best, &self.reweighting.least_squares) {
            // The sum that a robust loss lowers is another one.
            (Some(_), Some((_, explained))) => *explained,
            (Some(best), None) => 1.0 - best.sum / self.total,
            (None, _) => 0.0,
        }
    }

    /// What is known when the fit is finished; before that, of the best found so far. `None` if nothing was found: the
    /// model has no finite curve at any start.
    pub fn outcome(&mut self) -> Option<Outcome> {
        outcome::outcome(self)
    }

    /// What is known of the uncertainties at the end of a search of the whole.
    pub(super) fn covariance(&mut self, best: &Search) -> Covariance {
        let best = self.linearised(best);
        let Problem { plans, task, .. } = &self.problem;
        let errors_given = task.errors_given() && task.loss == Loss::Squares;
        Covariance::new(&best, plans, self.problem.independent_values(), errors_given)
    }

    /// A search over `plans`, from `start`.
    pub(super) fn search(&mut self, start: &[f64], plans: &[Plan], limit: usize) -> Search {
        let rows = plans.iter().map(|plan| plan.points.len()).sum();
        // Weights that follow the residuals are settled in many rounds, none of which needs the last digits.
        let precision = if self.reweighting.least_squares.is_some() { 0 } else { self.precision };
        let tolerance = match self.problem.curve.has_states() {
            true => Self::TOLERANCES_OF_MOTION[precision],
            false => Self::TOLERANCE,
        };
        let mut window = Window { problem: &mut self.problem, plans };
        Search::new(&mut window, start, self.bounds.clone(), rows, tolerance, limit)
    }

    /// How well these numbers fit, what is linear being at its best values.
    pub(super) fn look(&mut self, start: &[f64], plans: &[Plan]) -> Search {
        let mut search = self.search(start, plans, 1);
        search.set_linear(&mut Window { problem: &mut self.problem, plans });
        search
    }

    /// A search over `plans` in which one number is held where it is; `None` if it lies outside its bounds.
    pub(super) fn search_holding(&mut self, start: &[f64], plans: &[Plan], held: usize) -> Option<Search> {
        let (low, high) = self.bounds[held];
        if !(start[held] >= low && start[held] <= high) {
            return None;
        }
        self.bounds[held] = (start[held], start[held]);
        let search = self.search(start, plans, Self::TRIALS);
        self.bounds[held] = (low, high);
        Some(search)
    }

    /// Whether no other start is needed: much is explained by a search that came to its end in a place as definite as where it
    /// began. Where terms have become one, or a number has run away to the end of its range, it is in none.
    pub(super) fn is_enough(&self) -> bool {
        let definite =
            |best: &Search| flat(best) <= self.flat && (0..best.x.len()).all(|column| !best.at_bound(column));
        self.converged && self.explained() >= Self::EXPLAINED && self.best.as_ref().is_some_and(definite)
    }

    /// Goes on with a search of the whole fitted part.
    pub(super) fn search_whole(&mut self, search: Search) {
        self.current = Some(Current { search, plans: self.problem.plans.clone(), windows: Vec::new() });
    }

    /// Goes to another answer than the one found, at which the sum of squares is lower, and on to the end of the search.
    pub(super) fn go_to(&mut self, x: &[f64]) {
        self.improved += 1;
        self.finished = false;
        let search = self.search(x, &self.problem.plans.clone(), Self::TRIALS);
        self.search_whole(search);
        self.complete();
    }

    /// Takes in a search over the whole that has ended.
    fn settle(&mut self, search: Search) {
        if !self.refined {
            self.remember_end(&search);
        }
        let better = match &self.best {
            // Refined or weighted again, sums of squares cannot be compared; what is searched then goes on from the best.
            Some(_) if self.refined => search.sum.is_finite(),
            Some(best) => search.sum < best.sum * (1.0 - Self::BETTER),
            None => search.sum.is_finite(),
        };
        if better {
            self.converged = search.status == Status::Converged;
            self.best = Some(search);
        }
        if self.refined {
            self.conclude();
        }
    }

    /// Goes on from the best found so far, or ends.
    pub(super) fn conclude(&mut self) {
        let best = self.best.take();
        let start = best.as_ref().and_then(|best| self.continuation(best));
        self.best = best;
        let Some(start) = start else {
            self.finished = true;
            return;
        };
        let search = self.search(&start, &self.problem.plans.clone(), Self::TRIALS);
        self.search_whole(search);
    }

    fn integrate_to(&mut self, precision: usize) {
        self.precision = precision;
        self.problem.curve.set_tolerance(curve::TOLERANCES[precision]);
    }

    /// Where to search once more: from the best itself where equations are now integrated more exactly, or several
    /// observations weighted again by their own scatter, until that no longer changes; or from its like among those that fit
    /// as well.
    fn continuation(&mut self, best: &Search) -> Option<Vec<f64>> {
        let first = !std::mem::replace(&mut self.refined, true);
        if self.problem.curve.has_states() {
            if self.precision + 1 < curve::TOLERANCES.len() {
                self.integrate_to(self.precision + 1);
                return Some(best.x.clone());
            }
        } else if first && let Some(like) = symmetry::like_start(self, best, &self.own.clone()) {
            return Some(like);
        }
        let least_squares = self.reweighting.least_squares.is_none();
        if least_squares && self.weighings < Self::WEIGHINGS && self.problem.reweigh(&best.residuals) {
            self.weighings += 1;
            self.total = self.problem.spread_sum();
            return Some(best.x.clone());
        }
        self.reweigh_by_loss(best)
    }
}

/// In how many directions the curve does not change where a search is.
fn flat(search: &Search) -> usize {
    let scale: Vec<f64> = (0..search.x.len()).map(|column| norm(search.jacobian.column(column))).collect();
    let moving: Vec<usize> = (0..scale.len()).filter(|&column| scale[column] > 0.0).collect();
    let decomposition = Decomposition::new(&search.jacobian, &moving, &scale, &search.residuals);
    let least = Fit::FLAT * decomposition.greatest();
    scale.len() - decomposition.singular.iter().filter(|value| **value > least).count()
}

/// Whether equations of motion, their events or the observed expressions depend on a parameter in another way than through
/// initial values and scales; for formulas, never.
fn moving(model: &Model, problem: &Problem) -> Vec<bool> {
    let mut parameters = Vec::new();
    for node in
        model.states.iter().map(|state| state.derivative).chain(model.events.iter().map(|event| event.condition))
    {
        parameters.extend(model.depends(node).parameters);
    }
    let moves = |target| matches!(target, Target::Parameter(index) if parameters.contains(&(index as u32)));
    problem.columns.iter().map(|column| moves(column.target)).collect()
}

/// The bounds of each number of the search: given, else the parameter's own range, else none.
fn bounds(model: &Model, problem: &Problem) -> Vec<(f64, f64)> {
    let free = (f64::NEG_INFINITY, f64::INFINITY);
    problem
        .columns
        .iter()
        .map(|column| {
            let own = match column.target {
                Target::Parameter(index) => model.parameters.get(index).and_then(|parameter| parameter.range),
                Target::Origin | Target::Offset(_) => None,
            };
            problem.task.varied[column.varied].bounds.or(own).unwrap_or(free)
        })
        .collect()
}
