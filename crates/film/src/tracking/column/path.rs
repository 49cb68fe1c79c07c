//! Path of the surface through the space-time picture: the sequence of rows with the least total cost (Viterbi, *IEEE
//! Trans. Inf. Theory* 13 (1967) 260).

use crate::tracking::median::median;

/// Cost of rows outside an anchor.
const FORBIDDEN: f32 = 1e6;
/// Minimum strength of a profile, relative to the median of the strongest ones. It prevents that noise in a uniform
/// area resembles the template.
const FLOOR: f64 = 0.3;
/// Sign of an `f32`.
const SIGN: u32 = 1 << 31;

/// Strength of a profile around each row: square root of the sum of squared deviations from the mean.
pub(crate) fn strengths(profile: &[f32], half: usize) -> Vec<f64> {
    let windows = |squares: bool| {
        let value = move |row: i64| {
            let value = f64::from(at(profile, row));
            if squares { value * value } else { value }
        };
        let half = half as i64;
        let mut sum: f64 = (-half..=half).map(value).sum();
        (0..profile.len() as i64).map(move |row| {
            let now = sum;
            sum += value(row + half + 1) - value(row - half);
            now
        })
    };
    let count = (2 * half + 1) as f64;
    windows(false).zip(windows(true)).map(|(sum, squares)| (squares - sum * sum / count).max(0.0).sqrt()).collect()
}

/// Value of a row; beyond the ends, that of the last row.
fn at(profile: &[f32], row: i64) -> f32 {
    let last = profile.len().saturating_sub(1);
    profile.get(usize::try_from(row).unwrap_or(0).min(last)).copied().unwrap_or(0.0)
}

/// Profile around a row with mean 0 and norm 1; `None` if it is uniform.
fn template(profile: &[f32], row: f64, half: usize) -> Option<Vec<f32>> {
    let middle = row.round() as i64;
    let mut values: Vec<f32> = (-(half as i64)..=half as i64).map(|k| at(profile, middle + k)).collect();
    let mean = values.iter().sum::<f32>() / values.len() as f32;
    values.iter_mut().for_each(|value| *value -= mean);
    let norm = values.iter().map(|value| value * value).sum::<f32>().sqrt();
    if norm < 1.0 {
        return None;
    }
    values.iter_mut().for_each(|value| *value /= norm);
    Some(values)
}

/// Profile that is sought in others.
pub(crate) struct Template {
    values: Vec<f32>,
    floor: f64,
}

impl Template {
    /// Template from the profile around a clicked row; `None` if it is uniform. `strongest`: largest strength in each
    /// frame.
    pub(crate) fn new(profile: &[f32], row: f64, half: usize, strongest: &[f64]) -> Option<Template> {
        let floor = (FLOOR * median(strongest.to_vec())).max(1e-3);
        Some(Template { values: template(profile, row, half)?, floor })
    }

    /// Cost of each row: 0 if the profile around it equals the template, 2 if it is the opposite.
    pub(crate) fn costs(&self, profile: &[f32]) -> Vec<f32> {
        let half = self.values.len() / 2;
        let cost = |(row, strength): (usize, f64)| {
            let start = row as i64 - half as i64;
            let product: f32 = if start >= 0 && row + half < profile.len() {
                self.values.iter().zip(&profile[start as usize..]).map(|(a, b)| a * b).sum()
            } else {
                self.values.iter().zip(start..).map(|(a, k)| a * at(profile, k)).sum()
            };
            1.0 - (f64::from(product) / strength.max(self.floor)) as f32
        };
        strengths(profile, half).into_iter().enumerate().map(cost).collect()
    }
}

/// Search for the path, frame by frame.
pub(crate) struct Search {
    /// Cost of a step by one row.
    step: f32,
    /// Least total cost up to each row of the previous frame.
    costs: Vec<f32>,
    /// Predecessor of each row, for each frame.
    before: Vec<Vec<u16>>,
    window: Sliding,
}

impl Search {
    pub(crate) fn new(rows: usize, step: f32) -> Search {
        Search { step, costs: vec![0.0; rows], before: Vec::new(), window: Sliding::default() }
    }

    /// Takes the costs of the rows in the next frame. `reach`: maximum motion since the previous frame, rows; `fixed`:
    /// first and last row of an anchor.
    pub(crate) fn take(&mut self, costs: &[f32], reach: usize, fixed: Option<(usize, usize)>) {
        let before = self.nearest(reach);
        for (row, sum) in self.costs.iter_mut().enumerate() {
            let outside = fixed.is_some_and(|(first, last)| row < first || row > last);
            *sum += if outside { FORBIDDEN } else { costs.get(row).copied().unwrap_or(FORBIDDEN) };
        }
        self.before.push(before);
    }

    /// Replaces the cost of each row by the least cost of reaching it from a row at most `reach` away. Returns that row.
    ///
    /// The cost of a step is proportional to its length, so that a sliding minimum in both directions suffices.
    fn nearest(&mut self, reach: usize) -> Vec<u16> {
        let rows = self.costs.len();
        // Cost relative to a start at the first row, so that differences are costs of steps.
        let relative = |(step, cost): (usize, &f32)| key(cost - self.step * step as f32, step);
        let downwards = self.window.minima(self.costs.iter().enumerate().map(relative), reach);
        let found: Vec<(f32, u16)> = downwards
            .iter()
            .enumerate()
            .map(|(step, least)| {
                let (value, old) = parts(*least);
                (value + self.step * step as f32, old)
            })
            .collect();
        let upwards = self.window.minima(self.costs.iter().rev().enumerate().map(relative), reach);
        let mut before = vec![0; rows];
        let places = self.costs.iter_mut().zip(&mut before).zip(found).rev();
        for ((step, least), ((cost, before), down)) in upwards.iter().enumerate().zip(places) {
            let (value, old) = parts(*least);
            let up = (value + self.step * step as f32, rows as u16 - 1 - old);
            (*cost, *before) = if up.0 < down.0 { up } else { down };
        }
        before
    }

    /// Least total cost up to each row of the last frame.
    pub(crate) fn sums(&self) -> &[f32] {
        &self.costs
    }

    /// Row of the surface in each frame.
    pub(crate) fn path(&self) -> Vec<usize> {
        let cheapest = self.costs.iter().enumerate().min_by(|a, b| a.1.total_cmp(b.1));
        let mut row = cheapest.map_or(0, |(row, _)| row);
        let mut path = Vec::with_capacity(self.before.len());
        for before in self.before.iter().rev() {
            path.push(row);
            row = before.get(row).copied().map_or(0, usize::from);
        }
        path.reverse();
        path
    }
}

/// Sliding minimum (van Herk, *Pattern Recognition Lett.* 13 (1992) 517), with its buffers.
#[derive(Default)]
struct Sliding {
    keys: Vec<u64>,
    /// Minimum from each place to the end of its block.
    suffixes: Vec<u64>,
}

impl Sliding {
    /// Least key from `reach` places before each place up to it.
    fn minima(&mut self, keys: impl Iterator<Item = u64>, reach: usize) -> &[u64] {
        self.keys.clear();
        self.keys.extend(keys);
        let reach = reach.min(self.keys.len());
        self.suffixes.clone_from(&self.keys);
        for block in self.suffixes.chunks_mut(reach + 1) {
            let mut least = u64::MAX;
            for suffix in block.iter_mut().rev() {
                least = least.min(*suffix);
                *suffix = least;
            }
        }
        for block in self.keys.chunks_mut(reach + 1) {
            let mut least = u64::MAX;
            for key in block {
                least = least.min(*key);
                *key = least;
            }
        }
        let ends = self.keys.get_mut(reach..).unwrap_or_default();
        ends.iter_mut().zip(&self.suffixes).for_each(|(least, suffix)| *least = (*suffix).min(*least));
        &self.keys
    }
}

/// Key in the order of a cost and then of a row.
fn key(cost: f32, row: usize) -> u64 {
    let bits = cost.to_bits();
    // Negative numbers have the opposite order of their bits.
    let order = bits ^ ((bits as i32 >> 31) as u32 | SIGN);
    u64::from(order) << 32 | row as u64
}

/// Cost and row of a key.
fn parts(key: u64) -> (f32, u16) {
    let order = (key >> 32) as u32;
    let bits = order ^ (!(order as i32 >> 31) as u32 | SIGN);
    (f32::from_bits(bits), key as u16)
}
