//! Levenberg and Marquardt's search for the least sum of squares, as a thing that goes on one trial at a time.
//!
//! A trust region bounds the step in variables scaled by the greatest length that each column of the Jacobian has had
//! (More, Lecture Notes in Mathematics 630 (1978) 105). The step inside it comes from singular values, which also show
//! what the residuals do not depend on. Bounds are kept by projection: a variable that stands at its bound and wants to
//! leave is held for this step.

use super::linear::{Decomposition, Jacobian, norm};

/// What is minimised.
pub(crate) trait Residuals {
    /// Computes residuals and their derivatives at `x`; false if there are none.
    fn evaluate(&mut self, x: &[f64], residuals: &mut [f64], jacobian: &mut Jacobian) -> bool;
}

/// How a search stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Status {
    /// It goes on.
    Searching,
    /// The residuals are orthogonal to all directions in which they can be changed, or no step is left.
    Converged,
    /// The residuals could not be computed at the start, or the trials are used up.
    Failed,
}

/// A search.
#[derive(Clone, Debug)]
pub(crate) struct Search {
    /// Where the least sum of squares so far was found.
    pub x: Vec<f64>,
    /// Least and greatest value of each variable.
    bounds: Vec<(f64, f64)>,
    /// The sum of squares there.
    pub sum: f64,
    /// The residuals there.
    pub residuals: Vec<f64>,
    /// Their derivatives there.
    pub jacobian: Jacobian,
    /// How it stands.
    pub status: Status,
    /// How many trials were made.
    pub trials: usize,
    scale: Vec<f64>,
    radius: f64,
    /// The part of the sum of squares that may be left to gain when the search ends.
    tolerance: f64,
    limit: usize,
    trial_residuals: Vec<f64>,
    trial_jacobian: Jacobian,
    decomposition: Option<(Vec<usize>, Decomposition)>,
}

impl Search {
    /// The first step is no longer than the way to the start from zero, times this.
    const FIRST_RADIUS: f64 = 10.0;
    /// Below this part of the greatest singular value, a direction changes nothing but by rounding.
    const FLAT: f64 = 1e-14;

    /// Begins at `start`, moved into the bounds. `rows` is the number of residuals.
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
            scale: vec![0.0; columns],
            radius: 0.0,
            tolerance,
            limit,
            trial_residuals: vec![0.0; rows],
            trial_jacobian: Jacobian::new(rows, columns),
            decomposition: None,
        };
        if problem.evaluate(&search.x, &mut search.residuals, &mut search.jacobian) {
            search.sum = sum_of_squares(&search.residuals);
        }
        if !search.sum.is_finite() || !search.jacobian.values.iter().all(|value| value.is_finite()) {
            search.sum = f64::INFINITY;
            search.status = Status::Failed;
        } else {
            search.rescale();
            let length = norm(&search.scaled(&search.x));
            search.radius = Self::FIRST_RADIUS * if length > 0.0 { length } else { 1.0 };
        }
        search
    }

    /// Makes one trial.
    pub fn advance(&mut self, problem: &mut impl Residuals) -> Status {
        if self.status != Status::Searching {
            return self.status;
        }
        let (free, decomposition) = match self.decomposition.take() {
            Some(known) => known,
            None => self.decompose(),
        };
        if self.nothing_left(&decomposition) {
            self.decomposition = Some((free, decomposition));
            self.status = Status::Converged;
            return self.status;
        }
        let (step, damped) = restricted(&decomposition, self.radius);
        let mut trial = self.x.clone();
        for (&column, step) in free.iter().zip(&step) {
            let (low, high) = self.bounds[column];
            trial[column] = (trial[column] - step / self.scale[column]).max(low).min(high);
        }
        let change: Vec<f64> = trial.iter().zip(&self.x).map(|(to, from)| to - from).collect();
        let length = norm(&self.scaled(&change));
        let predicted = self.sum - self.linear_sum(&change);
        self.trials += 1;
        let mut sum = f64::INFINITY;
        if length > 0.0 && problem.evaluate(&trial, &mut self.trial_residuals, &mut self.trial_jacobian) {
            sum = sum_of_squares(&self.trial_residuals);
            if !self.trial_jacobian.values.iter().all(|value| value.is_finite()) {
                sum = f64::INFINITY;
            }
        }
        let gain = if sum.is_finite() { self.sum - sum } else { f64::NEG_INFINITY };
        let ratio = if predicted > 0.0 { gain / predicted } else { -1.0 };
        // The radius follows how well the linear prediction held.
        if ratio < 0.25 {
            let shrink = if sum < 100.0 * self.sum { 0.25 } else { 0.1 };
            self.radius = shrink * self.radius.min(2.0 * length);
        } else if ratio > 0.75 || !damped {
            self.radius = self.radius.max(2.0 * length);
        }
        if ratio > 1e-4 {
            self.x = trial;
            self.sum = sum;
            std::mem::swap(&mut self.residuals, &mut self.trial_residuals);
            std::mem::swap(&mut self.jacobian, &mut self.trial_jacobian);
            self.rescale();
        } else {
            self.decomposition = Some((free, decomposition));
        }
        let smallest = 4.0 * f64::EPSILON * norm(&self.scaled(&self.x));
        if self.sum == 0.0 || self.radius <= smallest || length == 0.0 {
            self.status = Status::Converged;
        } else if self.trials >= self.limit {
            self.status = Status::Failed;
        }
        self.status
    }

    /// Whether a variable stands at one of its bounds.
    pub fn at_bound(&self, column: usize) -> bool {
        let (low, high) = self.bounds[column];
        self.x[column] <= low || self.x[column] >= high
    }

    fn rescale(&mut self) {
        for (column, scale) in self.scale.iter_mut().enumerate() {
            let length = norm(self.jacobian.column(column));
            *scale = scale.max(length);
            if *scale == 0.0 {
                // It changes nothing here; any scale will do.
                *scale = f64::MIN_POSITIVE.sqrt();
            }
        }
    }

    fn scaled(&self, x: &[f64]) -> Vec<f64> {
        x.iter().zip(&self.scale).map(|(value, scale)| value * scale).collect()
    }

    /// The columns that are free to move, decomposed.
    fn decompose(&self) -> (Vec<usize>, Decomposition) {
        let gradient = |column| super::linear::dot(self.jacobian.column(column), &self.residuals);
        let free: Vec<usize> = (0..self.x.len())
            .filter(|&column| {
                let (low, high) = self.bounds[column];
                let held = (self.x[column] <= low && gradient(column) > 0.0)
                    || (self.x[column] >= high && gradient(column) < 0.0);
                !held && low < high
            })
            .collect();
        let decomposition = Decomposition::new(&self.jacobian, &free, &self.scale, &self.residuals);
        (free, decomposition)
    }

    /// The orthogonality criterion of Bates & Watts (Technometrics 23 (1981) 179): what part of the sum of squares the
    /// linear prediction still promises to take away.
    fn nothing_left(&self, decomposition: &Decomposition) -> bool {
        let flat = Self::FLAT * decomposition.greatest();
        let promised: f64 = decomposition
            .singular
            .iter()
            .zip(&decomposition.along)
            .filter(|(singular, _)| **singular > flat)
            .fold(0.0, |sum, (_, along)| sum + along * along);
        promised <= self.tolerance * self.sum
    }

    /// The sum of squares that the linear prediction gives after `change`.
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

/// The step (to be subtracted, in scaled variables) that is best within the radius, and whether the radius bounds it: the
/// damping that makes its length equal to the radius is found by Newton's method on the reciprocal length.
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
        // phi = 1/length - 1/radius is nearly straight in the damping.
        damping = (damping + (length / radius - 1.0) * square / -slope).max(0.0);
    }
    (decomposition.combine(|value| if value > flat { value / (value * value + damping) } else { 0.0 }), true)
}

fn sum_of_squares(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |sum, value| sum + value * value)
}
