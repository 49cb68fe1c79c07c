//! Uncertainties of least squares where the errors are a first-order autoregressive process, e_t = rho e_(t-1) + u_t.
//!
//! The residuals of a fit are less correlated than the errors, because the fit absorbs a part of slow errors; the shorter
//! the record, the greater the difference. So rho and the variance are chosen such that the expected moments of the
//! residuals M e, with the residual maker M = 1 - Q Q^T, equal the observed ones. The remaining bias of a ratio of moments,
//! 2 rho/n, is corrected (M. G. Kendall, Biometrika 41 (1954) 403; F. H. C. Marriott & J. A. Pope, ibid. 390).

use super::judgement::statistics;
use super::linear::dot;
use engine::{Wide, run_wide, subtract_multiple};

/// Least number of values for which the correlation of neighbours is estimated.
const LONG: usize = 12;
/// Greatest correlation that can be distinguished from a random walk.
pub(crate) const MOST: f64 = 0.99;
/// Step in rho of the finite difference.
const STEP: f64 = 0.005;

/// Estimated errors of one series.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Errors {
    /// Number of values.
    pub count: usize,
    /// Correlation of each error with the one before.
    pub rho: f64,
    /// Variance, in units of the weighted residuals.
    pub variance: f64,
}

impl Errors {
    /// Effective number of independent values for a mean (G. V. Bayley & J. M. Hammersley, J. R. Statist. Soc. Suppl. 8
    /// (1946) 184).
    pub fn independent(&self) -> f64 {
        let rho = self.rho.max(0.0);
        self.count as f64 * (1.0 - rho) / (1.0 + rho)
    }
}

/// Estimates from all series together.
#[derive(Clone, Debug, Default)]
pub(crate) struct Autoregression {
    /// One per series.
    pub errors: Vec<Errors>,
    /// Covariance of the coefficients of the basis, row by row.
    pub covariance: Vec<f64>,
    /// One per series: change of `covariance` for one standard deviation of its rho, row by row.
    pub doubt: Vec<Vec<f64>>,
}

impl Autoregression {
    /// Estimates from the weighted residuals of a fit. `series` holds the indices of the values of each series, in the
    /// order of time; errors of different series are assumed independent. `basis` is orthonormal and spans the columns of
    /// the Jacobian. `priors` is the contribution of rows with known errors to the covariance of the coefficients, row by
    /// row.
    pub fn new(series: &[Vec<usize>], basis: &[Vec<f64>], residuals: &[f64], priors: &[f64]) -> Self {
        let blocks: Vec<Block> = series
            .iter()
            .filter(|places| !places.is_empty())
            .map(|places| Block::at(places, basis, residuals))
            .collect();
        let mut errors: Vec<Errors> = blocks.iter().map(|block| block.errors(0.0, block.count())).collect();
        // Without correlation the products are those of the basis itself.
        let mut shares: Vec<Vec<f64>> = blocks.iter().map(|block| block.own.clone()).collect();
        // The expected residuals of one series depend on the others through the fit: three rounds are enough.
        let alone = blocks.len() == 1 && priors.iter().all(|value| *value == 0.0);
        for _ in 0..if alone { 1 } else { 3 } {
            for (place, block) in blocks.iter().enumerate() {
                let scale = 1.0 / errors[place].variance.max(f64::MIN_POSITIVE);
                let mut rest: Vec<f64> = priors.iter().map(|value| (value * scale).min(1e12)).collect();
                for (other, share) in shares.iter().enumerate().filter(|(other, _)| *other != place) {
                    let ratio = errors[other].variance / errors[place].variance.max(f64::MIN_POSITIVE);
                    rest.iter_mut().zip(share).for_each(|(rest, value)| *rest += ratio.min(1e12) * value);
                }
                (errors[place], shares[place]) = block.solve(&rest);
            }
        }
        let mut covariance = priors.to_vec();
        let mut doubt = Vec::with_capacity(blocks.len());
        for ((block, errors), share) in blocks.iter().zip(&errors).zip(&shares) {
            covariance.iter_mut().zip(share).for_each(|(sum, value)| *sum += errors.variance * value);
            // The variance of the innovations u_t is held fixed while rho changes.
            let new = errors.variance * (1.0 - errors.rho * errors.rho);
            let [low, high] = [-STEP, STEP].map(|step| (errors.rho + step).clamp(-0.995, 0.995));
            let [below, above] = [low, high].map(|rho| (block.products(rho).0, new / (1.0 - rho * rho)));
            let deviation = ((1.0 - errors.rho * errors.rho) / block.count()).sqrt() / (high - low);
            let pairs = above.0.iter().zip(&below.0);
            doubt.push(pairs.map(|(high, low)| deviation * (high * above.1 - low * below.1)).collect());
        }
        Self { errors, covariance, doubt }
    }
}

/// Residuals of one series, with an orthonormal basis of the curves fitted to it.
pub(crate) struct Block {
    residuals: Vec<f64>,
    /// Columns of the basis.
    basis: Vec<Vec<f64>>,
    /// Columns of the basis, each row replaced by half the sum of its two neighbours.
    shifted: Vec<Vec<f64>>,
    /// Inner products of the columns with each other (`own`) and with the shifted columns (`lagged`), row by row.
    own: Vec<f64>,
    lagged: Vec<f64>,
}

/// Correlation of neighbouring errors in series of the same noise, each fitted by itself. It is the rho for which the
/// expected moments of all residuals together equal the observed ones. 0 for fewer than twelve residuals beyond the fitted
/// numbers.
pub(crate) fn common_correlation<'a>(blocks: impl Iterator<Item = &'a Block>) -> f64 {
    let blocks: Vec<&Block> = blocks.collect();
    let free: usize = blocks.iter().map(|block| block.freedom()).sum();
    if free < LONG {
        return 0.0;
    }
    let series: Vec<&[f64]> = blocks.iter().map(|block| block.residuals.as_slice()).collect();
    let observed = statistics::autocorrelation(&series);
    let bias = 2.0 / blocks.iter().map(|block| block.count()).sum::<f64>();
    // Observed minus expected correlation, zero at the solution; found by the secant method.
    let missing = |rho: f64| {
        let (neighbours, squares) = blocks.iter().fold((0.0, 0.0), |sum, block| {
            let (neighbours, squares) = block.expected(rho, &vec![0.0; block.own.len()]);
            (sum.0 + neighbours, sum.1 + squares)
        });
        observed - neighbours / squares + bias * rho
    };
    let (mut before, mut rho) = (0.0, observed.clamp(-MOST, MOST));
    let mut missing_before = missing(before);
    for _ in 0..20 {
        let now = missing(rho);
        let slope = ((now - missing_before) / (rho - before)).clamp(-2.0, -0.05);
        let next = (rho - now / slope).clamp(-MOST, MOST);
        (before, missing_before) = (rho, now);
        let moved = (next - rho).abs();
        rho = next;
        if moved <= 1e-4 || moved.is_nan() {
            break;
        }
    }
    if rho.is_finite() { rho } else { 0.0 }
}

/// Subtracts from `values` their projection on each column of an orthonormal basis, one after the other.
pub(crate) fn subtract_projection<'a>(basis: impl IntoIterator<Item = &'a Vec<f64>>, values: &mut [f64]) {
    for column in basis {
        let part = dot(column, values);
        subtract_multiple(values, part, column);
    }
}

/// Orthonormal basis of columns of equal length, by Gram-Schmidt, repeated once for accuracy. Linearly dependent columns
/// are left out.
pub(crate) fn orthonormal(columns: Vec<Vec<f64>>) -> Vec<Vec<f64>> {
    let mut basis: Vec<Vec<f64>> = Vec::with_capacity(columns.len());
    for mut column in columns {
        let length = dot(&column, &column).sqrt();
        (0..2).for_each(|_| subtract_projection(&basis, &mut column));
        let left = dot(&column, &column).sqrt();
        if left > 1e-9 * length {
            column.iter_mut().for_each(|value| *value /= left);
            basis.push(column);
        }
    }
    basis
}

impl Block {
    /// Block of the entries of `residuals` and of the columns of `basis` at these indices.
    fn at(places: &[usize], basis: &[Vec<f64>], residuals: &[f64]) -> Self {
        let of = |column: &Vec<f64>| -> Vec<f64> { places.iter().map(|&place| column[place]).collect() };
        Self::new(basis.iter().map(of).collect(), places.iter().map(|&place| residuals[place]).collect())
    }

    /// Block of the residuals of a fit by the columns of an orthonormal basis, all of the same length.
    pub(crate) fn new(basis: Vec<Vec<f64>>, residuals: Vec<f64>) -> Self {
        let shifted: Vec<Vec<f64>> = basis.iter().map(|column| beside(column)).collect();
        let own = products(&basis, &basis);
        let lagged = products(&basis, &shifted);
        Self { residuals, basis, shifted, own, lagged }
    }

    /// Variance of errors with the correlation `rho`, from the sum of squared residuals.
    pub(crate) fn variance(&self, rho: f64) -> f64 {
        self.errors(rho, self.expected(rho, &vec![0.0; self.own.len()]).1).variance
    }

    /// Number of residuals minus the number of fitted columns.
    pub(crate) fn freedom(&self) -> usize {
        self.residuals.len().saturating_sub(self.basis.len())
    }

    /// Sum of the squared residuals.
    pub(crate) fn squares(&self) -> f64 {
        dot(&self.residuals, &self.residuals)
    }

    fn count(&self) -> f64 {
        self.residuals.len() as f64
    }

    /// Errors for the observed sum of squares, where `expected` is the sum expected for unit variance.
    fn errors(&self, rho: f64, expected: f64) -> Errors {
        let variance = self.squares() / expected.max(1e-6 * self.count());
        Errors { count: self.residuals.len(), rho, variance }
    }

    /// Products of the basis with its columns after [`correlated`], row by row, and the trace of the products of these with
    /// the shifted columns.
    fn products(&self, rho: f64) -> (Vec<f64>, f64) {
        let correlated = all_correlated(&self.basis, rho);
        let trace = correlated.iter().zip(&self.shifted).map(|(one, other)| dot(one, other)).sum();
        (products(&self.basis, &correlated), trace)
    }

    /// Expected sums of products of neighbouring residuals and of squares, for errors of unit variance. `rest` is the
    /// contribution of other series to the covariance of the coefficients.
    fn expected(&self, rho: f64, rest: &[f64]) -> (f64, f64) {
        self.expected_by(&self.products(rho), rho, rest)
    }

    /// [`Block::expected`] for known [`Block::products`] with this `rho`.
    fn expected_by(&self, (own, lagged): &(Vec<f64>, f64), rho: f64, rest: &[f64]) -> (f64, f64) {
        let size = self.basis.len();
        let trace = (0..size).map(|k| own[k * size + k]).sum::<f64>();
        let whole: Vec<f64> = own.iter().zip(rest).map(|(own, rest)| own + rest).collect();
        let neighbours = (self.count() - 1.0) * rho - 2.0 * lagged + dot(&whole, &self.lagged);
        (neighbours, self.count() - 2.0 * trace + dot(&whole, &self.own))
    }

    /// Errors whose expected residuals match the observed ones, by fixed-point iteration, and the products of the basis with its
    /// columns after [`correlated`] for their rho.
    fn solve(&self, rest: &[f64]) -> (Errors, Vec<f64>) {
        let count = self.count();
        let mut rho: f64 = 0.0;
        if self.residuals.len() >= LONG {
            let observed = statistics::autocorrelation(&[&self.residuals]);
            // Expected and true correlation differ by little, and the difference varies slowly with rho.
            for _ in 0..60 {
                let (neighbours, squares) = self.expected(rho, rest);
                let expected = neighbours / squares.max(1e-6 * count) - 2.0 * rho / count;
                let next = (rho + observed - expected).clamp(-MOST, MOST);
                let moved = (next - rho).abs();
                rho = next;
                if moved < 1e-5 {
                    break;
                }
            }
        }
        let products = self.products(rho);
        (self.errors(rho, self.expected_by(&products, rho, rest).1), products.0)
    }
}

/// Inner products of all pairs of columns, row by row.
fn products(one: &[Vec<f64>], other: &[Vec<f64>]) -> Vec<f64> {
    let mut products = vec![0.0; one.len() * other.len()];
    run_wide(Products { one, other, products: &mut products });
    products
}

/// Two lists of columns and [`products`] of them.
struct Products<'a> {
    one: &'a [Vec<f64>],
    other: &'a [Vec<f64>],
    products: &'a mut [f64],
}

impl Wide for Products<'_> {
    #[inline(always)]
    fn run(self) {
        for (products, one) in self.products.chunks_mut(self.other.len().max(1)).zip(self.one) {
            for (product, other) in products.iter_mut().zip(self.other) {
                *product = dot(one, other);
            }
        }
    }
}

/// Half the sum of the row before and the row after.
fn beside(column: &[f64]) -> Vec<f64> {
    let at = |row: Option<usize>| row.and_then(|row| column.get(row)).copied().unwrap_or(0.0);
    (0..column.len()).map(|row| 0.5 * (at(row.checked_sub(1)) + at(Some(row + 1)))).collect()
}

/// Sums over all rows with the weights rho^distance, that is, the product with the correlation matrix.
pub(crate) fn correlated(column: &[f64], rho: f64) -> Vec<f64> {
    let [sums] = correlated_together([column], rho);
    sums
}

/// [`correlated`] of each of the columns, all of the same length. Four columns at a time, because each sum waits for the one before.
pub(crate) fn all_correlated(columns: &[Vec<f64>], rho: f64) -> Vec<Vec<f64>> {
    let (fours, rest) = columns.as_chunks::<4>();
    let fours = fours.iter().flat_map(|four| correlated_together(four.each_ref().map(Vec::as_slice), rho));
    fours.chain(rest.iter().map(|column| correlated(column, rho))).collect()
}

fn correlated_together<const COUNT: usize>(columns: [&[f64]; COUNT], rho: f64) -> [Vec<f64>; COUNT] {
    let rows = columns.iter().map(|column| column.len()).min().unwrap_or(0);
    let mut sums = columns.map(|_| vec![0.0; rows]);
    let (mut before, mut after) = ([0.0; COUNT], [0.0; COUNT]);
    for row in 0..rows {
        for place in 0..COUNT {
            before[place] = columns[place][row] + rho * before[place];
            sums[place][row] = before[place];
        }
    }
    for row in (0..rows).rev() {
        for place in 0..COUNT {
            sums[place][row] += rho * after[place];
            after[place] = columns[place][row] + rho * after[place];
        }
    }
    sums
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The sums for three values 1, 2, 4 written out.
    #[test]
    fn correlated_sums() {
        let found = correlated(&[1.0, 2.0, 4.0], 0.5);
        assert_eq!(found, [1.0 + 1.0 + 1.0, 0.5 + 2.0 + 2.0, 0.25 + 1.0 + 4.0]);
        // Five columns: four together, and one.
        let columns: Vec<Vec<f64>> =
            (1..=5).map(|factor| [1.0, 2.0, 4.0].map(|one| one * f64::from(factor)).to_vec()).collect();
        for (column, sums) in columns.iter().zip(all_correlated(&columns, 0.5)) {
            assert_eq!(sums, correlated(column, 0.5));
        }
        assert_eq!(beside(&[1.0, 2.0, 4.0]), [1.0, 2.5, 1.0]);
    }

    /// n (1 - rho)/(1 + rho); anticorrelation adds none.
    #[test]
    fn independent_values_of_a_series() {
        for (rho, expected) in [(0.5, 20.0), (0.2, 40.0), (-0.5, 60.0)] {
            let errors = Errors { count: 60, rho, variance: 1.0 };
            assert!((errors.independent() - expected).abs() < 1e-12, "{rho}: {}", errors.independent());
        }
    }

    /// The mean of n values: rho = 0 gives the usual variance over n.
    #[test]
    fn alternating_values_about_a_mean() {
        let count = 40;
        let basis = vec![vec![1.0 / (count as f64).sqrt(); count]];
        let residuals: Vec<f64> = (0..count).map(|row| if row % 4 < 2 { 1.0 } else { -1.0 }).collect();
        let found = Autoregression::new(&[(0..count).collect()], &basis, &residuals, &[0.0]);
        // The correlation of these is 1/40; that of values about their mean is less by about as much.
        assert!((0.03..0.07).contains(&found.errors[0].rho), "{found:?}");
        assert!((found.errors[0].variance / (40.0 / 39.0) - 1.0).abs() < 0.01, "{found:?}");
    }
}
