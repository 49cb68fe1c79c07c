//! Appearance of the surface: a grey value for each distance from it along the tube and each bin across the bore.
//!
//! The model of the film is `gain * (pattern(row - surface) + background(row)) + offset`, with a gain and an offset for
//! each frame. The pattern is a cubic spline with one knot per pixel, fitted to the pixels of all frames by least
//! squares. Frames with different fractions of a pixel determine it with subpixel resolution. Smear during the exposure
//! widens the splines instead of the pattern, so that blurred frames contribute to the sharp pattern.

use crate::tracking::column::strip::{Grid, Strip};
use crate::tracking::linear::Banded;
use crate::tracking::spline;

/// Penalty on second differences of the pattern, relative to the mean weight of a knot: it bridges knots without data.
const SMOOTHNESS: f64 = 1e-4;
/// Number of bins computed side by side.
const LANES: usize = 4;

/// Parameters of a frame in the model.
#[derive(Clone, Debug)]
pub(crate) struct Pose {
    /// Row of the surface.
    pub row: f64,
    /// Contrast relative to the mean of all frames.
    pub gain: f64,
    /// Offset, grey values.
    pub offset: f64,
    /// Displacement of the surface from `row`, in rows, at evenly spaced instants of the exposure.
    pub smear: Vec<f64>,
    /// True if the frame contributes to pattern and background.
    pub trusted: bool,
}

/// Compared bins and rows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Window {
    pub grid: Grid,
    /// Range of the bins of the bore.
    pub bins: (usize, usize),
    /// Number of rows on each side of the surface.
    pub half: f64,
}

impl Window {
    pub(crate) fn width(&self) -> usize {
        self.bins.1 - self.bins.0
    }

    /// Rows around the surface.
    pub(crate) fn rows(&self, row: f64) -> std::ops::Range<usize> {
        let first = (row - self.half).ceil().max(0.0) as usize;
        let end = ((row + self.half).floor() + 1.0).max(0.0) as usize;
        first.min(self.grid.rows)..end.min(self.grid.rows)
    }
}

/// Weights of the knots in one row.
#[derive(Default)]
pub(crate) struct Weights {
    /// Index of the first knot.
    pub first: usize,
    /// Weights for the value.
    pub values: Vec<f64>,
    /// Weights for the derivative.
    pub slopes: Vec<f64>,
    /// Lowest and highest place of the row among the knots during the exposure.
    places: (f64, f64),
}

#[derive(Clone, Debug)]
pub(crate) struct Pattern {
    pub window: Window,
    /// Distance of the first knot from the surface, rows.
    first: f64,
    knots: usize,
    /// One per knot and bin.
    coefficients: Vec<f64>,
    /// Stationary background: one value per row of the strip and bin.
    pub background: Vec<f64>,
}

impl Pattern {
    /// Empty pattern for frames with up to `smear` rows of smear.
    pub(crate) fn new(window: Window, smear: f64) -> Pattern {
        let reach = (window.half + smear / 2.0).ceil();
        let knots = 2 * reach as usize + 4;
        Pattern {
            window,
            first: -reach - 1.0,
            knots,
            coefficients: vec![0.0; knots * window.width()],
            background: vec![0.0; window.grid.rows * window.width()],
        }
    }

    /// Number of knots.
    pub(crate) fn knots(&self) -> usize {
        self.knots
    }

    /// Empty normal equations of the coefficients of a bin.
    pub(crate) fn equations(&self) -> Banded {
        Banded::new(self.knots, self.knots - 1)
    }

    /// Adds the penalty on second differences to normal equations.
    pub(crate) fn smooth(&self, matrix: &mut Banded) {
        let penalty = SMOOTHNESS * matrix.scale() + f64::MIN_POSITIVE;
        for knot in 0..self.knots {
            matrix.add(knot, knot, 1e-6 * penalty);
        }
        for knot in 0..self.knots.saturating_sub(2) {
            for (k, one) in [1.0, -2.0, 1.0].into_iter().enumerate() {
                for (j, other) in [1.0, -2.0, 1.0].into_iter().enumerate().skip(k) {
                    matrix.add(knot + k, knot + j, penalty * one * other);
                }
            }
        }
    }

    /// Calls `act` with each row around the surface and the weights of its knots.
    pub(crate) fn rows(&self, pose: &Pose, weights: &mut Weights, mut act: impl FnMut(usize, &Weights)) {
        let last = (self.knots - 4) as f64;
        for (number, row) in self.window.rows(pose.row).enumerate() {
            // Knots are as far apart as rows, so that the next row has the same weights at the next knots, except at the ends.
            let (low, high) = weights.places;
            if number > 0 && low >= 0.0 && low <= high && high + 1.0 < last {
                weights.places = (low + 1.0, high + 1.0);
                weights.first += 1;
            } else {
                self.weights(row as f64 - pose.row, &pose.smear, weights);
            }
            act(row, weights);
        }
    }

    /// Weights of the knots for a row at `distance` rows from the surface.
    fn weights(&self, distance: f64, smear: &[f64], weights: &mut Weights) {
        weights.values.clear();
        weights.slopes.clear();
        let part = 1.0 / smear.len() as f64;
        // `max` of NaN and a number is the number.
        let place = |shift: f64| distance - shift - self.first - 1.0;
        let inside = |place: f64| place.max(0.0).min((self.knots - 4) as f64);
        weights.places = smear
            .iter()
            .map(|shift| place(*shift))
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), place| (low.min(place), high.max(place)));
        weights.first = inside(weights.places.0).floor() as usize;
        for shift in smear {
            let at = inside(place(*shift));
            let knot = at.floor();
            let start = knot as usize - weights.first;
            if weights.values.len() < start + 4 {
                weights.values.resize(start + 4, 0.0);
                weights.slopes.resize(start + 4, 0.0);
            }
            let (values, slopes) = (spline::values(at - knot), spline::slopes(at - knot));
            for k in 0..4 {
                weights.values[start + k] += part * values[k];
                weights.slopes[start + k] += part * slopes[k];
            }
        }
        // The last place may lie on the last knot.
        let room = self.knots - weights.first;
        weights.values.truncate(room);
        weights.slopes.truncate(room);
    }

    /// Pattern with background, and derivative of the pattern by the row, for each bin of one row.
    pub(crate) fn row(&self, row: usize, weights: &Weights, out: &mut [(f64, f64)]) {
        let width = self.window.width();
        let still = self.background.get(row * width..).unwrap_or_default();
        let knots = self.coefficients.get(weights.first * width..).unwrap_or_default();
        let (parts, rest) = out.as_chunks_mut::<LANES>();
        let wide = parts.len() * LANES;
        for (bin, part) in (0..wide).step_by(LANES).zip(parts) {
            *part = self.bins(&still[bin..], knots.get(bin..).unwrap_or_default(), weights);
        }
        for (bin, out) in (wide..width).zip(rest) {
            [*out] = self.bins(&still[bin..], knots.get(bin..).unwrap_or_default(), weights);
        }
    }

    /// Values and derivatives of some bins side by side. `knots`: coefficients from the first bin of the first knot.
    fn bins<const COUNT: usize>(&self, still: &[f64], knots: &[f64], weights: &Weights) -> [(f64, f64); COUNT] {
        let mut values: [f64; COUNT] = still.first_chunk().copied().unwrap_or([0.0; COUNT]);
        let mut slopes = [0.0; COUNT];
        let weights = weights.values.iter().zip(&weights.slopes);
        for (knot, (value, slope)) in knots.chunks(self.window.width()).zip(weights) {
            let Some(coefficients) = knot.first_chunk::<COUNT>() else { break };
            for k in 0..COUNT {
                values[k] += value * coefficients[k];
                slopes[k] += slope * coefficients[k];
            }
        }
        std::array::from_fn(|k| (values[k], slopes[k]))
    }
}

/// Normal equations of the pattern.
pub(crate) struct Fitting {
    matrix: Banded,
    sides: Vec<f64>,
    weights: Weights,
    gains: f64,
    frames: f64,
}

impl Fitting {
    pub(crate) fn new(pattern: &Pattern) -> Fitting {
        Fitting {
            matrix: pattern.equations(),
            sides: vec![0.0; pattern.coefficients.len()],
            weights: Weights::default(),
            gains: 0.0,
            frames: 0.0,
        }
    }

    pub(crate) fn take(&mut self, pattern: &Pattern, strip: &Strip, pose: &Pose) {
        let window = pattern.window;
        let width = window.width();
        self.gains += pose.gain;
        self.frames += 1.0;
        let (matrix, sides) = (&mut self.matrix, &mut self.sides);
        pattern.rows(pose, &mut self.weights, |row, Weights { first, values: weights, .. }| {
            for (k, weight) in weights.iter().enumerate() {
                for (j, other) in weights.iter().enumerate().skip(k) {
                    matrix.add(first + k, first + j, pose.gain * pose.gain * weight * other);
                }
            }
            for (bin, value) in strip.values(window.grid, row, window.bins).enumerate() {
                let still = pattern.background[row * width + bin];
                let value = pose.gain * (value - pose.offset - pose.gain * still);
                for (k, weight) in weights.iter().enumerate() {
                    sides[(first + k) * width + bin] += weight * value;
                }
            }
        });
    }

    /// Solves for the coefficients of the pattern. Returns the mean gain of the frames, by which the pattern is
    /// multiplied.
    pub(crate) fn finish(mut self, pattern: &mut Pattern) -> f64 {
        pattern.smooth(&mut self.matrix);
        let mean = self.gains / self.frames;
        if self.frames == 0.0 || mean <= 0.0 || self.matrix.solve(&mut self.sides, pattern.window.width()).is_none() {
            return 1.0;
        }
        self.sides.iter_mut().for_each(|value| *value *= mean);
        pattern.coefficients = self.sides;
        mean
    }
}

/// Mean residual of each value of the strip, for the background.
pub(crate) struct Residuals {
    /// Number, sum, and sum of squares of the residuals.
    sums: Vec<(f64, f64, f64)>,
}

impl Residuals {
    pub(crate) fn new(pattern: &Pattern) -> Residuals {
        Residuals { sums: vec![(0.0, 0.0, 0.0); pattern.background.len()] }
    }

    pub(crate) fn take(&mut self, at: usize, residual: f64) {
        if let Some(sum) = self.sums.get_mut(at) {
            *sum = (sum.0 + 1.0, sum.1 + residual, sum.2 + residual * residual);
        }
    }

    /// Adds to the background the part of each mean that its scatter does not explain (positive-part James-Stein
    /// estimator, *Proc. 4th Berkeley Symp.* 1 (1961) 361).
    pub(crate) fn finish(self, pattern: &mut Pattern) {
        for ((count, sum, squares), still) in self.sums.into_iter().zip(&mut pattern.background) {
            let mean = sum / count;
            let variance = (squares / count - mean * mean) / (count - 1.0);
            if count > 3.0 && mean * mean > variance {
                *still += mean * (1.0 - variance / (mean * mean));
            }
        }
    }
}
