//! Loop of a fit: successive searches for the least sum of squares of a [`Problem`], each a [`Search`].

use super::lanes::Lanes;
use super::outcome::{self, Course, Outcome};
use super::search::elsewhere::{Beginning, Elsewhere};
use super::search::loss::Loss;
use super::search::moves;
use super::search::moves::Moves;
use super::search::problem::Problem;
use super::search::refine::Refinement;
use super::search::robust::Continuation;
use super::search::stages;
use super::search::stages::{Current, Stages};
use super::search::window;
use super::search::window::{TRIALS, Window};
use super::search::{Search, Status};
use super::task::{FitError, Task};
use super::trace::{self, Trace};
use super::uncertainty::covariance::Covariance;
use super::uncertainty::exchange::Exchange;
use engine::{Compiled, Listing, Setup};
use program::{Model, NodeId};
use std::cell::RefCell;
use std::rc::Rc;

/// Fit that advances one trial at a time.
///
/// It searches from the given starts or the parameters' own values, then from the frequency and damping estimated from the
/// data, then in windows that grow from the beginning of the record, then from starts spread over the ranges. Further
/// starts are tried only while the best one leaves much unexplained or is not definite. Own values that explain nothing come after the
/// estimate. For a model with events or branches, starts around the best answer are tried at the end.
#[derive(Clone, Debug)]
pub struct Fit {
    /// Task and model, prepared for the search.
    problem: Problem,
    /// Current search.
    current: Option<Current>,
    /// Best search so far.
    best: Option<Search>,
    /// Remaining stages, each with a start.
    stages: Stages,
    /// Searches away from the best answer, after the stages.
    moves: Moves,
    /// True while one of its short searches runs.
    moving: bool,
    /// Searches around the best answer, after the moves.
    elsewhere: Elsewhere,
    /// Refinement from the best answer itself, at the end.
    refinement: Refinement,
    /// Test for pairs of numbers that can exchange their values; `None` until the answer is found.
    exchange: Option<Exchange>,
    /// Progress so far.
    course: Course,
    trials: usize,
}

impl Fit {
    /// Least relative decrease of the sum of squares by which a later start replaces the best one.
    const BETTER: f64 = 1e-6;
    /// Coefficient of determination from which on no further start is tried.
    const EXPLAINED: f64 = 0.9;

    /// Checks a task and starts its fit.
    ///
    /// # Errors
    /// Errors for nothing varied or measured, too few or too many values, or a model that cannot be fitted.
    pub fn new(model: &Model, task: Task) -> Result<Self, FitError> {
        Problem::new(model, task).map(Self::from_own_values)
    }

    /// Checks a task without a fit.
    ///
    /// # Errors
    /// As for [`Fit::new`].
    pub fn check(model: &Model, task: &Task) -> Result<(), FitError> {
        Problem::new(model, task.clone()).map(drop)
    }

    /// Resumes a fit from its known answer: `found` are the values of [`Outcome::parameters`], in their order, SI. No other
    /// start is searched. If their number differs from that of the task, the fit starts as in [`Fit::new`].
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
        let moves = Moves::default();
        let moving = false;
        Self {
            problem,
            current: None,
            best: None,
            stages,
            moves,
            moving,
            elsewhere,
            refinement,
            exchange: None,
            course,
            trials: 0,
        }
    }

    /// Makes one trial. Returns true if the fit is finished.
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

    /// Runs the fit to its end.
    pub fn complete(&mut self) {
        while !self.advance() {}
    }

    /// Number of trials made; each computes the curve of the model once for all records.
    pub fn trials(&self) -> usize {
        self.trials
    }

    /// Makes the steps of the equations of motion in compiled code from now on, if `compile` makes it from their listing. The
    /// result has the same bits.
    pub fn compile(&mut self, compile: impl FnOnce(Listing) -> Option<Rc<dyn Compiled>>) {
        self.problem.curve.compile(compile);
    }

    /// Solves equations of motion for several records and searches side by side from now on, if `make` makes a solver for a model, the
    /// setup of its runs and what is read at each time. The result has the same bits.
    pub fn use_lanes(&mut self, make: impl FnOnce(&Model, &Setup, &[NodeId]) -> Option<Rc<RefCell<dyn Lanes>>>) {
        self.problem.curve.use_lanes(make);
    }

    /// True if trials were given up because they needed more computation than a trial may take.
    pub fn gave_up(&self) -> bool {
        self.problem.curve.gave_up()
    }

    /// Coefficient of determination of the best search so far, 1 where nothing is left unexplained; 0 before there is one.
    pub fn explained(&self) -> f64 {
        match (&self.best, self.refinement.reweighting().least_squares()) {
            // The sum minimised by a robust loss is not comparable.
            (Some(_), Some((_, explained))) => *explained,
            (Some(best), None) => 1.0 - best.sum / self.problem.total,
            (None, _) => 0.0,
        }
    }

    /// Result of a finished fit, or that of the best search so far. `None` if there is none: the model has no finite curve
    /// at any start.
    pub fn outcome(&mut self) -> Option<Outcome> {
        let best = self.best.as_ref()?;
        Some(outcome::outcome(&mut self.problem, best, self.refinement.reweighting(), &self.course))
    }

    /// Curves of all observations by record, each of `count` points, at least 2. Empty if nothing was found.
    pub fn traces(&mut self, count: usize) -> Vec<Trace> {
        let covariance = self.covariance();
        match (&self.best, covariance) {
            (Some(best), Some(covariance)) => trace::traces(&mut self.problem, best, &covariance, count),
            _ => Vec::new(),
        }
    }

    /// Covariance at the best search so far.
    pub(super) fn covariance(&mut self) -> Option<Covariance> {
        let best = self.best.as_ref()?;
        Some(self.refinement.reweighting().covariance(&mut self.problem, best))
    }

    /// Problem and best search so far.
    pub(super) fn answer(&mut self) -> Option<(&mut Problem, &Search)> {
        Some((&mut self.problem, self.best.as_ref()?))
    }

    /// Number of restarts from a better answer; see [`Outcome::improved`].
    pub(super) fn improved(&self) -> usize {
        self.course.improved
    }

    /// Restarts from `x` (the varied numbers and the scales, SI), an answer with a lower sum of squares, and runs to the end.
    pub(super) fn go_to(&mut self, x: &[f64]) {
        self.course.improved += 1;
        self.course.finished = false;
        self.search_from(x);
        self.complete();
    }

    /// Begins the next stage. After the last stage, or if no other start is needed, begins the next search around the best
    /// answer.
    fn begin(&mut self) {
        if self.is_enough() {
            // Events make more kinks in the whole record than in its beginning.
            self.stages.skip(self.elsewhere.has_events());
        }
        if self.stages.is_empty() {
            self.move_away();
        } else {
            self.current = self.stages.next(&mut self.problem);
            self.course.starts += usize::from(self.current.is_some());
        }
    }

    /// True if no other start is needed: the best search converged, explains enough and its answer is definite.
    fn is_enough(&self) -> bool {
        let definite = |best: &Search| self.stages.is_definite(best, self.elsewhere.is_confirmed(best));
        self.course.converged && self.explained() >= Self::EXPLAINED && self.best.as_ref().is_some_and(definite)
    }

    /// Begins the next search away from the best answer; after the last one, the searches around it.
    fn move_away(&mut self) {
        let problem = &mut self.problem;
        let Some((start, short)) = self.best.as_ref().and_then(|best| self.moves.next(problem, best)) else {
            return self.try_elsewhere();
        };
        self.course.starts += usize::from(short);
        self.moving = short;
        let search = window::search(problem, &start, if short { Moves::SHORT } else { TRIALS });
        self.current = Some(Current::whole(problem, search, false));
    }

    /// Begins the next search around the best answer; after the last one, refines the best answer.
    fn try_elsewhere(&mut self) {
        let best = self.best.as_ref();
        if let Some(Beginning { search, held }) = best.and_then(|best| self.elsewhere.next(&mut self.problem, best)) {
            self.course.starts += 1;
            self.current = Some(Current::whole(&self.problem, search, held));
        } else {
            // With a robust loss, sums of squares cannot be compared.
            let plain = best.filter(|_| self.problem.task.loss == Loss::Squares);
            self.course.rival = plain.and_then(|best| self.elsewhere.rival(&self.problem, best));
            self.conclude();
        }
    }

    /// Tests the next pair of numbers for an exchange of their values, or ends the fit.
    fn try_exchange(&mut self) {
        let Some(best) = &self.best else {
            self.course.finished = true;
            return;
        };
        let problem = &mut self.problem;
        let exchange = self.exchange.get_or_insert_with(|| Exchange::new(problem, &stages::moving(problem)));
        // With a robust loss, sums of squares cannot be compared.
        let plain = problem.task.loss == Loss::Squares;
        if let Some(search) = plain.then(|| exchange.next(problem, best)).flatten() {
            self.current = Some(Current::whole(problem, search, false));
            return;
        }
        self.course.exchanges = std::mem::take(&mut exchange.found);
        self.course.unexplained = if plain { moves::unexplained(problem, best) } else { None };
        self.exchange = None;
        self.course.finished = true;
    }

    /// Begins a search over the whole fitted part.
    fn search_from(&mut self, start: &[f64]) {
        let search = window::search(&mut self.problem, start, TRIALS);
        self.current = Some(Current::whole(&self.problem, search, false));
    }

    /// Takes the result of a search over the whole fitted part.
    fn settle(&mut self, mut search: Search) {
        if !self.problem.turn_phases_inside(&mut search.x) {
            let plans = self.problem.plans.clone();
            let bounds = self.problem.bounds.clone();
            let search = Window { problem: &mut self.problem, plans: &plans }.search_within(&search.x, bounds, TRIALS);
            self.current = Some(Current::whole(&self.problem, search, false));
            return;
        }
        if let (Some(exchange), Some(best)) = (&mut self.exchange, &self.best) {
            exchange.settle(&self.problem, best, &search);
            return self.try_exchange();
        }
        let short = std::mem::take(&mut self.moving);
        if short {
            self.moves.remember(&search);
        }
        let refining = self.refinement.has_begun();
        if !refining && (!short || search.status == Status::Converged) {
            self.elsewhere.remember_end(&search, self.best.as_ref());
        }
        let better = match &self.best {
            // After refinement or reweighting, sums of squares cannot be compared; the refined search replaces the best
            // one.
            Some(_) if refining => search.sum.is_finite(),
            Some(best) if search.status == Status::Converged && !self.course.converged => {
                search.sum <= best.sum * (1.0 + Self::BETTER)
            }
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

    /// Begins the next refinement of the best search, or ends.
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
