//! Ends of the intervals of a profile. Each is found by searches of its own, so that several can be searched together.

use crate::fit::search::problem::Problem;
use crate::fit::search::window::{TRIALS, Window};
use crate::fit::search::{Search, Status};

/// Numbers at which a profile found a sum of squares below that of the fit, SI.
#[derive(Debug)]
pub(super) struct Lower(pub Vec<f64>);

/// Least decrease of the sum of squares for a lower minimum, in variances of a residual: above the errors of integration
/// and far below those of the fit.
const LOWER: f64 = 0.01;
/// Upper bound of the searches for one end.
const SEARCHES: usize = 30;
/// Farthest distance searched, in standard deviations.
const FAR: f64 = 1000.0;
/// Greatest number of ends that are searched together.
const TOGETHER: usize = 64;
/// Greatest number of residuals and derivatives that their searches have together: 64 MB.
const MOST_NUMBERS: usize = 8_000_000;

/// The answer around which a profile lies.
#[derive(Clone, Copy, Debug)]
pub(super) struct Centre<'a> {
    /// Best answer.
    pub best: &'a Search,
    /// Degrees of freedom.
    pub dof: usize,
    /// True if a lower sum of squares ends the profile, so that the fit can be restarted there.
    pub may_leave: bool,
}

/// Value at which the root of the growth of the sum of squares, in standard deviations, reaches a number. It is nearly linear in the
/// value, so that the secant method needs few steps; otherwise the end is bracketed.
#[derive(Debug)]
pub(super) struct End {
    /// Column of the number in the search.
    index: usize,
    /// Standard error with the sign of the side, SI.
    unit: f64,
    /// Growth at the end, in standard deviations.
    deviations: f64,
    /// Distance of the bound of the number, in standard errors.
    bound: f64,
    /// Greatest distance at which the growth is known to be less, with the growth.
    near: (f64, f64),
    /// Least distance at which the growth is known to be greater, with the growth.
    beyond: Option<(f64, f64)>,
    /// Distance at which the growth is computed next or at present.
    distance: f64,
    /// Start of the next search: the numbers of the last one.
    others: Vec<f64>,
    /// Number of searches that have ended.
    searches: usize,
    /// Present search, which holds the number.
    search: Option<Search>,
    /// The end, SI; `None` within if the fit stays good.
    pub found: Option<Result<Option<f64>, Lower>>,
}

impl End {
    /// End of the number `index`: `unit` is its standard error (SI) with the sign of the side, `deviations` the growth that is sought.
    pub fn new(problem: &Problem, centre: &Centre, index: usize, (unit, deviations): (f64, f64)) -> Self {
        let best = centre.best;
        let nowhere = !(unit != 0.0 && unit.is_finite()) || centre.dof == 0 || best.sum <= 0.0;
        let (low, high) = problem.open_bounds()[index];
        let bound = ((if unit > 0.0 { high } else { low }) - best.x[index]) / unit;
        Self {
            index,
            unit,
            deviations,
            bound,
            near: (0.0, 0.0),
            beyond: None,
            distance: deviations.min(bound),
            others: best.x.clone(),
            searches: 0,
            search: None,
            found: nowhere.then_some(Ok(None)),
        }
    }

    /// Value of the number at which the growth is computed, SI.
    fn value(&self, centre: &Centre) -> f64 {
        centre.best.x[self.index] + self.distance * self.unit
    }

    /// Bounds and start of the search with the number held; `None` outside of its bounds.
    fn held(&mut self, problem: &Problem, centre: &Centre) -> Option<Vec<(f64, f64)>> {
        let value = self.value(centre);
        let mut bounds = problem.open_bounds();
        let (low, high) = bounds[self.index];
        if !(value >= low && value <= high) {
            return None;
        }
        bounds[self.index] = (value, value);
        self.others[self.index] = value;
        Some(bounds)
    }

    /// Next point at which residuals are computed, if it is known.
    fn next_point(&mut self, problem: &Problem, centre: &Centre) -> Option<Vec<f64>> {
        if self.found.is_some() {
            return None;
        }
        match &mut self.search {
            Some(search) => search.next_point(),
            None => {
                let bounds = self.held(problem, centre)?;
                Some(self.others.iter().zip(&bounds).map(|(value, &(low, high))| value.max(low).min(high)).collect())
            }
        }
    }

    /// Begins a search or makes one trial of it; at its end, chooses the next distance.
    fn advance(&mut self, window: &mut Window, centre: &Centre) {
        let sum = match &mut self.search {
            _ if self.found.is_some() => return,
            Some(search) if search.status == Status::Searching => {
                search.advance(window);
                return;
            }
            Some(search) => {
                if search.sum.is_finite() {
                    self.others.copy_from_slice(&search.x);
                }
                search.sum
            }
            None => match self.held(window.problem, centre) {
                Some(bounds) => {
                    self.search = Some(window.search_holding(&self.others, bounds, TRIALS));
                    return;
                }
                None => f64::INFINITY,
            },
        };
        self.search = None;
        self.searches += 1;
        self.found = match self.growth(window.problem, centre, sum) {
            Err(lower) => Some(Err(lower)),
            Ok(reached) => self.settle(centre, reached).map(Ok),
        };
        if self.found.is_none() && self.searches == SEARCHES {
            self.found = Some(Ok(None));
        }
    }

    /// Root of the growth of the sum of squares from that of the answer to `sum`, in standard deviations; infinite without a curve.
    fn growth(&self, problem: &Problem, centre: &Centre, sum: f64) -> Result<f64, Lower> {
        let best = centre.best.sum;
        let variance = if problem.task.errors_given() { 1.0 } else { best / centre.dof as f64 };
        if sum < best - LOWER * variance && centre.may_leave {
            return Err(Lower(self.others.clone()));
        }
        Ok(((sum - best).max(0.0) / variance).sqrt())
    }

    /// Takes over the growth that is `reached` at the present distance. Returns the end if it is found; otherwise chooses the next
    /// distance.
    fn settle(&mut self, centre: &Centre, reached: f64) -> Option<Option<f64>> {
        let (deviations, distance, bound) = (self.deviations, self.distance, self.bound);
        if (reached - deviations).abs() < 1e-3 * deviations {
            return Some(Some(self.value(centre)));
        }
        let (near, near_growth) = self.near;
        let slope = (reached - near_growth) / (distance - near);
        let secant = distance + (deviations - reached) / slope;
        if reached > deviations {
            self.beyond = Some((distance, reached));
        } else {
            if distance >= bound || distance > FAR * deviations {
                return Some(None);
            }
            self.near = (distance, reached);
        }
        let (near, near_growth) = self.near;
        self.distance = match self.beyond {
            None if slope > 1e-3 => secant.clamp(1.01 * distance, 4.0 * distance).min(bound),
            None => (4.0 * distance).min(bound),
            Some((far, far_growth)) => {
                let width = far - near;
                if width <= 1e-9 * far {
                    // At a step of the sum of squares, the end is on the side where the fit is good.
                    return Some(Some(centre.best.x[self.index] + near * self.unit));
                }
                let part = (deviations - near_growth) / (far_growth - near_growth);
                // An infinite growth has no slope: bisection.
                near + width * if part > 0.0 { part.clamp(0.05, 0.95) } else { 0.5 }
            }
        };
        None
    }
}

/// Number of ends that are searched together: one without a solver for several solutions, which would need more memory and be no
/// faster.
pub(super) fn together(problem: &Problem, best: &Search) -> usize {
    let numbers = 2 * best.residuals.len() * (best.x.len() + 1);
    match problem.curve.has_lanes() {
        true => (MOST_NUMBERS / numbers.max(1)).clamp(1, TOGETHER),
        false => 1,
    }
}

/// Searches ends together, each with the bits of a search alone. Those after one with a lower sum of squares are given up.
pub(super) fn search(problem: &mut Problem, centre: &Centre, ends: &mut [End]) {
    let plans = problem.plans.clone();
    loop {
        let lower = ends.iter().position(|end| matches!(end.found, Some(Err(_)))).unwrap_or(ends.len());
        let needed = &mut ends[..lower];
        if needed.iter().all(|end| end.found.is_some()) {
            return;
        }
        let points: Vec<Vec<f64>> = needed.iter_mut().filter_map(|end| end.next_point(problem, centre)).collect();
        problem.solve_together(&plans, &points);
        let mut window = Window { problem, plans: &plans };
        needed.iter_mut().for_each(|end| end.advance(&mut window, centre));
    }
}
