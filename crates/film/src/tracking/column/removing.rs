//! Subtraction of a reflection from the strips.

use crate::tracking::column::reflection::Reflection;
use crate::tracking::column::strip::{Grid, Strip};

/// State of the subtraction, in steps of one frame.
pub(crate) struct Removing {
    reflection: Reflection,
    grid: Grid,
    /// Range of the bins of the bore.
    bins: (usize, usize),
    /// Sum over the frames of the grey values without the reflection, for each row and bin of the bore.
    sums: Vec<f64>,
    /// Sums for the fraction of the light of the channel in each bin.
    parts: Vec<(f64, f64)>,
    strips: Vec<Strip>,
    at: usize,
}

impl Removing {
    pub(crate) fn new(reflection: Reflection, grid: Grid, bins: (usize, usize)) -> Removing {
        let width = bins.1 - bins.0;
        Removing {
            reflection,
            grid,
            bins,
            sums: vec![0.0; grid.rows * width],
            parts: vec![(0.0, 0.0); width],
            strips: Vec::new(),
            at: 0,
        }
    }

    /// Does the work of one frame. Returns the strips at the end.
    pub(crate) fn step(&mut self, strips: &[Strip]) -> Option<Vec<Strip>> {
        let (grid, bins, width) = (self.grid, self.bins, self.bins.1 - self.bins.0);
        let at = self.at;
        self.at += 1;
        let Some(strip) = strips.get(at % strips.len().max(1)).filter(|_| at < 3 * strips.len()) else {
            return Some(std::mem::take(&mut self.strips));
        };
        let frame = at % strips.len();
        let rows = if at < strips.len() { 0..grid.rows } else { self.reflection.around(frame, grid.rows) };
        let mut cleaned = (at >= 2 * strips.len()).then(|| strip.clone());
        for row in rows {
            for (bin, value) in strip.values(grid, row, bins).enumerate() {
                let light = self.reflection.at(frame, row, (bin, width));
                let sum = &mut self.sums[row * width + bin];
                if at < strips.len() {
                    *sum += value - light;
                } else if let Some(cleaned) = &mut cleaned {
                    let (product, square) = self.parts[bin];
                    let part = if square > 0.0 { product / square } else { 0.0 };
                    cleaned.set(grid, (row, bins.0 + bin), value - part * light);
                } else {
                    let (product, square) = &mut self.parts[bin];
                    *product += light * (value - *sum / strips.len() as f64);
                    *square += light * light;
                }
            }
        }
        self.strips.extend(cleaned);
        None
    }
}
