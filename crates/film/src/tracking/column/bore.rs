//! Detection of the bore: the part of the strip that changes in time.

use crate::tracking::column::strip::{Grid, Strip};
use units::order::sort_numbers;

/// Minimum variance in time of a bin of the bore, relative to the largest one.
const LEAST: f64 = 0.3;

/// Sums over time of each value of the strip, and of its square.
pub(crate) struct Changes {
    sums: Vec<(f64, f64)>,
    frames: f64,
}

impl Changes {
    pub(crate) fn new(grid: Grid) -> Changes {
        Changes { sums: vec![(0.0, 0.0); grid.rows * grid.bins], frames: 0.0 }
    }

    pub(crate) fn take(&mut self, strip: &Strip) {
        for (sum, value) in self.sums.iter_mut().zip(&strip.grey) {
            let value = f64::from(*value);
            sum.0 += value;
            sum.1 += value * value;
        }
        self.frames += 1.0;
    }

    /// Range of the bins of the bore, around the middle one.
    ///
    /// The criterion is the variance in time, summed over the rows. The variance of a quiet row (noise and flicker, the
    /// 0.2 quantile) is subtracted.
    pub(crate) fn bore(&self, grid: Grid) -> (usize, usize) {
        let change: Vec<f64> = (0..grid.bins).map(|bin| self.change(grid, bin)).collect();
        let middle = grid.bins / 2;
        // A click is at most a few pixels beside the axis.
        let near = middle.saturating_sub(grid.bins / 4)..(middle + grid.bins / 4 + 1).min(grid.bins);
        let peak = near.max_by(|a, b| change[*a].total_cmp(&change[*b])).unwrap_or(middle);
        let enough = |bin: &usize| change.get(*bin).is_some_and(|value| *value >= LEAST * change[peak]);
        let first = (0..=peak).rev().take_while(enough).last().unwrap_or(peak);
        let last = (peak..grid.bins).take_while(enough).last().unwrap_or(peak);
        (first, last + 1)
    }

    fn change(&self, grid: Grid, bin: usize) -> f64 {
        let variance = |(sum, squares): &(f64, f64)| squares / self.frames - (sum / self.frames) * (sum / self.frames);
        let mut rows: Vec<f64> = self.sums.iter().skip(bin).step_by(grid.bins).map(variance).collect();
        sort_numbers(&mut rows);
        let quiet = rows.get(rows.len() / 5).copied().unwrap_or(0.0);
        rows.iter().map(|value| value - quiet).sum()
    }
}
