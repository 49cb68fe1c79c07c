//! A weighted straight line through results, with a scatter between the groups as for a pooled value.

use crate::pooling::{Measured, Reach, check, scatter};
use units::{Words, words};

/// Result of a group, and the value of the parameter in it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// Value of the parameter, in any unit that is common to all.
    pub x: f64,
    /// The result.
    pub measured: Measured,
}

/// A straight line through results. Intervals hold with a probability of 95 %.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line {
    /// Number of results.
    pub count: usize,
    /// Slope.
    pub slope: f64,
    /// Standard error of the slope, from errors and scatter as for a pooled value, with `count - 2` degrees of freedom.
    pub slope_error: f64,
    /// Interval of the slope.
    pub slope_interval: (f64, f64),
    /// Value at 0.
    pub intercept: f64,
    /// Standard error of the value at 0.
    pub intercept_error: f64,
    /// Interval of the value at 0.
    pub intercept_interval: (f64, f64),
    /// Standard deviation of the groups from the line beyond their errors, after Paule and Mandel.
    pub tau: f64,
}

/// Greatest size of a parameter: the squares of larger numbers could not be added.
const LARGEST: f64 = 1e100;

/// Sums of a weighted line: about the weighted means of x and y.
struct Sums {
    weights: f64,
    x: f64,
    y: f64,
    /// Weighted sum of the squares of x.
    spread: f64,
    slope: f64,
    /// Weighted sum of the squared deviations from the line.
    squares: f64,
}

impl Sums {
    /// Line with this variance between the groups.
    fn new(points: &[Point], variance: f64) -> Self {
        let weight = |point: &Point| 1.0 / (point.measured.error * point.measured.error + variance);
        let weights: f64 = points.iter().map(weight).sum();
        let mean = |value: fn(&Point) -> f64| points.iter().map(|one| weight(one) * value(one)).sum::<f64>() / weights;
        let (x, y) = (mean(|one| one.x), mean(|one| one.measured.value));
        let about = |one: &Point| (one.x - x, one.measured.value - y);
        let spread: f64 = points.iter().map(|one| weight(one) * about(one).0 * about(one).0).sum();
        let slope = points.iter().map(|one| weight(one) * about(one).0 * about(one).1).sum::<f64>() / spread;
        let off = |one: &Point| about(one).1 - slope * about(one).0;
        let squares = points.iter().map(|one| weight(one) * off(one) * off(one)).sum();
        Self { weights, x, y, spread, slope, squares }
    }
}

/// Straight line through the results of at least three groups, by least squares with weights from errors and scatter.
///
/// # Errors
/// Fewer than three results, all with the same value of the parameter, or numbers that cannot be computed with.
pub fn line(points: &[Point]) -> Result<Line, Words> {
    if points.len() < 3 {
        return Err(words("a line with an error needs the results of three groups at least"));
    }
    let results: Vec<Measured> = points.iter().map(|point| point.measured).collect();
    check(&results)?;
    if let Some(place) = points.iter().position(|point| point.x.is_nan() || point.x.abs() >= LARGEST) {
        let number = place + 1;
        return Err(words!("the parameter of result {number} is no number, or too large to be computed with"));
    }
    if points.iter().all(|point| point.x == points[0].x) {
        return Err(words("all groups have the same value of the parameter: there is no line through one place"));
    }
    let freedom = points.len() as u32 - 2;
    let tau = scatter(&results, f64::from(freedom), |variance| Sums::new(points, variance).squares);
    let Sums { weights, x, y, spread, slope, squares } = Sums::new(points, tau * tau);
    let reach = Reach::new(squares, freedom);
    let (intercept, variance) = (y - slope * x, 1.0 / weights + x * x / spread);
    let (slope_error, slope_interval) = (reach.error(1.0 / spread), reach.interval(slope, 1.0 / spread));
    let (intercept_error, intercept_interval) = (reach.error(variance), reach.interval(intercept, variance));
    let ends = [slope_interval.0, slope_interval.1, intercept_interval.0, intercept_interval.1];
    if !ends.iter().all(|end| end.is_finite()) {
        return Err(words("the values of the parameter are too close to each other to be computed with"));
    }
    let count = points.len();
    Ok(Line { count, slope, slope_error, slope_interval, intercept, intercept_error, intercept_interval, tau })
}
