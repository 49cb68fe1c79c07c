//! Which part of the strip shows the bore: the part that changes in time.

use crate::tracking::column::strip::{Grid, Strip};

/// A bin belongs to the bore if its variance in time is at least this part of the greatest one.
const LEAST: f64 = 0.3;

/// Sums over time of every value of the strip.
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

    /// The bins of the bore, from the first to before the last, around the one in the middle.
    ///
    /// The variance of each value in time, less that of the quietest rows (noise and flicker), is summed over the rows.
    pub(crate) fn bore(&self, grid: Grid) -> (usize, usize) {
        let change: Vec<f64> = (0..grid.bins).map(|bin| self.change(grid, bin)).collect();
        let middle = grid.bins / 2;
        // A click is a few pixels beside the axis at most.
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
        rows.sort_by(f64::total_cmp);
        let quiet = rows.get(rows.len() / 5).copied().unwrap_or(0.0);
        rows.iter().map(|value| value - quiet).sum()
    }
}
