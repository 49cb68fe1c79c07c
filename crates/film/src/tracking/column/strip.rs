//! Strip along a tube in each frame.

use crate::plane::Plane;
use crate::tracking::median::median;
use crate::tracking::similarity::Similarity;

/// Steps per grey value.
const STEPS: f64 = 256.0;
/// Maximum number of values compared per pair of strips.
const COMPARED: usize = 1500;

/// Line along a tube.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Line {
    /// Centre of the first row, px.
    pub origin: [f64; 2],
    /// Unit vector along the tube. The rows have a distance of one px.
    pub direction: [f64; 2],
}

impl Line {
    /// Position of a row, px.
    pub(crate) fn at(&self, row: f64) -> [f64; 2] {
        [self.origin[0] + row * self.direction[0], self.origin[1] + row * self.direction[1]]
    }

    /// Row of a point in px.
    pub(crate) fn row(&self, [x, y]: [f64; 2]) -> f64 {
        (x - self.origin[0]) * self.direction[0] + (y - self.origin[1]) * self.direction[1]
    }

    /// Line after a motion of the camera. It is shifted along the tube by at most half a pixel, so that rows of an
    /// upright tube remain rows of the picture and need no interpolation along the tube.
    fn moved(&self, camera: &Similarity) -> Line {
        let origin = camera.apply(self.origin);
        let turned = camera.turn(self.direction);
        let length = (turned[0] * turned[0] + turned[1] * turned[1]).sqrt();
        let direction = [turned[0] / length, turned[1] / length];
        let along = usize::from(direction[1].abs() > direction[0].abs());
        let late = (origin[along] - self.origin[along]).round() + self.origin[along] - origin[along];
        let rows = late / direction[along];
        Line { origin: [origin[0] + rows * direction[0], origin[1] + rows * direction[1]], direction }
    }
}

/// Division of the strips of all frames.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Grid {
    /// Rows along the tube, 1 px each.
    pub rows: usize,
    /// Bins across the tube.
    pub bins: usize,
    /// Width of a bin, px.
    pub width: f64,
}

/// Strip of one frame.
#[derive(Clone, Debug)]
pub(crate) struct Strip {
    /// Frame number of the caller.
    pub frame: usize,
    /// Presentation time, s.
    pub time: f64,
    /// Line along the tube in this frame.
    pub line: Line,
    /// Motion of the camera since the first frame.
    pub camera: Similarity,
    /// Grey values in steps of 1/256, row by row.
    pub grey: Vec<u16>,
}

impl Strip {
    /// Samples the strip of a frame.
    pub(crate) fn read(frame: usize, time: f64, plane: &Plane, line: &Line, camera: Similarity, grid: Grid) -> Strip {
        let line = if camera == Similarity::IDENTITY { *line } else { line.moved(&camera) };
        let samples = grid.width.ceil().max(1.0);
        let left = grid.bins as f64 * grid.width / 2.0;
        // To the right for a tube that points down.
        let normal = [line.direction[1], -line.direction[0]];
        let across = |bin: usize, sample: usize| (bin as f64 + (sample as f64 + 0.5) / samples) * grid.width - left;
        let mut grey = Vec::with_capacity(grid.rows * grid.bins);
        if line.direction == [0.0, 1.0] && line.origin[1] >= 0.5 && (line.origin[1] - 0.5).fract() == 0.0 {
            // Fast path: all rows of the strip are rows of the picture, with the same columns in a bin.
            let places = |bin| (0..samples as usize).map(move |sample| line.origin[0] + across(bin, sample));
            let bins: Vec<(usize, Vec<f64>)> = (0..grid.bins).map(|bin| weights(places(bin), plane.width())).collect();
            for row in (line.origin[1] as usize..plane.height()).take(grid.rows) {
                let pixels = plane.grey().get(row * plane.width()..).unwrap_or_default();
                for (first, weights) in &bins {
                    let pixels = weights.iter().zip(pixels.get(*first..).unwrap_or_default());
                    let sum: f64 = pixels.map(|(weight, pixel)| weight * f64::from(*pixel)).sum();
                    grey.push(rounded(sum / samples * STEPS));
                }
            }
        }
        for row in grey.len() / grid.bins..grid.rows {
            let [x, y] = line.at(row as f64);
            for bin in 0..grid.bins {
                let place =
                    |sample| plane.linear(x + across(bin, sample) * normal[0], y + across(bin, sample) * normal[1]);
                let sum: f64 = (0..samples as usize).map(place).sum();
                grey.push(rounded(sum / samples * STEPS));
            }
        }
        Strip { frame, time, line, camera, grey }
    }

    /// Grey values of a range of bins in a row.
    pub(crate) fn values(&self, grid: Grid, row: usize, bins: (usize, usize)) -> impl Iterator<Item = f64> {
        let start = row * grid.bins;
        let values = self.grey.get(start + bins.0..start + bins.1).unwrap_or(&[]);
        values.iter().map(|value| f64::from(*value) / STEPS)
    }

    /// Replaces the grey value of a row and a bin.
    pub(crate) fn set(&mut self, grid: Grid, (row, bin): (usize, usize), value: f64) {
        if let Some(grey) = self.grey.get_mut(row * grid.bins + bin) {
            *grey = rounded(value * STEPS);
        }
    }

    /// Means over `count` equal parts of a range of bins in each row, one part after the other.
    pub(crate) fn channels(&self, grid: Grid, (first, end): (usize, usize), count: usize) -> Vec<f32> {
        let edge = |k: usize| first + (end - first) * k / count;
        (0..count).flat_map(|k| self.profile(grid, (edge(k), edge(k + 1)))).collect()
    }

    /// Divides the grey values by the brightness relative to another frame. The median of the ratios is insensitive to
    /// values changed by the motion of the surface.
    pub(crate) fn even(&mut self, first: &Strip) {
        let stride = (self.grey.len() / COMPARED).max(1);
        let pairs = self.grey.iter().zip(&first.grey).step_by(stride);
        let ratios = pairs.filter(|(_, first)| **first > 0).map(|(own, first)| f64::from(*own) / f64::from(*first));
        let ratio = median(ratios.collect());
        if ratio > 0.0 && ratio != 1.0 {
            self.grey.iter_mut().for_each(|value| *value = rounded(f64::from(*value) / ratio));
        }
    }

    /// Mean over a range of bins, for each row.
    pub(crate) fn profile(&self, grid: Grid, bins: (usize, usize)) -> Vec<f32> {
        let mean = |row| self.values(grid, row, bins).sum::<f64>() / (bins.1 - bins.0) as f64;
        (0..grid.rows).map(|row| mean(row) as f32).collect()
    }
}

/// Nearest value that can be stored. Faster than `round`, which is a call on some targets.
fn rounded(value: f64) -> u16 {
    let whole = value as u16;
    whole.saturating_add(u16::from(value - f64::from(whole) >= 0.5))
}

/// Appends to the values of some channels the differences of rows two apart, in which broad reflections vanish.
pub(crate) fn with_differences(mut values: Vec<f32>, rows: usize) -> Vec<f32> {
    let differences = |part: &[f32]| -> Vec<f32> {
        let last = part.len().saturating_sub(1);
        (0..part.len()).map(|row| part[(row + 1).min(last)] - part[row.saturating_sub(1)]).collect()
    };
    let all: Vec<f32> = values.chunks(rows.max(1)).flat_map(differences).collect();
    values.extend(all);
    values
}

/// First pixel, and weights of it and its successors, in the sum of interpolated values at some places (px), which are
/// ascending and at most a pixel apart.
fn weights(places: impl Iterator<Item = f64>, width: usize) -> (usize, Vec<f64>) {
    let last = width.saturating_sub(1);
    let (mut first, mut weights) = (None, Vec::new());
    for place in places {
        let at = (place - 0.5).max(0.0).min(last as f64);
        let (column, right) = (at as usize, at.fract());
        let first = *first.get_or_insert(column);
        for (column, weight) in [(column, 1.0 - right), ((column + 1).min(last), right)] {
            let along = column - first;
            if weights.len() <= along {
                weights.resize(along + 1, 0.0);
            }
            weights[along] += weight;
        }
    }
    (first.unwrap_or(0), weights)
}
