//! Outliers: residuals far beyond the scatter of the rest.
//!
//! An outlier pulls the fit towards itself, so that its own residual shrinks and those of its neighbours become systematic.
//! So the most conspicuous value is removed, the residuals of the fit without it are computed (exactly, if the curve is
//! linear in the varied numbers; Cook & Weisberg, Residuals and Influence in Regression, 1982, section 2.2), and the rest
//! is judged again.

use crate::fit::uncertainty::student::student;
use units::order::median;

/// Probability that any value of a record with normal errors is reported as an outlier.
const BY_CHANCE: f64 = 0.005;
/// Upper bound of the number of outliers.
const MOST: usize = 50;
/// Least length of a series to be judged.
const LEAST: usize = 8;
/// Standard deviation of normal values divided by the median of their absolute values.
pub(crate) const NORMAL: f64 = 1.482_602_218_505_602;
/// Effective share of the values in the scale. The greater one of the scales of all n values and of the rows nearby is as
/// uncertain as a standard deviation from this share of n. Found by trial: in 0 to 0.6 per cent of clean records of 12 to
/// 1,000 values, with autoregressive noise of -0.5 to 0.95, a value is reported.
const EFFICIENCY: f64 = 0.7;
/// Rows to either side for the local scatter, which is used if it is greater than that of all.
const NEAR: usize = 15;

/// Outlier among the residuals.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Off {
    /// Index among the residuals.
    pub place: usize,
    /// Distance from the value expected from the others, in standard deviations, with the sign of its residual.
    pub sigmas: f64,
}

/// Residuals to be judged.
pub(crate) struct Judged<'a> {
    /// Indices of the residuals of each series, in the order of time.
    pub series: &'a [Vec<usize>],
    /// Orthonormal basis of the columns of the Jacobian; empty for a robust loss, where outliers do not pull the fit.
    pub basis: &'a [Vec<f64>],
    /// One per series: scatter below this is rounding.
    pub floors: &'a [f64],
}

impl Judged<'_> {
    /// Finds the outliers. `residuals`, weighted, one per fitted value, become those of the fit without them.
    pub fn outliers(&self, residuals: &mut [f64]) -> Vec<Off> {
        let mut removal = Removal::new(self.basis, residuals.len());
        let mut off = Vec::new();
        while off.len() < MOST {
            let worst = (self.series.iter().zip(self.floors))
                .filter_map(|(series, floor)| conspicuous(series, *floor, residuals, &removal))
                .max_by(|one, other| one.1.total_cmp(&other.1));
            let Some((place, _)) = worst.filter(|worst| worst.1 > 1.0) else { break };
            if !removal.remove(place, residuals) {
                break;
            }
            off.push(place);
        }
        // A value removed only because another one pulled the fit is restored if it is close to the final fit.
        let mut found = Vec::new();
        for (series, floor) in self.series.iter().zip(self.floors) {
            let judge = Judge::new(series, *floor, residuals, &removal);
            for (row, &place) in series.iter().enumerate().filter(|(_, place)| off.contains(place)) {
                if judge.distance(row, residuals, &removal).abs() > judge.threshold {
                    let sigmas = judge.expected_distance(row, residuals, &removal) / judge.scale;
                    found.push(Off { place, sigmas });
                } else {
                    removal.removed[place] = false;
                }
            }
        }
        found
    }
}

/// Fit without some of its values.
struct Removal<'a> {
    basis: &'a [Vec<f64>],
    /// One per residual: true if removed.
    removed: Vec<bool>,
    /// Leverage of each value: the part of its own error that the fit absorbs.
    leverage: Vec<f64>,
    /// Inverse of the normal matrix of the remaining values in the basis, row by row.
    inverse: Vec<f64>,
}

impl<'a> Removal<'a> {
    fn new(basis: &'a [Vec<f64>], rows: usize) -> Self {
        let size = basis.len();
        let mut inverse = vec![0.0; size * size];
        (0..size).for_each(|k| inverse[k * size + k] = 1.0);
        let leverage = (0..rows).map(|row| basis.iter().map(|column| column[row] * column[row]).sum()).collect();
        Self { basis, removed: vec![false; rows], leverage, inverse }
    }

    /// Removes a value. Returns false if its leverage is so large that the fit would be undetermined without it.
    fn remove(&mut self, place: usize, residuals: &mut [f64]) -> bool {
        let size = self.basis.len();
        let left = 1.0 - self.leverage[place];
        if left < 1e-3 {
            return false;
        }
        self.removed[place] = true;
        let along: Vec<f64> =
            (0..size).map(|k| (0..size).map(|l| self.inverse[k * size + l] * self.basis[l][place]).sum()).collect();
        let shift = residuals[place] / left;
        for row in 0..residuals.len() {
            let pull: f64 = self.basis.iter().zip(&along).map(|(column, along)| column[row] * along).sum();
            residuals[row] += pull * shift;
            self.leverage[row] += pull * pull / left;
        }
        for k in 0..size {
            for l in 0..size {
                self.inverse[k * size + l] += along[k] * along[l] / left;
            }
        }
        true
    }

    /// Standard deviation of a residual relative to that of the errors.
    fn spread(&self, place: usize) -> f64 {
        let leverage = self.leverage[place];
        if self.removed[place] { (1.0 + leverage).sqrt() } else { (1.0 - leverage).max(1e-3).sqrt() }
    }
}

/// Index of the value of a series farthest from the others, and its distance divided by the threshold.
fn conspicuous(series: &[usize], floor: f64, residuals: &[f64], removal: &Removal) -> Option<(usize, f64)> {
    if series.len() < LEAST {
        return None;
    }
    let judge = Judge::new(series, floor, residuals, removal);
    let kept = (0..series.len()).filter(|row| !removal.removed[series[*row]]);
    let (row, _) = kept.map(|row| (row, judge.distances[row].abs())).max_by(|one, other| one.1.total_cmp(&other.1))?;
    Some((series[row], judge.distance(row, residuals, removal).abs() / judge.threshold))
}

/// Reference for the values of a series.
struct Judge<'a> {
    series: &'a [usize],
    /// Correlation of neighbours, 0 unless significant.
    rho: f64,
    /// One per row: distance from the value expected from the neighbours and the fit, in units of the errors.
    distances: Vec<f64>,
    /// Standard deviation of the distances.
    scale: f64,
    /// Distance beyond chance, in standard deviations.
    threshold: f64,
}

impl<'a> Judge<'a> {
    fn new(series: &'a [usize], floor: f64, residuals: &[f64], removal: &Removal) -> Self {
        let kept: Vec<f64> =
            series.iter().filter(|place| !removal.removed[**place]).map(|place| residuals[*place]).collect();
        let rho = resemblance(&kept);
        let mut judge = Self { series, rho, distances: Vec::new(), scale: 0.0, threshold: 0.0 };
        judge.distances = (0..series.len()).map(|row| judge.expected_distance(row, residuals, removal)).collect();
        let kept = (0..series.len()).filter(|row| !removal.removed[series[*row]]);
        let sizes: Vec<f64> = kept.map(|row| judge.distances[row].abs()).collect();
        let count = sizes.len() as f64;
        // Number of parameters that the fit adjusts to these values: the sum of their leverages.
        let used: f64 =
            series.iter().filter(|place| !removal.removed[**place]).map(|place| removal.leverage[*place]).sum();
        judge.scale = (NORMAL * median(sizes)).max(floor);
        let known = if rho > 0.0 { 0.6 } else { 1.0 };
        judge.threshold = student(BY_CHANCE / count, (EFFICIENCY * known * (count - used)).max(1.0));
        judge
    }

    /// Residual minus the value expected from its correlated neighbours (interpolation of a first-order autoregressive
    /// process), divided by its standard deviation relative to that of the errors.
    fn expected_distance(&self, row: usize, residuals: &[f64], removal: &Removal) -> f64 {
        let place = self.series[row];
        let neighbour = |row: Option<usize>| {
            let place = *self.series.get(row?)?;
            Some(residuals[place]).filter(|_| !removal.removed[place])
        };
        let square = self.rho * self.rho;
        let (expected, variance) = match (neighbour(row.checked_sub(1)), neighbour(Some(row + 1))) {
            _ if self.rho == 0.0 => (0.0, 1.0),
            (Some(before), Some(after)) => {
                (self.rho / (1.0 + square) * (before + after), (1.0 - square) / (1.0 + square))
            }
            (Some(one), None) | (None, Some(one)) => (self.rho * one, 1.0 - square),
            (None, None) => (0.0, 1.0),
        };
        (residuals[place] - expected) / (variance.sqrt() * removal.spread(place))
    }

    /// Distance of a row in standard deviations: of all rows, or of the rows nearby if these scatter more.
    fn distance(&self, row: usize, residuals: &[f64], removal: &Removal) -> f64 {
        let near = row.saturating_sub(NEAR)..(row + NEAR + 1).min(self.series.len());
        let others = near.filter(|other| *other != row && !removal.removed[self.series[*other]]);
        let local = NORMAL * median(others.map(|row| self.distances[row].abs()).collect());
        self.expected_distance(row, residuals, removal) / self.scale.max(local)
    }
}

/// Correlation of each value with the one before, from their signs alone (quadrant correlation: Blomqvist, Ann. Math. Statist.
/// 21 (1950) 593), so that no single value can change it much. 0 unless significantly positive.
fn resemblance(values: &[f64]) -> f64 {
    let pairs = values.windows(2).filter(|pair| pair[0] * pair[1] != 0.0);
    let (count, sum) = pairs.fold((0.0, 0.0), |(count, sum), pair| (count + 1.0, sum + (pair[0] * pair[1]).signum()));
    let quadrants: f64 = if count > 0.0 { sum / count } else { 0.0 };
    if quadrants < 2.6 / f64::max(count, 1.0).sqrt() {
        return 0.0;
    }
    libm::sin(core::f64::consts::FRAC_PI_2 * quadrants).min(0.99)
}

#[cfg(test)]
mod tests {
    use super::Removal;

    /// Residuals of the line through the values that are kept, at all times, and the leverages of all times in it: 1/m + (t - mean)^2
    /// / sum, in closed form.
    fn line(times: &[f64], values: &[f64], removed: &[bool]) -> (Vec<f64>, Vec<f64>) {
        let kept: Vec<(f64, f64)> =
            times.iter().zip(values).zip(removed).filter(|one| !one.1).map(|one| (*one.0.0, *one.0.1)).collect();
        let count = kept.len() as f64;
        let mean_time = kept.iter().map(|one| one.0).sum::<f64>() / count;
        let mean = kept.iter().map(|one| one.1).sum::<f64>() / count;
        let square: f64 = kept.iter().map(|one| (one.0 - mean_time) * (one.0 - mean_time)).sum();
        let slope = kept.iter().map(|one| (one.0 - mean_time) * (one.1 - mean)).sum::<f64>() / square;
        let residuals =
            times.iter().zip(values).map(|(time, value)| value - mean - slope * (time - mean_time)).collect();
        (residuals, times.iter().map(|time| 1.0 / count + (time - mean_time) * (time - mean_time) / square).collect())
    }

    #[test]
    fn values_are_removed_as_from_a_fit_to_the_others() {
        let times = [0.0, 1.0, 2.5, 3.0, 4.0, 6.0, 6.5, 9.0];
        let values = [1.0, 2.5, 0.0, 7.0, 4.0, 30.0, 5.5, 8.0];
        let mean = times.iter().sum::<f64>() / 8.0;
        let length = times.iter().map(|time| (time - mean) * (time - mean)).sum::<f64>().sqrt();
        let basis = [vec![0.125_f64.sqrt(); 8], times.iter().map(|time| (time - mean) / length).collect()];
        let mut removal = Removal::new(&basis, 8);
        let mut residuals = line(&times, &values, &[false; 8]).0;
        for place in [5, 3, 2] {
            assert!(removal.remove(place, &mut residuals));
            let (expected, leverage) = line(&times, &values, &removal.removed);
            for row in 0..8 {
                assert!((residuals[row] - expected[row]).abs() < 1e-12, "{row} without {place}: {}", residuals[row]);
                assert!((removal.leverage[row] - leverage[row]).abs() < 1e-12, "leverage of {row} without {place}");
                // A value that took part is nearer to the line than its own error, one that did not is farther away.
                let part = if removal.removed[row] { 1.0 + leverage[row] } else { 1.0 - leverage[row] };
                assert!((removal.spread(row) - part.sqrt()).abs() < 1e-12, "spread of {row} without {place}");
            }
        }
    }
}
