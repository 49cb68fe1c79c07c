//! Standard errors and intervals from scatter and from known errors.

use analysis::fit::student;

/// Probability that an interval misses the true value.
const MISSED: f64 = 0.05;

/// Half the width of an interval of a normal distribution that it misses with that probability, in standard deviations.
const NORMAL: f64 = 1.959_963_985;

/// Standard errors and intervals of 95 % confidence after Hartung and Knapp (Statist. Med. 20 (2001) 1771; for lines 22
/// (2003) 2693): the errors are scaled to the scatter, and the interval is that of Student's distribution.
///
/// Error and interval are at least those without the scaling, as proposed by Wiksten, Rücker and Schwarzer (Statist. Med. 35
/// (2016) 2503) and Jackson et al. (Statist. Med. 36 (2017) 3923). Without this bound, results that agree by chance
/// better than their errors would have an error of almost 0. It acts only where the results scatter less than their errors.
/// With honest errors intervals then hold the true value in 97 % instead of 95 % of classes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Reach {
    /// Sum of squared deviations per degree of freedom, in units of the variances.
    scale: f64,
    /// Quantile of Student's distribution.
    student: f64,
}

impl Reach {
    /// From the sum of squared deviations in units of the variances, and the degrees of freedom, at least 1.
    pub fn new(squares: f64, freedom: u32) -> Self {
        let freedom = f64::from(freedom);
        Self { scale: squares / freedom, student: student(MISSED, freedom) }
    }

    /// Standard error of a quantity that has this variance by the errors and the scatter between the groups.
    pub fn error(&self, variance: f64) -> f64 {
        (self.scale.max(1.0) * variance).sqrt()
    }

    /// Interval about a value that has this variance.
    pub fn interval(&self, value: f64, variance: f64) -> (f64, f64) {
        let reach = (self.student * self.scale.sqrt()).max(NORMAL) * variance.sqrt();
        (value - reach, value + reach)
    }
}
