//! Values that do not belong to the others: residuals far beyond the scatter of the rest.
//!
//! One value that is off pulls the fit towards itself, so that its own residual shrinks and those of its neighbours become
//! systematic. So the most conspicuous value is taken out, the fit without it follows (exactly, where the curve is linear in
//! what is varied; Cook & Weisberg, Residuals and Influence in Regression, 1982, section 2.2), and the rest is judged
//! again.

use crate::fit::uncertainty::student::student;
use crate::order::median;

/// How probable it is that a record whose errors are normal gets a value named.
const BY_CHANCE: f64 = 0.005;
/// No more values than this are named.
const MOST: usize = 50;
/// A series of fewer values is not judged.
const LEAST: usize = 8;
/// Makes a standard deviation of the median of absolute normal values.
pub(crate) const NORMAL: f64 = 1.482_602_218_505_602;
/// A scale from n values, the greater one of that of all and that of the rows nearby, is known as well as a standard deviation
/// from this part of them. Found by trial: of clean records of 12 to 1,000 values, with the noise of an autoregressive process
/// of -0.5 to 0.95, 0 to 0.6 per cent get a value named.
const EFFICIENCY: f64 = 0.7;
/// Rows to either side whose scatter is what a value is compared with, if it is greater than that of all.
const NEAR: usize = 15;

/// A value that is off.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Off {
    /// Its place among the residuals.
    pub place: usize,
    /// Its distance from where the others leave it, in standard deviations, with the sign of its residual.
    pub sigmas: f64,
}

/// Residuals to be judged.
pub(crate) struct Judged<'a> {
    /// The places of each series, in the order of time.
    pub series: &'a [Vec<usize>],
    /// An orthonormal basis of the columns of the Jacobian, column by column; empty where the fit was not pulled.
    pub basis: &'a [Vec<f64>],
    /// By series: scatter below this is rounding.
    pub floors: &'a [f64],
}

impl Judged<'_> {
    /// Finds the values that are off. `residuals` become those of the fit without them.
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
        // What was taken out because of another one's pull is put back by its distance from the final fit.
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

/// The fit without some of its values.
struct Removal<'a> {
    basis: &'a [Vec<f64>],
    /// By place.
    removed: Vec<bool>,
    /// How much of its own error each value takes out of its residual.
    leverage: Vec<f64>,
    /// The inverse of the normal matrix of what is left, in the basis, row by row.
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

    /// Takes a value out; false where nothing else determines what it determines.
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

    /// The standard deviation of a residual, over that of the errors.
    fn spread(&self, place: usize) -> f64 {
        let leverage = self.leverage[place];
        if self.removed[place] { (1.0 + leverage).sqrt() } else { (1.0 - leverage).max(1e-3).sqrt() }
    }
}

/// The value of a series that is most off, and its distance over the threshold.
fn conspicuous(series: &[usize], floor: f64, residuals: &[f64], removal: &Removal) -> Option<(usize, f64)> {
    if series.len() < LEAST {
        return None;
    }
    let judge = Judge::new(series, floor, residuals, removal);
    let kept = (0..series.len()).filter(|row| !removal.removed[series[*row]]);
    let (row, _) = kept.map(|row| (row, judge.distances[row].abs())).max_by(|one, other| one.1.total_cmp(&other.1))?;
    Some((series[row], judge.distance(row, residuals, removal).abs() / judge.threshold))
}

/// What the values of a series are compared with.
struct Judge<'a> {
    series: &'a [usize],
    /// The correlation of neighbours, 0 unless it is beyond doubt.
    rho: f64,
    /// By row: the distance from what the neighbours and the fit let expect, in units of the errors.
    distances: Vec<f64>,
    /// Their standard deviation.
    scale: f64,
    /// So many standard deviations are beyond chance.
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
        // What the fit has adjusted to, each value in part.
        let used: f64 =
            series.iter().filter(|place| !removal.removed[**place]).map(|place| removal.leverage[*place]).sum();
        judge.scale = (NORMAL * median(sizes)).max(floor);
        let known = if rho > 0.0 { 0.6 } else { 1.0 };
        judge.threshold = student(BY_CHANCE / count, (EFFICIENCY * known * (count - used)).max(1.0));
        judge
    }

    /// A residual less what its neighbours, so far as they resemble it, let expect of it (the interpolation of an
    /// autoregressive process of order one), over its standard deviation relative to that of the errors.
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

    /// The distance of a row in standard deviations: of the scatter of all, or of the rows about it where these scatter more.
    fn distance(&self, row: usize, residuals: &[f64], removal: &Removal) -> f64 {
        let near = row.saturating_sub(NEAR)..(row + NEAR + 1).min(self.series.len());
        let others = near.filter(|other| *other != row && !removal.removed[self.series[*other]]);
        let local = NORMAL * median(others.map(|row| self.distances[row].abs()).collect());
        self.expected_distance(row, residuals, removal) / self.scale.max(local)
    }
}

/// The correlation of each value with the one before, by their signs alone (the quadrant correlation: Blomqvist, Ann. Math.
/// Statist. 21 (1950) 593): no single value can change it. 0 unless it is positive beyond doubt.
fn resemblance(values: &[f64]) -> f64 {
    let pairs = values.windows(2).filter(|pair| pair[0] * pair[1] != 0.0);
    let (count, sum) = pairs.fold((0.0, 0.0), |(count, sum), pair| (count + 1.0, sum + (pair[0] * pair[1]).signum()));
    let quadrants: f64 = if count > 0.0 { sum / count } else { 0.0 };
    if quadrants < 2.6 / f64::max(count, 1.0).sqrt() {
        return 0.0;
    }
    libm::sin(core::f64::consts::FRAC_PI_2 * quadrants).min(0.99)
}
