//! A fit: a loop over what is asked, the [`Problem`], and the [`Search`] for the least sum of squares that goes on.

use super::outcome::{self, Course, Outcome};
use super::search::elsewhere::{Beginning, Elsewhere};
use super::search::loss::Loss;
use super::search::problem::Problem;
use super::search::refine::Refinement;
use super::search::robust::Continuation;
use super::search::stages;
use super::search::stages::{Current, Stages};
use super::search::window;
use super::search::window::TRIALS;
use super::search::{Search, Status};
use super::task::{FitError, Task};
use super::trace::{self, Trace};
use super::uncertainty::covariance::Covariance;
use super::uncertainty::exchange::Exchange;
use program::Model;

/// A fit that goes on one trial at a time.
///
/// It searches from the given or the parameters' own values, then from the frequency and the damping that the data show,
/// then along windows that grow from the beginning of the record, then from starts spread over the ranges. Further starts
/// are only tried while the best one leaves much unexplained; own values that explain nothing come after the estimate. Of a
/// model with events or branches the best answer is then tried from starts around it.
#[derive(Clone, Debug)]
pub struct Fit {
    /// What is asked, and how it is computed.
    problem: Problem,
    /// The search that goes on.
    current: Option<Current>,
    /// The best search so far.
    best: Option<Search>,
    /// From where is still to be searched.
    stages: Stages,
    /// Then around the best answer.
    elsewhere: Elsewhere,
    /// In the end from the best answer itself.
    refinement: Refinement,
    /// Which numbers can exchange their values, once the answer is known.
    exchange: Option<Exchange>,
    /// How the fit went so far.
    course: Course,
    trials: usize,
}

impl Fit {
    /// A later start wins only if it lowers the sum of squares by more than this part.
    const BETTER: f64 = 1e-6;
    /// What explains this part of the scatter is not searched further.
    const EXPLAINED: f64 = 0.9;

    /// Checks a task and begins.
    ///
    /// # Errors
    /// Nothing varied or measured, too little or too much of it, a model that cannot be treated.
    pub fn new(model: &Model, task: Task) -> Result<Self, FitError> {
        Problem::new(model, task).map(Self::from_own_values)
    }

    /// Makes a fit again of which the answer is known: `found` are the values of [`Outcome::parameters`], in their order.
    /// The search goes on from there and from nowhere else. Where they are not as many as the task asks for, nothing is
    /// known, and it begins as [`Fit::new`] does.
    ///
    /// # Errors
    /// As for [`Fit::new`].
    pub fn again(model: &Model, task: Task, found: &[f64]) -> Result<Self, FitError> {
        let mut problem = Problem::new(model, task)?;
        if found.len() + problem.scales() != problem.own.len() {
            return Ok(Self::from_own_values(problem));
        }
        let scales = problem.own[found.len()..].to_vec();
        let refinement = Refinement::of_known(&mut problem);
        let mut fit = Self::with(problem, Stages::default(), refinement);
        fit.search_from(&[found, &scales].concat());
        fit.course.starts = 1;
        Ok(fit)
    }

    fn from_own_values(mut problem: Problem) -> Self {
        let stages = Stages::new(&mut problem);
        let mut fit = Self::with(problem, stages, Refinement::default());
        fit.begin();
        fit
    }

    fn with(problem: Problem, stages: Stages, refinement: Refinement) -> Self {
        let elsewhere = Elsewhere::new(&problem);
        let course = Course::default();
        Self { problem, current: None, best: None, stages, elsewhere, refinement, exchange: None, course, trials: 0 }
    }

    /// Makes one trial; whether the fit is finished.
    pub fn advance(&mut self) -> bool {
        if self.course.finished {
            return true;
        }
        let Some(mut current) = self.current.take() else {
            self.begin();
            return self.course.finished;
        };
        self.trials += 1;
        if current.advance(&mut self.problem) == Status::Searching {
            self.current = Some(current);
            return false;
        }
        match current.windows.pop() {
            _ if std::mem::take(&mut current.held) => {
                let search = self.elsewhere.release(&mut self.problem, &current.search);
                self.current = Some(Current::whole(&self.problem, search, false));
            }
            Some(window) => {
                let (from, later) = (&current.search.x, current.windows);
                self.current = Some(self.stages.window(&mut self.problem, from, window, later));
            }
            None => self.settle(current.search),
        }
        self.course.finished
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
        match (&self.best, self.refinement.reweighting().least_squares()) {
            // The sum that a robust loss lowers is another one.
            (Some(_), Some((_, explained))) => *explained,
            (Some(best), None) => 1.0 - best.sum / self.problem.total,
            (None, _) => 0.0,
        }
    }

    /// What is known when the fit is finished; before that, of the best found so far. `None` if nothing was found: the
    /// model has no finite curve at any start.
    pub fn outcome(&mut self) -> Option<Outcome> {
        let best = self.best.as_ref()?;
        Some(outcome::outcome(&mut self.problem, best, self.refinement.reweighting(), &self.course))
    }

    /// The curves of a finished fit, each of `count` points (at least 2): those of all observations, by record. Empty if
    /// nothing was found.
    pub fn traces(&mut self, count: usize) -> Vec<Trace> {
        let covariance = self.covariance();
        match (&self.best, covariance) {
            (Some(best), Some(covariance)) => trace::traces(&mut self.problem, best, &covariance, count),
            _ => Vec::new(),
        }
    }

    /// What is known of the uncertainties of the best found so far.
    pub(super) fn covariance(&mut self) -> Option<Covariance> {
        let best = self.best.as_ref()?;
        Some(self.refinement.reweighting().covariance(&mut self.problem, best))
    }

    /// What is asked, and the best found so far.
    pub(super) fn answer(&mut self) -> Option<(&mut Problem, &Search)> {
        Some((&mut self.problem, self.best.as_ref()?))
    }

    /// How often it was gone to another answer than the one found.
    pub(super) fn improved(&self) -> usize {
        self.course.improved
    }

    /// Goes to another answer than the one found, at which the sum of squares is lower, and on to the end of the search.
    pub(super) fn go_to(&mut self, x: &[f64]) {
        self.course.improved += 1;
        self.course.finished = false;
        self.search_from(x);
        self.complete();
    }

    /// Begins the next stage; after the last one, or where no other start is needed, the next search around the best answer.
    fn begin(&mut self) {
        if self.is_enough() {
            // Where there are events, the beginning of a record has fewer kinks than the whole.
            self.stages.skip(self.elsewhere.has_events());
        }
        if self.stages.is_empty() {
            self.try_elsewhere();
        } else {
            self.current = self.stages.next(&mut self.problem);
            self.course.starts += usize::from(self.current.is_some());
        }
    }

    /// Whether no other start is needed: much is explained by a search that came to its end in a definite place.
    fn is_enough(&self) -> bool {
        let definite = |best: &Search| self.stages.is_definite(best);
        self.course.converged && self.explained() >= Self::EXPLAINED && self.best.as_ref().is_some_and(definite)
    }

    /// Begins the next search from elsewhere; after the last one the best answer is gone on with.
    fn try_elsewhere(&mut self) {
        let best = self.best.as_ref();
        if let Some(Beginning { search, held }) = best.and_then(|best| self.elsewhere.next(&mut self.problem, best)) {
            self.course.starts += 1;
            self.current = Some(Current::whole(&self.problem, search, held));
        } else {
            // A robust loss weighs sums of squares in another way.
            let plain = best.filter(|_| self.problem.task.loss == Loss::Squares);
            self.course.rival = plain.and_then(|best| self.elsewhere.rival(&self.problem, best));
            self.conclude();
        }
    }

    /// Tries whether the next pair of numbers can exchange their values, or ends.
    fn try_exchange(&mut self) {
        let Some(best) = &self.best else {
            self.course.finished = true;
            return;
        };
        let problem = &mut self.problem;
        let exchange = self.exchange.get_or_insert_with(|| Exchange::new(problem, &stages::moving(problem)));
        // A robust loss weighs sums of squares in another way.
        let plain = problem.task.loss == Loss::Squares;
        if let Some(search) = plain.then(|| exchange.next(problem, best)).flatten() {
            self.current = Some(Current::whole(problem, search, false));
            return;
        }
        self.course.exchanges = std::mem::take(&mut exchange.found);
        self.exchange = None;
        self.course.finished = true;
    }

    /// Begins a search of the whole fitted part.
    fn search_from(&mut self, start: &[f64]) {
        let search = window::search(&mut self.problem, start, TRIALS);
        self.current = Some(Current::whole(&self.problem, search, false));
    }

    /// Takes in a search over the whole that has ended.
    fn settle(&mut self, search: Search) {
        if let (Some(exchange), Some(best)) = (&mut self.exchange, &self.best) {
            exchange.settle(&self.problem, best, &search);
            return self.try_exchange();
        }
        let refining = self.refinement.has_begun();
        if !refining {
            self.elsewhere.remember_end(&search, self.best.as_ref());
        }
        let better = match &self.best {
            // Refined or weighted again, sums of squares cannot be compared; what is searched then goes on from the best.
            Some(_) if refining => search.sum.is_finite(),
            Some(best) => search.sum < best.sum * (1.0 - Self::BETTER),
            None => search.sum.is_finite(),
        };
        if better {
            self.course.converged = search.status == Status::Converged;
            self.best = Some(search);
        }
        if refining {
            self.conclude();
        }
    }

    /// Goes on from the best found so far, or ends.
    fn conclude(&mut self) {
        match self.best.as_ref().map(|best| self.refinement.next(&mut self.problem, best)) {
            Some(Continuation::From(start)) => self.search_from(&start),
            Some(Continuation::End { settled }) => {
                self.course.converged &= settled;
                self.try_exchange();
            }
            None => self.course.finished = true,
        }
    }
}
