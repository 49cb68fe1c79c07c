//! Who computes fits: what is handed over, and what comes back. A desk keeps the state, its workers compute.

use analysis::fit::{Fit, Outcome, Task, Trace};
use engine::{Compiled, Listing};
use program::Model;
use serde::{Deserialize, Serialize};
use std::rc::Rc;

/// Number of points of a fitted curve in a report.
const POINTS_OF_A_CURVE: usize = 600;

/// Computes fits for a desk, here or elsewhere.
pub trait Workers {
    /// Number of fits that are computed at the same time, at least 1.
    fn count(&self) -> usize;

    /// Accepts a fit and returns its number, which no other fit of these workers has.
    fn begin(&mut self, work: FitWork) -> u32;

    /// News since the last call, in the order of time, with the numbers of the fits. Workers that compute
    /// here make one trial in each call.
    fn news(&mut self) -> Vec<(u32, FitNews)>;

    /// Ends all fits whose numbers are not wanted.
    fn keep(&mut self, wanted: &[u32]);
}

/// A fit to be computed, with all that it needs.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct FitWork {
    model: Model,
    task: Task,
    /// Values of an earlier result from which the fit is reconstructed, SI; `None` for a new fit.
    known: Option<Vec<f64>>,
}

impl FitWork {
    /// Work of a task that the model can be fitted to. `known`: its answer, SI, one number per varied one.
    pub(crate) fn new(model: Model, task: Task, known: Option<Vec<f64>>) -> Self {
        Self { model, task, known }
    }

    /// Begins to compute.
    pub fn start(self) -> FitComputation {
        let fit = match self.known {
            Some(values) => Fit::again(&self.model, self.task, &values),
            None => Fit::new(&self.model, self.task),
        };
        FitComputation { fit: fit.ok() }
    }
}

/// A fit that is being computed.
#[derive(Debug)]
pub struct FitComputation {
    /// `None` if the task cannot be fitted.
    fit: Option<Fit>,
}

impl FitComputation {
    /// Makes the steps of the equations of motion in compiled code, if `compile` makes it from their listing. The result has
    /// the same bits.
    pub fn compile(&mut self, compile: impl FnOnce(Listing) -> Option<Rc<dyn Compiled>>) {
        if let Some(fit) = &mut self.fit {
            fit.compile(compile);
        }
    }

    /// Makes one trial.
    pub fn advance(&mut self) -> FitNews {
        let Some(fit) = &mut self.fit else { return FitNews::Found(Err(NothingFound::NoCurve)) };
        if fit.advance() {
            let outcome = fit.outcome();
            let nothing = if fit.gave_up() { NothingFound::TooManySteps } else { NothingFound::NoCurve };
            let finding = |outcome| Box::new(Finding { outcome, traces: fit.traces(POINTS_OF_A_CURVE) });
            return FitNews::Found(outcome.map(finding).ok_or(nothing));
        }
        FitNews::Trial { trials: fit.trials(), explained: fit.explained() }
    }
}

/// Report of a worker about a fit.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub enum FitNews {
    /// It goes on.
    Trial {
        /// Number of curves computed so far.
        trials: usize,
        /// Coefficient of determination of the best of them.
        explained: f64,
    },
    /// The worker has ended; the fit is handed out again.
    Lost,
    /// It is finished.
    Found(Result<Box<Finding>, NothingFound>),
}

/// Reason why a fit has found nothing.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum NothingFound {
    /// The model has no finite curve at any start.
    NoCurve,
    /// Wherever it was tried, the model needs more computation than a trial may take.
    TooManySteps,
}

/// Result of a fit.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Finding {
    /// Values, errors and statistics.
    pub(crate) outcome: Outcome,
    /// Fitted curves.
    pub(crate) traces: Vec<Trace>,
}

/// Workers that compute here, one fit after the other and one trial at a time.
#[derive(Debug, Default)]
pub struct InProcess {
    current: Option<(u32, FitComputation)>,
    issued: u32,
}

impl InProcess {
    /// Workers that number their fits from `issued + 1` on.
    pub fn after(issued: u32) -> Self {
        Self { current: None, issued }
    }
}

impl Workers for InProcess {
    fn count(&self) -> usize {
        1
    }

    fn begin(&mut self, work: FitWork) -> u32 {
        self.issued += 1;
        self.current = Some((self.issued, work.start()));
        self.issued
    }

    fn news(&mut self) -> Vec<(u32, FitNews)> {
        let Some((number, computation)) = &mut self.current else { return Vec::new() };
        let news = (*number, computation.advance());
        if matches!(news.1, FitNews::Found(_)) {
            self.current = None;
        }
        vec![news]
    }

    fn keep(&mut self, wanted: &[u32]) {
        self.current = self.current.take().filter(|(number, _)| wanted.contains(number));
    }
}
