//! The pooled value of the results of groups, by random effects: besides its own error, each result may deviate from the
//! common value by what groups do differently, with standard deviation tau.

mod measured;
mod outliers;
mod quantiles;
mod reach;
mod scatter;

pub use measured::Measured;
pub use outliers::Reason;

pub(crate) use reach::Reach;
pub(crate) use scatter::scatter;

use outliers::{is_outlier, reason};
use quantiles::chi_squared;
use units::{Language, Words, say, words};

/// A pooled value. Intervals hold with a probability of 95 %.
#[derive(Clone, Debug, PartialEq)]
pub struct Pooled {
    /// Number of results.
    pub count: usize,
    /// Weighted mean.
    pub value: f64,
    /// Standard error of the mean after Hartung and Knapp (Statist. Med. 20 (2001) 1771), at least that of the weighted mean.
    /// See [`Reach`].
    pub error: f64,
    /// Interval of the mean. See [`Reach`].
    pub interval: (f64, f64),
    /// Standard deviation between the groups, after Paule and Mandel (J. Res. NBS 87 (1982) 377).
    pub tau: f64,
    /// Interval of `tau` by the Q profile (Viechtbauer, Statist. Med. 26 (2007) 37).
    pub tau_interval: (f64, f64),
}

/// A result that lies far from the others.
#[derive(Clone, Debug, PartialEq)]
pub struct Outlier {
    /// Index of the result.
    pub index: usize,
    /// Likely reason; `None` if none fits.
    pub reason: Option<Reason>,
}

/// Results of groups together.
#[derive(Clone, Debug, PartialEq)]
pub struct Pool {
    /// All results together.
    pub all: Pooled,
    /// The results that lie far from the others.
    pub outliers: Vec<Outlier>,
    /// Pooled value without the outliers; `None` if there are none, or fewer than two results are left.
    pub without: Option<Pooled>,
}

/// Pools the results of at least two groups.
///
/// # Errors
/// Fewer than two results, a value that is not finite, an error that is not above 0, or numbers so extreme that their
/// squares cannot be computed.
pub fn pool(results: &[Measured]) -> Result<Pool, Words> {
    if results.len() < 2 {
        return Err(words("a pooled value needs the results of two groups at least"));
    }
    check(results)?;
    let marked: Vec<bool> = is_outlier(results);
    let rest: Vec<Measured> =
        results.iter().zip(&marked).filter(|(_, marked)| !**marked).map(|(one, _)| *one).collect();
    let outliers = (0..results.len()).filter(|index| marked[*index]);
    let outliers: Vec<Outlier> =
        outliers.map(|index| Outlier { index, reason: reason(results[index], &rest) }).collect();
    let without = (!outliers.is_empty() && rest.len() >= 2).then(|| pooled(&rest));
    Ok(Pool { all: pooled(results), outliers, without })
}

/// Refuses results that cannot be computed with.
///
/// # Errors
/// A value that is not finite, an error that is not above 0, or numbers so extreme that their squares cannot be computed.
pub(crate) fn check(results: &[Measured]) -> Result<(), Words> {
    for (index, one) in results.iter().enumerate() {
        let number = index + 1;
        if !one.value.is_finite() {
            return Err(words!("result {number} is not a number"));
        }
        if !(one.error > 0.0 && one.error.is_finite()) {
            return Err(words!("result {number} has no standard error above 0; without one it cannot be weighted"));
        }
        if !is_computable(*one) {
            return Err(words!("result {number} or its error is too large or too small to be computed with"));
        }
    }
    Ok(())
}

/// True if squares of value and error, and of their ratio, neither overflow nor vanish, with room for sums of many.
fn is_computable(Measured { value, error }: Measured) -> bool {
    (1e-100..1e100).contains(&error) && value.abs() < 1e100 && value.abs() < 1e50 * error
}

/// Sum of squared deviations from the weighted mean in units of their variance, with this variance between the groups; the
/// mean, and the sum of the weights.
fn weighted(results: &[Measured], variance: f64) -> (f64, f64, f64) {
    let weight = |one: &Measured| 1.0 / (one.error * one.error + variance);
    let sum: f64 = results.iter().map(weight).sum();
    let mean = results.iter().map(|one| weight(one) * one.value).sum::<f64>() / sum;
    let squares = results.iter().map(|one| weight(one) * (one.value - mean) * (one.value - mean)).sum();
    (squares, mean, sum)
}

fn pooled(results: &[Measured]) -> Pooled {
    let freedom = results.len() as u32 - 1;
    let tau_of = |squares: f64| scatter(results, squares, |variance| weighted(results, variance).0);
    let tau = tau_of(f64::from(freedom));
    let (squares, value, weights) = weighted(results, tau * tau);
    let reach = Reach::new(squares, freedom);
    Pooled {
        count: results.len(),
        value,
        error: reach.error(1.0 / weights),
        interval: reach.interval(value, 1.0 / weights),
        tau,
        tau_interval: (tau_of(chi_squared(0.975, freedom)), tau_of(chi_squared(0.025, freedom))),
    }
}

impl Pooled {
    /// A sentence about the scatter between the groups. `number`: writes a number with its unit.
    pub fn scatter_text(&self, language: Language, number: impl Fn(f64) -> String) -> String {
        let (tau, low, high) = (number(self.tau), number(self.tau_interval.0), number(self.tau_interval.1));
        if self.tau_interval.0 > 0.0 {
            return say!(
                language,
                "The groups differ by more than their errors explain: by {tau} (95 %: {low} to {high}). Look for what they did differently, or for errors that are too small."
            );
        }
        say!(
            language,
            "The groups agree within their errors. A scatter between them of up to {high} is not excluded (95 %)."
        )
    }
}
