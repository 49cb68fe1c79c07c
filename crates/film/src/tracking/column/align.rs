//! Row of the surface in one frame, by Gauss-Newton steps on the pixels of the bore.

use crate::tracking::column::pattern::{Pattern, Pose, Residuals, Weights};
use crate::tracking::column::strip::Strip;
use crate::tracking::linear::solve;

/// Maximum number of steps.
const STEPS: usize = 20;
/// Length of a step in rows that ends the iteration.
const CLOSE: f64 = 1e-3;

/// Agreement of a frame with the pattern.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Agreement {
    /// Variance of the position from the residuals of this frame, rows².
    pub variance: f64,
    /// Correlation of the pixels with the model.
    pub score: f64,
    /// Sum of squared residuals, grey values².
    pub squares: f64,
    /// Number of compared pixels.
    pub count: f64,
    /// True if the iteration converged.
    pub settled: bool,
}

/// Sums of products of the pixels with the derivative of the pattern, the pattern and 1.
struct Sums {
    matrix: [[f64; 3]; 3],
    side: [f64; 3],
    squares: f64,
}

impl Sums {
    fn of(pattern: &Pattern, strip: &Strip, pose: &Pose, weights: &mut Weights, model: &mut [(f64, f64)]) -> Sums {
        let window = pattern.window;
        let mut sums = Sums { matrix: [[0.0; 3]; 3], side: [0.0; 3], squares: 0.0 };
        // Relative to the offset, since squares of grey values would lose digits.
        pattern.rows(pose, weights, |row, weights| {
            pattern.row(row, weights, model);
            for (grey, (value, slope)) in strip.values(window.grid, row, window.bins).zip(model.iter()) {
                let grey = grey - pose.offset;
                let m = &mut sums.matrix;
                m[0][0] += slope * slope;
                m[0][1] += slope * value;
                m[0][2] += slope;
                m[1][1] += value * value;
                m[1][2] += value;
                m[2][2] += 1.0;
                sums.side[0] += slope * grey;
                sums.side[1] += value * grey;
                sums.side[2] += grey;
                sums.squares += grey * grey;
            }
        });
        for row in 1..3 {
            for column in 0..row {
                sums.matrix[row][column] = sums.matrix[column][row];
            }
        }
        sums
    }
}

/// Moves the pose to the least residual with a row in the interval `between`.
pub(crate) fn align(pattern: &Pattern, strip: &Strip, pose: &mut Pose, between: (f64, f64)) -> Agreement {
    let mut weights = Weights::default();
    let mut model = vec![(0.0, 0.0); pattern.window.width()];
    let (lowest, highest) = (between.0.max(0.0), between.1.min(pattern.window.grid.rows as f64 - 1.0));
    // Without information the row is uniformly distributed over the interval.
    let width = (highest - lowest).max(0.0);
    let unknown = Agreement { variance: width * width / 12.0, ..Agreement::default() };
    let mut agreement = unknown;
    for _ in 0..STEPS {
        let sums = Sums::of(pattern, strip, pose, &mut weights, &mut model);
        let Some(([slope, gain, offset], inverse)) = solve(sums.matrix, sums.side) else { return unknown };
        let count = sums.matrix[2][2];
        let explained = slope * sums.side[0] + gain * sums.side[1] + offset * sums.side[2];
        let squares = (sums.squares - explained).max(0.0);
        let total = (sums.squares - sums.side[2] * sums.side[2] / count).max(f64::MIN_POSITIVE);
        let residual = squares / (count - 3.0).max(1.0);
        pose.offset += offset;
        if gain <= 0.0 {
            return Agreement { squares, count, ..unknown };
        }
        pose.gain = gain;
        // A pattern moved down by one row shows at each place what was one row above.
        let step = (-slope / gain).clamp(-1.0, 1.0);
        let row = (pose.row + step).min(highest).max(lowest);
        let moved = (row - pose.row).abs();
        pose.row = row;
        agreement = Agreement {
            variance: residual * inverse[0][0] / (gain * gain),
            score: (1.0 - squares / total).max(0.0).sqrt(),
            squares,
            count,
            settled: (step).abs() < CLOSE,
        };
        if moved < CLOSE {
            break;
        }
    }
    agreement
}

/// Adds the residuals of a frame to the sums for the background.
pub(crate) fn residuals(pattern: &Pattern, strip: &Strip, pose: &Pose, sums: &mut Residuals) {
    let window = pattern.window;
    let mut weights = Weights::default();
    let mut model = vec![(0.0, 0.0); window.width()];
    pattern.rows(pose, &mut weights, |row, weights| {
        pattern.row(row, weights, &mut model);
        for (bin, grey) in strip.values(window.grid, row, window.bins).enumerate() {
            let (value, _) = model[bin];
            sums.take(row * window.width() + bin, (grey - pose.offset) / pose.gain - value);
        }
    });
}
