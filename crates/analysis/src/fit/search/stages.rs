//! Sequence of the starts of a fit.

use super::problem::Problem;
use super::start;
use super::window::{self, TRIALS, Window};
use super::{Search, Status};
use crate::cycles::Estimate;
use crate::fit::linear::{Decomposition, norm};
use crate::fit::task::Target;
use crate::fit::task::plan::Plan;
use std::sync::Arc;
use units::order::sort_by;

/// Start of a search.
#[derive(Clone, Debug)]
enum Stage {
    /// Given starts or the parameters' own values, with a search ready to run.
    Own(Box<Search>),
    /// Frequency and damping estimated from the data.
    Estimated,
    /// Windows that grow from the beginning of the record.
    Windows,
    /// Starts spread over the ranges, still to be chosen.
    Spread,
    /// One of the spread starts.
    From(Vec<f64>),
}

/// Part of the records, from the beginning of each.
#[derive(Clone, Copy, Debug)]
pub(in crate::fit) struct Span {
    /// Duration, SI; infinite for the whole record.
    pub duration: f64,
    /// True if numbers that act on the motion itself are held, and only initial values and scales are searched.
    pub held: bool,
}

/// Search in progress.
#[derive(Clone, Debug)]
pub(in crate::fit) struct Current {
    /// The search.
    pub search: Search,
    /// Points that it fits.
    plans: Arc<Vec<Plan>>,
    /// Windows still to come, the last one first; if empty, the search covers the whole fitted part.
    pub windows: Vec<Span>,
    /// True if a number is held that is released when the search has ended.
    pub held: bool,
}

impl Current {
    /// Search over the whole fitted part; `held` is true if a number is held in it.
    pub fn whole(problem: &Problem, search: Search, held: bool) -> Self {
        Self { search, plans: problem.plans.clone(), windows: Vec::new(), held }
    }

    /// Makes one trial.
    pub fn advance(&mut self, problem: &mut Problem) -> Status {
        self.search.advance(&mut Window { problem, plans: &self.plans })
    }
}

/// Stages still to be tried.
#[derive(Clone, Debug, Default)]
pub(in crate::fit) struct Stages {
    /// Pending stages, the last one first.
    pending: Vec<Stage>,
    /// One per record: oscillation estimated from the data.
    estimates: Vec<Option<Estimate>>,
    /// One per column: true if the equations of motion depend on it, not only their initial values.
    moving: Vec<bool>,
    /// Number of directions without effect on the curve at the own values.
    flat: usize,
}

impl Stages {
    /// Number of windows in which only the beginning of a motion is searched.
    const HELD: usize = 2;
    /// Upper bound of the trials in a window that is not the whole.
    const WINDOW_TRIALS: usize = 15;
    /// Starts spread over the ranges, for equations of motion.
    const SPREAD: usize = 12;
    /// Upper bound of the trials from each of them: a search that needs more does not succeed.
    const SPREAD_TRIALS: usize = 40;
    /// Spread starts that are evaluated, for formulas.
    const SCREENED: usize = 240;
    /// Number of these from which a search is made.
    const CHOSEN: usize = 10;

    /// All stages: the own values first, unless they explain nothing while the data show an oscillation.
    pub fn new(problem: &mut Problem) -> Self {
        let estimates = start::estimates(problem);
        let own = window::search(problem, &problem.own.clone(), TRIALS);
        let flat = flat(&own);
        let explains = own.sum < problem.total || estimates.iter().all(Option::is_none);
        let own = Stage::Own(Box::new(own));
        let pending = match (explains, problem.curve.has_states()) {
            (true, _) => vec![Stage::Spread, Stage::Windows, Stage::Estimated, own],
            (false, true) => vec![Stage::Spread, own, Stage::Windows],
            (false, false) => vec![Stage::Spread, Stage::Windows, own, Stage::Estimated],
        };
        Self { pending, estimates, moving: moving(problem), flat }
    }

    /// True if nothing is left to be tried.
    pub fn is_empty(&self) -> bool {
        self.pending.is_empty()
    }

    /// Removes all stages, except the windows if these are `wanted`.
    pub fn skip(&mut self, wanted: bool) {
        self.pending.retain(|stage| wanted && matches!(stage, Stage::Windows));
    }

    /// True if the answer of a search is as definite as the own values. It is not if terms have become equal, or a number
    /// is at a bound of its range, unless the answer is `confirmed`: another start has led to it as well.
    pub fn is_definite(&self, search: &Search, confirmed: bool) -> bool {
        flat(search) <= self.flat && (confirmed || (0..search.x.len()).all(|column| !search.at_bound(column)))
    }

    /// Search of the next stage; `None` if it has none.
    pub fn next(&mut self, problem: &mut Problem) -> Option<Current> {
        let (start, limit) = match self.pending.pop()? {
            Stage::Own(search) => return Some(Current::whole(problem, *search, false)),
            Stage::From(start) if problem.curve.has_states() => (start, Self::SPREAD_TRIALS),
            Stage::From(start) => (start, TRIALS),
            Stage::Spread => {
                self.pending.extend(Self::spread(problem).into_iter().rev().map(Stage::From));
                return None;
            }
            Stage::Estimated => (start::from_estimates(problem, &self.estimates)?, TRIALS),
            Stage::Windows => {
                let mut windows = self.windows(problem);
                let first = windows.pop().filter(|first| first.duration.is_finite())?;
                let start = problem.own.clone();
                return Some(self.window(problem, &start, first, windows));
            }
        };
        let search = window::search(problem, &start, limit);
        Some(Current::whole(problem, search, false))
    }

    /// Search over a part of the records from `start` (SI, one number per column); `windows` follow it.
    pub fn window(&self, problem: &mut Problem, start: &[f64], span: Span, windows: Vec<Span>) -> Current {
        let plans = Arc::new(start::cut(&problem.plans, span.duration));
        let limit = if windows.is_empty() { TRIALS } else { Self::WINDOW_TRIALS };
        let mut bounds = problem.bounds.clone();
        if span.held {
            for (number, bounds) in bounds.iter_mut().enumerate().filter(|(number, _)| self.moving[*number]) {
                *bounds = (start[number], start[number]);
            }
        }
        let search = Window { problem, plans: &plans }.search_holding(start, bounds, limit);
        Current { search, plans, windows, held: false }
    }

    /// Windows of the records, the last one first. The motion is held in the first ones: while its initial values are
    /// wrong, its parameters would be changed to compensate.
    fn windows(&self, problem: &Problem) -> Vec<Span> {
        let held = if self.moving.contains(&false) { Self::HELD } else { 0 };
        let durations = start::windows(problem, &self.estimates);
        let spans = durations.into_iter().enumerate();
        spans.map(|(place, duration)| Span { duration, held: place < held && duration.is_finite() }).rev().collect()
    }

    /// Starts spread over the ranges. For a formula, many starts are evaluated and the best are chosen.
    fn spread(problem: &mut Problem) -> Vec<Vec<f64>> {
        // Film scales start at their priors.
        let numbers = problem.own.len() - problem.scales();
        let (own, scales) = problem.own.split_at(numbers);
        let start = |index| [start::spread(own, &problem.bounds, index), scales.to_vec()].concat();
        if problem.curve.has_states() {
            return (0..Self::SPREAD).map(start).collect();
        }
        let plans: Vec<Plan> = problem.plans.iter().map(start::thinned).collect();
        let points: usize = plans.iter().map(|plan| plan.points.len()).sum();
        // Fewer starts for more points, because this is done in a single trial.
        let count = (Self::SCREENED * start::ROWS / points.max(start::ROWS)).max(Self::CHOSEN);
        let candidates: Vec<Vec<f64>> = (0..count).map(start).collect();
        let mut window = Window { problem, plans: &plans };
        let mut looked: Vec<Search> = candidates.iter().map(|start| window.look(start)).collect();
        sort_by(&mut looked, |one, other| one.sum.total_cmp(&other.sum));
        looked.into_iter().filter(|one| one.sum.is_finite()).take(Self::CHOSEN).map(|one| one.x).collect()
    }
}

/// Directions in which the curve changes by less than this part of the greatest change are not searched.
const FLAT: f64 = 1e-8;

/// Number of directions without effect on the curve at the end of a search.
fn flat(search: &Search) -> usize {
    let scale: Vec<f64> = (0..search.x.len()).map(|column| norm(search.jacobian.column(column))).collect();
    let moving: Vec<usize> = (0..scale.len()).filter(|&column| scale[column] > 0.0).collect();
    let decomposition = Decomposition::new(&search.jacobian, &moving, &scale, &search.residuals);
    let least = FLAT * decomposition.greatest();
    scale.len() - decomposition.singular.iter().filter(|value| **value > least).count()
}

/// One per column: true if a derivative of a state or the condition of an event depends on the parameter. False for the
/// origin and offsets, true for film scales.
pub(in crate::fit) fn moving(problem: &Problem) -> Vec<bool> {
    let model = &problem.model;
    let mut parameters = Vec::new();
    for node in
        model.states.iter().map(|state| state.derivative).chain(model.events.iter().map(|event| event.condition))
    {
        parameters.extend(model.depends(node).parameters);
    }
    let moves = |target| match target {
        Some(Target::Parameter(index)) => parameters.contains(&(index as u32)),
        Some(Target::Origin | Target::Offset(_)) => false,
        // The beginning of a motion does not determine the scale of its film.
        None => true,
    };
    problem.columns.iter().map(|column| moves(column.target())).collect()
}
