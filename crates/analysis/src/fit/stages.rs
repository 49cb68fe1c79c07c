//! The stages of a fit: from where it searches, one after the other.

use super::driver::Fit;
use super::plan::Plan;
use super::search::Search;
use super::start;
use std::sync::Arc;

/// From where a fit searches.
#[derive(Clone, Debug)]
pub(super) enum Stage {
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
pub(super) struct Span {
    /// How long it is.
    pub duration: f64,
    /// Whether what the motion itself depends on is held meanwhile, and only initial values and scales are searched.
    pub held: bool,
}

/// A search that goes on.
#[derive(Clone, Debug)]
pub(super) struct Current {
    /// The search.
    pub search: Search,
    /// What it searches over.
    pub plans: Arc<Vec<Plan>>,
    /// Windows still to come, the last one first; the search is of the whole where there are none.
    pub windows: Vec<Span>,
}

impl Fit {
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

    /// Begins the next stage, or ends.
    pub(super) fn begin(&mut self) {
        let Some(stage) = self.stages.pop().filter(|_| !self.is_enough()) else {
            self.stages.clear();
            self.try_elsewhere();
            return;
        };
        let far = matches!(stage, Stage::From(_));
        let start = match stage {
            Stage::Own(search) => {
                self.starts += 1;
                self.search_whole(*search);
                return;
            }
            Stage::From(start) => start,
            Stage::Spread => {
                let starts = self.spread();
                self.stages.extend(starts.into_iter().rev().map(Stage::From));
                return;
            }
            Stage::Estimated => {
                match start::from_estimates(&mut self.problem, &self.model, &self.estimates, &self.own) {
                    Some(start) => start,
                    None => return,
                }
            }
            Stage::Windows => {
                let mut windows = self.windows();
                if let Some(first) = windows.pop().filter(|first| first.duration.is_finite()) {
                    self.starts += 1;
                    self.current = Some(self.window(&self.own.clone(), first, windows));
                }
                return;
            }
        };
        let limit = if far && self.problem.curve.has_states() { Self::SPREAD_TRIALS } else { Self::TRIALS };
        self.starts += 1;
        let search = self.search(&start, &self.problem.plans.clone(), limit);
        self.search_whole(search);
    }

    /// Begins the next search from elsewhere; after the last one the best answer is gone on with.
    fn try_elsewhere(&mut self) {
        let Some(start) = self.next_elsewhere() else {
            self.rival = self.find_rival();
            self.conclude();
            return;
        };
        self.starts += 1;
        let limit = if self.problem.curve.has_states() { Self::ELSEWHERE_TRIALS } else { Self::TRIALS };
        let search = self.search(&start, &self.problem.plans.clone(), limit);
        self.search_whole(search);
    }

    /// A search of a part of the records.
    pub(super) fn window(&mut self, start: &[f64], span: Span, windows: Vec<Span>) -> Current {
        let plans = Arc::new(start::cut(&self.problem.plans, span.duration));
        let limit = if windows.is_empty() { Self::TRIALS } else { Self::WINDOW_TRIALS };
        let bounds = self.bounds.clone();
        if span.held {
            for (number, bounds) in self.bounds.iter_mut().enumerate().filter(|(number, _)| self.moving[*number]) {
                *bounds = (start[number], start[number]);
            }
        }
        let search = self.search(start, &plans, limit);
        self.bounds = bounds;
        Current { search, plans, windows }
    }

    /// The windows of the records, the last one first. In the first ones the motion is held: as long as it is not known where
    /// it began, it would be bent to make up for that.
    fn windows(&self) -> Vec<Span> {
        let held = if self.moving.contains(&false) { Self::HELD } else { 0 };
        let durations = start::windows(&self.problem, &self.estimates);
        let spans = durations.into_iter().enumerate();
        spans.map(|(place, duration)| Span { duration, held: place < held && duration.is_finite() }).rev().collect()
    }

    /// Starts spread over the ranges. Those of a formula are cheap enough to look at many, and to begin with the best.
    fn spread(&mut self) -> Vec<Vec<f64>> {
        let start = |index| start::spread(&self.own, &self.bounds, index);
        if self.problem.curve.has_states() {
            return (0..Self::SPREAD).map(start).collect();
        }
        let plans: Vec<Plan> = self.problem.plans.iter().map(start::thinned).collect();
        let points: usize = plans.iter().map(|plan| plan.points.len()).sum();
        // The more points, the fewer: nothing else goes on meanwhile.
        let count = (Self::SCREENED * start::ROWS / points.max(start::ROWS)).max(Self::CHOSEN);
        let candidates: Vec<Vec<f64>> = (0..count).map(start).collect();
        let mut looked: Vec<Search> = candidates.iter().map(|start| self.look(start, &plans)).collect();
        looked.sort_by(|one, other| one.sum.total_cmp(&other.sum));
        looked.into_iter().filter(|one| one.sum.is_finite()).take(Self::CHOSEN).map(|one| one.x).collect()
    }
}
