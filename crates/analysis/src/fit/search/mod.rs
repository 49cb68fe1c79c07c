//! Levenberg-Marquardt search for the least sum of squares, advanced one trial at a time.
//!
//! A trust region bounds the step in scaled variables; the scale is the greatest norm that each column of the Jacobian has
//! had (More, Lecture Notes in Mathematics 630 (1978) 105). The step inside it comes from singular values, which also show
//! directions without effect. Bounds are kept by projection: a variable at its bound whose step would leave the range is
//! held for this step.
//!
//! Variables in which the residuals are linear are eliminated: after a step they are set to their values of linear least
//! squares, if that lowers the sum enough. The step of the others is then that of Kaufman's variable projection, which
//! needs no starting values for the linear variables and follows long curved valleys in few steps (Golub & Pereyra, SIAM J.
//! Numer. Anal. 10 (1973) 413; Ruhe & Wedin, SIAM Review 22 (1980) 318, algorithm 2).

pub(in crate::fit) mod curve;
pub(in crate::fit) mod elsewhere;
mod late;
mod line;
pub(in crate::fit) mod loss;
mod motion;
pub(in crate::fit) mod moves;
mod phases;
pub(in crate::fit) mod problem;
pub(in crate::fit) mod refine;
pub(in crate::fit) mod robust;
pub(in crate::fit) mod stages;
pub(in crate::fit) mod start;
pub(in crate::fit) mod symmetry;
mod tones;
pub(in crate::fit) mod window;

use super::linear::{Decomposition, Jacobian, Split, norm};

/// Residuals to be minimised.
pub(crate) trait Residuals {
    /// Computes residuals and their derivatives at `x`. Returns false if there are none.
    fn evaluate(&mut self, x: &[f64], residuals: &mut [f64], jacobian: &mut Jacobian) -> bool;

    /// Variables in which the residuals are linear, all of them together.
    fn linear(&self) -> Vec<usize>;
}

/// State of a search.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Status {
    /// The search continues.
    Searching,
    /// The residuals are orthogonal to all directions in which they can be changed, or no step is left.
    Converged,
    /// The residuals could not be computed at the start, or the trials are used up.
    Failed,
}

/// Search for the least sum of squares.
#[derive(Clone, Debug)]
pub(crate) struct Search {
    /// Variables at the least sum of squares so far.
    pub x: Vec<f64>,
    /// Lower and upper bound of each variable.
    bounds: Vec<(f64, f64)>,
    /// Sum of squares at `x`.
    pub sum: f64,
    /// Residuals at `x`.
    pub residuals: Vec<f64>,
    /// Derivatives of the residuals at `x`.
    pub jacobian: Jacobian,
    /// State of the search.
    pub status: Status,
    /// Number of trials made.
    pub trials: usize,
    /// Variables in which the residuals are linear.
    linear: Vec<usize>,
    scale: Vec<f64>,
    radius: f64,
    /// Relative decrease of the sum of squares below which the search has converged.
    tolerance: f64,
    limit: usize,
    trial_residuals: Vec<f64>,
    trial_jacobian: Jacobian,
    step: Option<Step>,
}

/// Free columns and their decomposition.
#[derive(Clone, Debug)]
struct Step {
    linear: Vec<usize>,
    others: Vec<usize>,
    split: Split,
}

/// Trial that has not been made.
struct Planned {
    /// Predicted decrease of the sum of squares by the best step.
    promised: f64,
    /// Variables of the trial.
    trial: Vec<f64>,
    /// True if the trust radius bounds the step.
    damped: bool,
}

impl Search {
    /// Initial trust radius in multiples of the scaled norm of the start (MINPACK's `factor`).
    const FIRST_RADIUS: f64 = 10.0;
    /// Singular values below this part of the greatest are rounding.
    const FLAT: f64 = 1e-14;
    /// Tolerance like `FLAT` for the values of the linear variables.
    const FLAT_LINEAR: f64 = 1e-12;
    /// If the predicted decrease is below this part of the sum, sums of squares are not compared.
    const ROUNDING: f64 = 1e-12;
    /// Least relative decrease of the sum of squares for which the linear variables are set to their best values.
    const WORTH: f64 = 1e-2;

    /// Begins at `start`, moved into the bounds. `rows` is the number of residuals, `limit` that of trials.
    pub fn new(
        problem: &mut impl Residuals,
        start: &[f64],
        bounds: Vec<(f64, f64)>,
        rows: usize,
        tolerance: f64,
        limit: usize,
    ) -> Self {
        let columns = start.len();
        let mut search = Self {
            x: start.iter().zip(&bounds).map(|(value, &(low, high))| value.max(low).min(high)).collect(),
            bounds,
            sum: f64::INFINITY,
            residuals: vec![0.0; rows],
            jacobian: Jacobian::new(rows, columns),
            status: Status::Searching,
            trials: 1,
            linear: problem.linear(),
            scale: vec![0.0; columns],
            radius: 0.0,
            tolerance,
            limit,
            trial_residuals: vec![0.0; rows],
            trial_jacobian: Jacobian::new(rows, columns),
            step: None,
        };
        search.sum = search.evaluate_at(problem, &search.x.clone());
        if search.sum == f64::INFINITY {
            search.status = Status::Failed;
        } else {
            search.swap();
            search.measure();
        }
        search
    }

    /// Sets the linear variables to their best values at the start, if that is worthwhile.
    pub fn set_linear(&mut self, problem: &mut impl Residuals) {
        let Some(better) = self.projected(&self.x, &self.residuals, &self.jacobian, self.sum) else { return };
        let sum = self.evaluate_at(problem, &better);
        if sum < self.sum {
            self.accept(better, sum);
            self.measure();
        }
    }

    /// Makes one trial and returns the state after it.
    pub fn advance(&mut self, problem: &mut impl Residuals) -> Status {
        if self.status != Status::Searching {
            return self.status;
        }
        if self.trials == 1 {
            self.set_linear(problem);
        }
        let Planned { promised, mut trial, damped } = self.plan();
        let Some(step) = self.step.take().filter(|_| promised > self.tolerance * self.sum) else {
            self.status = Status::Converged;
            return self.status;
        };
        let change: Vec<f64> = trial.iter().zip(&self.x).map(|(to, from)| to - from).collect();
        let moves = change.iter().any(|change| *change != 0.0);
        let length = self.length(&change);
        let predicted = self.sum - self.linear_sum(&change);
        self.trials += 1;
        let sum = if moves { self.evaluate(problem, &mut trial) } else { f64::INFINITY };
        if promised < Self::ROUNDING * self.sum {
            self.polish(trial, sum, promised);
            return self.status;
        }
        let gain = if sum.is_finite() { self.sum - sum } else { f64::NEG_INFINITY };
        let ratio = if predicted > 0.0 { gain / predicted } else { -1.0 };
        // The radius grows or shrinks with the ratio of actual and predicted decrease.
        if ratio < 0.25 {
            let shrink = if sum < 100.0 * self.sum { 0.25 } else { 0.1 };
            self.radius = shrink * self.radius.min(2.0 * length);
        } else if ratio > 0.75 || !damped {
            self.radius = self.radius.max(2.0 * length);
        }
        if ratio > 1e-4 {
            self.accept(trial, sum);
        } else {
            self.step = Some(step);
        }
        if self.sum == 0.0 || self.radius <= 4.0 * f64::EPSILON * self.length(&self.x) || !moves {
            self.status = Status::Converged;
        } else if self.trials >= self.limit {
            self.status = Status::Failed;
        }
        self.status
    }

    /// Next point at which residuals are computed; `None` if none are.
    pub fn next_point(&mut self) -> Option<Vec<f64>> {
        if self.status != Status::Searching {
            return None;
        }
        if self.trials == 1
            && let Some(better) = self.projected(&self.x, &self.residuals, &self.jacobian, self.sum)
        {
            return Some(better);
        }
        let Planned { promised, trial, .. } = self.plan();
        (promised > self.tolerance * self.sum && trial != self.x).then_some(trial)
    }

    /// The next trial, with the decomposition of its step.
    fn plan(&mut self) -> Planned {
        let step = match self.step.take() {
            Some(known) => known,
            None => self.decompose(),
        };
        let promised = step.split.promised(Self::FLAT);
        let (change, damped) = restricted(&step.split.rest, self.radius);
        let follow = step.split.following(&change);
        let mut trial = self.x.clone();
        for (&column, change) in step.linear.iter().zip(&follow).chain(step.others.iter().zip(&change)) {
            let (low, high) = self.bounds[column];
            trial[column] = (trial[column] - change / self.scale[column]).max(low).min(high);
        }
        self.step = Some(step);
        Planned { promised, trial, damped }
    }

    /// Accepts or rejects a trial so close to the minimum that sums of squares differ only by rounding: it is accepted if
    /// it lowers the predicted decrease.
    fn polish(&mut self, trial: Vec<f64>, sum: f64, promised: f64) {
        self.status = Status::Converged;
        if sum <= self.sum * (1.0 + Self::ROUNDING) {
            let before = (std::mem::replace(&mut self.x, trial), std::mem::replace(&mut self.sum, sum));
            self.swap();
            let step = self.decompose();
            if step.split.promised(Self::FLAT) < 0.98 * promised && self.trials < self.limit {
                self.step = Some(step);
                self.status = Status::Searching;
            } else {
                (self.x, self.sum) = before;
                self.swap();
            }
        }
    }

    /// Accepts a trial.
    fn accept(&mut self, trial: Vec<f64>, sum: f64) {
        self.x = trial;
        self.sum = sum;
        self.swap();
        self.rescale();
    }

    /// Exchanges residuals and derivatives with those of the trial.
    fn swap(&mut self) {
        std::mem::swap(&mut self.residuals, &mut self.trial_residuals);
        std::mem::swap(&mut self.jacobian, &mut self.trial_jacobian);
    }

    /// Sum of squares at `x`, infinite if there is none. The linear variables are set to their best values if that is
    /// worthwhile. Residuals and derivatives are stored as those of the trial.
    fn evaluate(&mut self, problem: &mut impl Residuals, x: &mut Vec<f64>) -> f64 {
        let sum = self.evaluate_at(problem, x);
        if sum < f64::INFINITY
            && let Some(better) = self.projected(x, &self.trial_residuals, &self.trial_jacobian, sum)
        {
            let better_sum = self.evaluate_at(problem, &better);
            if better_sum < sum {
                *x = better;
                return better_sum;
            }
            return self.evaluate_at(problem, x);
        }
        sum
    }

    fn evaluate_at(&mut self, problem: &mut impl Residuals, x: &[f64]) -> f64 {
        if !problem.evaluate(x, &mut self.trial_residuals, &mut self.trial_jacobian)
            || !self.trial_jacobian.values.iter().all(|value| value.is_finite())
        {
            return f64::INFINITY;
        }
        let sum = sum_of_squares(&self.trial_residuals);
        if sum.is_finite() { sum } else { f64::INFINITY }
    }

    /// `x` with the best values of the linear variables, if that lowers `sum` enough and stays within the bounds.
    fn projected(&self, x: &[f64], residuals: &[f64], jacobian: &Jacobian, sum: f64) -> Option<Vec<f64>> {
        let mut scale = vec![0.0; x.len()];
        self.linear.iter().for_each(|&column| scale[column] = norm(jacobian.column(column)));
        let free = |column: usize| scale[column] > 0.0 && self.bounds[column].0 < self.bounds[column].1;
        let columns: Vec<usize> = self.linear.iter().copied().filter(|&column| free(column)).collect();
        if columns.is_empty() {
            return None;
        }
        let decomposition = Decomposition::new(jacobian, &columns, &scale, residuals);
        if decomposition.promised(Self::FLAT_LINEAR) < Self::WORTH * sum {
            return None;
        }
        let flat = Self::FLAT_LINEAR * decomposition.greatest();
        let step = decomposition.combine(|value| if value > flat { 1.0 / value } else { 0.0 });
        let mut better = x.to_vec();
        for (&column, step) in columns.iter().zip(&step) {
            better[column] -= step / scale[column];
            let (low, high) = self.bounds[column];
            if !(better[column] >= low && better[column] <= high) {
                return None;
            }
        }
        Some(better)
    }

    /// True if a variable is at one of its bounds.
    pub fn at_bound(&self, column: usize) -> bool {
        let (low, high) = self.bounds[column];
        self.x[column] <= low || self.x[column] >= high
    }

    /// Sets scales and initial trust radius from the present point.
    fn measure(&mut self) {
        self.scale.fill(0.0);
        self.rescale();
        let length = self.length(&self.x);
        self.radius = Self::FIRST_RADIUS * if length > 0.0 { length } else { 1.0 };
    }

    fn rescale(&mut self) {
        for (column, scale) in self.scale.iter_mut().enumerate() {
            let length = norm(self.jacobian.column(column));
            *scale = scale.max(length);
            if *scale == 0.0 {
                // A zero column has no effect here; any scale will do.
                *scale = f64::MIN_POSITIVE.sqrt();
            }
        }
    }

    /// Norm of a change in scaled variables, without the linear ones.
    fn length(&self, way: &[f64]) -> f64 {
        let counts = |column: &usize| !self.linear.contains(column);
        let scaled: Vec<f64> = (0..way.len()).filter(counts).map(|column| way[column] * self.scale[column]).collect();
        norm(&scaled)
    }

    /// Decomposition of the free columns.
    fn decompose(&self) -> Step {
        let gradient = |column| super::linear::dot(self.jacobian.column(column), &self.residuals);
        let free = |column: &usize| {
            let (low, high) = self.bounds[*column];
            let held = (self.x[*column] <= low && gradient(*column) > 0.0)
                || (self.x[*column] >= high && gradient(*column) < 0.0);
            !held && low < high
        };
        let (linear, others): (Vec<usize>, Vec<usize>) =
            (0..self.x.len()).filter(free).partition(|column| self.linear.contains(column));
        let split = Split::new(&self.jacobian, &linear, &others, &self.scale, &self.residuals);
        Step { linear, others, split }
    }

    /// Sum of squares after `change`, predicted by the linearised residuals.
    fn linear_sum(&self, change: &[f64]) -> f64 {
        let mut predicted = self.residuals.clone();
        for (column, &change) in change.iter().enumerate().filter(|(_, change)| **change != 0.0) {
            for (value, slope) in predicted.iter_mut().zip(self.jacobian.column(column)) {
                *value += change * slope;
            }
        }
        sum_of_squares(&predicted)
    }
}

/// Best step within the radius (to be subtracted, in scaled variables), and true if the radius bounds it. The damping for
/// which the length of the step equals the radius is found by Newton's method on the reciprocal length.
fn restricted(decomposition: &Decomposition, radius: f64) -> (Vec<f64>, bool) {
    let flat = Search::FLAT * decomposition.greatest();
    let free = decomposition.combine(|value| if value > flat { 1.0 / value } else { 0.0 });
    if norm(&free) <= 1.1 * radius {
        return (free, false);
    }
    let mut damping = 0.0;
    for _ in 0..30 {
        let mut square = 0.0;
        let mut slope = 0.0;
        for (value, along) in
            decomposition.singular.iter().zip(&decomposition.along).filter(|(value, _)| **value > flat)
        {
            let divisor = value * value + damping;
            let part = value * along / divisor;
            square += part * part;
            slope -= part * part / divisor;
        }
        let length = square.sqrt();
        if (length - radius).abs() <= 0.1 * radius || slope == 0.0 {
            break;
        }
        // phi = 1/length - 1/radius is nearly linear in the damping.
        damping = (damping + (length / radius - 1.0) * square / -slope).max(0.0);
    }
    (decomposition.combine(|value| if value > flat { value / (value * value + damping) } else { 0.0 }), true)
}

fn sum_of_squares(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |sum, value| sum + value * value)
}
