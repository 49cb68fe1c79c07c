//! The strip along a tube in each frame.

use crate::plane::Plane;
use crate::tracking::similarity::Similarity;

/// Grey values are kept in steps of 1/256.
const STEPS: f64 = 256.0;

/// The line along a tube, and the grid of a strip around it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Line {
    /// The middle of the first row.
    pub origin: [f64; 2],
    /// Along the tube, of length 1; one row is one pixel.
    pub direction: [f64; 2],
}

impl Line {
    /// The point of a row.
    pub(crate) fn at(&self, row: f64) -> [f64; 2] {
        [self.origin[0] + row * self.direction[0], self.origin[1] + row * self.direction[1]]
    }

    /// The row nearest to a point.
    pub(crate) fn row(&self, [x, y]: [f64; 2]) -> f64 {
        (x - self.origin[0]) * self.direction[0] + (y - self.origin[1]) * self.direction[1]
    }

    /// The line where the camera has moved. It begins at most half a pixel further along the tube, so that rows of an upright
    /// tube remain rows of the picture and need no interpolation along the tube.
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

/// How the strips of all frames are divided.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Grid {
    /// Along the tube, a pixel each.
    pub rows: usize,
    /// Across the tube.
    pub bins: usize,
    /// Width of a bin in pixels.
    pub width: f64,
}

/// The strip of one frame.
#[derive(Clone, Debug)]
pub(crate) struct Strip {
    /// As the caller counts.
    pub frame: usize,
    /// Presentation time in seconds.
    pub time: f64,
    /// Where it lies in this frame.
    pub line: Line,
    /// How the camera has moved since the first frame.
    pub camera: Similarity,
    /// Grey values in steps of 1/256, row by row.
    pub grey: Vec<u16>,
}

impl Strip {
    /// Reads the strip from a frame.
    pub(crate) fn read(frame: usize, time: f64, plane: &Plane, line: &Line, camera: Similarity, grid: Grid) -> Strip {
        let line = if camera == Similarity::IDENTITY { *line } else { line.moved(&camera) };
        let samples = grid.width.ceil().max(1.0);
        let left = grid.bins as f64 * grid.width / 2.0;
        // To the right of an upright tube.
        let normal = [line.direction[1], -line.direction[0]];
        let mut grey = Vec::with_capacity(grid.rows * grid.bins);
        for row in 0..grid.rows {
            let [x, y] = line.at(row as f64);
            for bin in 0..grid.bins {
                let mut sum = 0.0;
                for sample in 0..samples as usize {
                    let across = (bin as f64 + (sample as f64 + 0.5) / samples) * grid.width - left;
                    sum += plane.linear(x + across * normal[0], y + across * normal[1]);
                }
                grey.push((sum / samples * STEPS).round() as u16);
            }
        }
        Strip { frame, time, line, camera, grey }
    }

    /// The grey values of some neighbouring bins of a row.
    pub(crate) fn values(&self, grid: Grid, row: usize, bins: (usize, usize)) -> impl Iterator<Item = f64> {
        let start = row * grid.bins;
        let values = self.grey.get(start + bins.0..start + bins.1).unwrap_or(&[]);
        values.iter().map(|value| f64::from(*value) / STEPS)
    }
}
