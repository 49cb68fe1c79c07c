//! Pattern and background of the surface, fitted together.

use crate::tracking::column::pattern::{Pattern, Pose, Weights};
use crate::tracking::column::strip::Strip;
use crate::tracking::linear::Banded;

/// Minimum number of frames that show a row with a background.
const SHOWN: usize = 4;
/// Penalty on the squares of the background, relative to the weight of a frame: a constant may belong to pattern or background.
const RIDGE: f64 = 1e-4;

/// Normal equations of pattern and background. All bins have the same matrix.
pub(crate) struct Together {
    pattern: Pattern,
    /// Products of the knots.
    matrix: Banded,
    /// Right-hand sides, one per knot and bin.
    sides: Vec<f64>,
    /// Rows of the strip.
    still: Vec<Still>,
    /// Sum of the squared grey values relative to the offsets.
    squares: f64,
    weights: Weights,
}

/// Normal equation of the background in a row.
#[derive(Clone, Default)]
struct Still {
    /// Number of frames that show the row.
    frames: usize,
    weight: f64,
    /// Products with the knots.
    knots: Vec<f64>,
    /// Right-hand sides, one per bin.
    sides: Vec<f64>,
}

/// Sum of the squared residuals, and the background: one value per row of the strip and bin.
#[derive(Clone, Debug)]
pub(crate) struct Explained {
    pub left: f64,
    pub background: Vec<f64>,
}

impl Together {
    /// Equations without frames, for a pattern of these knots.
    pub(crate) fn new(pattern: &Pattern) -> Together {
        Together {
            matrix: pattern.equations(),
            sides: vec![0.0; pattern.knots() * pattern.window.width()],
            still: vec![Still::default(); pattern.window.grid.rows],
            squares: 0.0,
            weights: Weights::default(),
            pattern: pattern.clone(),
        }
    }

    /// Adds a frame.
    pub(crate) fn take(&mut self, strip: &Strip, pose: &Pose) {
        let (window, knots) = (self.pattern.window, self.pattern.knots());
        let width = window.width();
        let (matrix, sides, rows, squares) = (&mut self.matrix, &mut self.sides, &mut self.still, &mut self.squares);
        let square = pose.gain * pose.gain;
        self.pattern.rows(pose, &mut self.weights, |row, Weights { first, values: weights, .. }| {
            let still = &mut rows[row];
            still.knots.resize(knots, 0.0);
            still.sides.resize(width, 0.0);
            still.frames += 1;
            still.weight += square;
            for (k, weight) in weights.iter().enumerate() {
                still.knots[first + k] += square * weight;
                for (j, other) in weights.iter().enumerate().skip(k) {
                    matrix.add(first + k, first + j, square * weight * other);
                }
            }
            for (bin, value) in strip.values(window.grid, row, window.bins).enumerate() {
                let value = value - pose.offset;
                *squares += value * value;
                still.sides[bin] += pose.gain * value;
                for (k, weight) in weights.iter().enumerate() {
                    sides[(first + k) * width + bin] += pose.gain * weight * value;
                }
            }
        });
    }

    /// Solves the equations; `None` if they are singular.
    pub(crate) fn explained(mut self) -> Option<Explained> {
        let (width, knots) = (self.pattern.window.width(), self.pattern.knots());
        let mut left = self.squares;
        self.pattern.smooth(&mut self.matrix);
        // The background of each row is eliminated.
        let is_shown = |still: &Still| still.frames >= SHOWN;
        for still in self.still.iter().filter(|still| is_shown(still)) {
            let weight = still.weight + RIDGE;
            for (k, product) in still.knots.iter().enumerate().filter(|(_, product)| **product != 0.0) {
                let part = product / weight;
                still.knots.iter().enumerate().skip(k).for_each(|(j, other)| self.matrix.add(k, j, -part * other));
                let sides = &mut self.sides[k * width..(k + 1) * width];
                sides.iter_mut().zip(&still.sides).for_each(|(side, own)| *side -= part * own);
            }
            left -= still.sides.iter().map(|side| side * side / weight).sum::<f64>();
        }
        let sides = self.sides.clone();
        self.matrix.solve(&mut self.sides, width)?;
        left -= self.sides.iter().zip(&sides).map(|(solution, side)| solution * side).sum::<f64>();
        let mut background = self.pattern.background;
        for (still, values) in self.still.iter().zip(background.chunks_mut(width)) {
            for (bin, value) in values.iter_mut().enumerate() {
                let moving = || (0..knots).map(|k| still.knots[k] * self.sides[k * width + bin]).sum::<f64>();
                *value = if is_shown(still) { (still.sides[bin] - moving()) / (still.weight + RIDGE) } else { 0.0 };
            }
        }
        Some(Explained { left, background })
    }
}
