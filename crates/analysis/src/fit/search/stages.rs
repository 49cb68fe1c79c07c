//! From where a fit searches, one start after the other.

use super::problem::Problem;
use super::start;
use super::window::{self, TRIALS, Window};
use super::{Search, Status};
use crate::cycles::Estimate;
use crate::fit::linear::{Decomposition, norm};
use crate::fit::task::Target;
use crate::fit::task::plan::Plan;
use std::sync::Arc;

/// From where a fit searches.
#[derive(Clone, Debug)]
enum Stage {
    /// The given or the parameters' own values, where a search stands ready.
    Own(Box<Search>),
    /// The frequency and the damping that the data show.
    Estimated,
    /// Windows that grow from the beginning of the record.
    Windows,
    /// Starts spread over the ranges, still to be chosen.
    Spread,
    /// One of those.
    From(Vec<f64>),
}

/// A part of the records, from the beginning.
#[derive(Clone, Copy, Debug)]
pub(in crate::fit) struct Span {
    /// How long it is.
    pub duration: f64,
    /// Whether what the motion itself depends on is held meanwhile, and only initial values and scales are searched.
    pub held: bool,
}

/// A search that goes on.
#[derive(Clone, Debug)]
pub(in crate::fit) struct Current {
    /// The search.
    pub search: Search,
    /// What it searches over.
    plans: Arc<Vec<Plan>>,
    /// Windows still to come, the last one first; the search is of the whole where there are none.
    pub windows: Vec<Span>,
    /// Whether a number is held that is let free when the search has ended.
    pub held: bool,
}

impl Current {
    /// A search of all that is fitted; whether a number is `held` in it.
    pub fn whole(problem: &Problem, search: Search, held: bool) -> Self {
        Self { search, plans: problem.plans.clone(), windows: Vec::new(), held }
    }

    /// Makes one trial.
    pub fn advance(&mut self, problem: &mut Problem) -> Status {
        self.search.advance(&mut Window { problem, plans: &self.plans })
    }
}

/// What is still to be tried.
#[derive(Clone, Debug, Default)]
pub(in crate::fit) struct Stages {
    /// The last one first.
    pending: Vec<Stage>,
    /// By record: the oscillation that the data show.
    estimates: Vec<Option<Estimate>>,
    /// By number of the search: whether equations of motion themselves depend on it, not only how they begin.
    moving: Vec<bool>,
    /// In how many directions the curve does not change at the own values.
    flat: usize,
}

impl Stages {
    /// Windows in which only the beginning of a motion is searched.
    const HELD: usize = 2;
    /// Trials in a window that is not yet the whole.
    const WINDOW_TRIALS: usize = 15;
    /// Starts spread over the ranges.
    const SPREAD: usize = 12;
    /// Trials from each of them, for equations of motion: what has not found its way by then does not.
    const SPREAD_TRIALS: usize = 40;
    /// Starts that are looked at, for formulas.
    const SCREENED: usize = 240;
    /// How many of these are searched from.
    const CHOSEN: usize = 10;

    /// All of them: the own values first, unless they explain nothing while the data show an oscillation.
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

    /// Whether nothing is left to be tried.
    pub fn is_empty(&self) -> bool {
        self.pending.is_empty()
    }

    /// Tries nothing more, except the windows where they are `wanted`.
    pub fn skip(&mut self, wanted: bool) {
        self.pending.retain(|stage| wanted && matches!(stage, Stage::Windows));
    }

    /// Whether a search stands in a place as definite as the own values. Where terms have become one, or a number has run away
    /// to the end of its range, it does not.
    pub fn is_definite(&self, search: &Search) -> bool {
        flat(search) <= self.flat && (0..search.x.len()).all(|column| !search.at_bound(column))
    }

    /// The search of the next stage, if it has one.
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

    /// A search of a part of the records.
    pub fn window(&self, problem: &mut Problem, start: &[f64], span: Span, windows: Vec<Span>) -> Current {
        let plans = Arc::new(start::cut(&problem.plans, span.duration));
        let limit = if windows.is_empty() { TRIALS } else { Self::WINDOW_TRIALS };
        let mut bounds = problem.bounds.clone();
        if span.held {
            for (number, bounds) in bounds.iter_mut().enumerate().filter(|(number, _)| self.moving[*number]) {
                *bounds = (start[number], start[number]);
            }
        }
        let search = Window { problem, plans: &plans }.search_within(start, bounds, limit);
        Current { search, plans, windows, held: false }
    }

    /// The windows of the records, the last one first. In the first ones the motion is held: as long as it is not known where
    /// it began, it would be bent to make up for that.
    fn windows(&self, problem: &Problem) -> Vec<Span> {
        let held = if self.moving.contains(&false) { Self::HELD } else { 0 };
        let durations = start::windows(problem, &self.estimates);
        let spans = durations.into_iter().enumerate();
        spans.map(|(place, duration)| Span { duration, held: place < held && duration.is_finite() }).rev().collect()
    }

    /// Starts spread over the ranges. Those of a formula are cheap enough to look at many, and to begin with the best.
    fn spread(problem: &mut Problem) -> Vec<Vec<f64>> {
        // The scales of films stay where their priors are.
        let numbers = problem.own.len() - problem.scales();
        let (own, scales) = problem.own.split_at(numbers);
        let start = |index| [start::spread(own, &problem.bounds, index), scales.to_vec()].concat();
        if problem.curve.has_states() {
            return (0..Self::SPREAD).map(start).collect();
        }
        let plans: Vec<Plan> = problem.plans.iter().map(start::thinned).collect();
        let points: usize = plans.iter().map(|plan| plan.points.len()).sum();
        // The more points, the fewer: nothing else goes on meanwhile.
        let count = (Self::SCREENED * start::ROWS / points.max(start::ROWS)).max(Self::CHOSEN);
        let candidates: Vec<Vec<f64>> = (0..count).map(start).collect();
        let mut window = Window { problem, plans: &plans };
        let mut looked: Vec<Search> = candidates.iter().map(|start| window.look(start)).collect();
        looked.sort_by(|one, other| one.sum.total_cmp(&other.sum));
        looked.into_iter().filter(|one| one.sum.is_finite()).take(Self::CHOSEN).map(|one| one.x).collect()
    }
}

/// A direction in which the curve changes by less than this part of the greatest change is no direction to search in.
const FLAT: f64 = 1e-8;

/// In how many directions the curve does not change where a search is.
fn flat(search: &Search) -> usize {
    let scale: Vec<f64> = (0..search.x.len()).map(|column| norm(search.jacobian.column(column))).collect();
    let moving: Vec<usize> = (0..scale.len()).filter(|&column| scale[column] > 0.0).collect();
    let decomposition = Decomposition::new(&search.jacobian, &moving, &scale, &search.residuals);
    let least = FLAT * decomposition.greatest();
    scale.len() - decomposition.singular.iter().filter(|value| **value > least).count()
}

/// Whether equations of motion, their events or the observed expressions depend on a parameter in another way than through
/// initial values and scales; for formulas, never.
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
