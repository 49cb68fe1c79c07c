//! Camera motion from small blocks of the stationary background.
//!
//! A camera moves all blocks alike. Motion of some blocks only, such as leaves behind a tube, is no camera motion and
//! is left to the tracking of the tube.

use crate::plane::Plane;
use crate::tracking::median::median;
use units::order::sort_by;

/// Maximum number of blocks beside the tubes and within their strips.
const BESIDE: usize = 28;
const WITHIN: usize = 24;
/// Samples along each side of a block.
const SIDE: usize = 8;
/// Minimum standard deviation of a block, grey values.
const LEAST: f64 = 4.0;
/// Longest shift that may be noise, px.
const STILL: f64 = 1.0;
/// Largest change of the shift between frames, relative to the height of the picture.
const REACH: f64 = 1.0 / 24.0;
/// Ratio of squared differences from which a block supports one of two shifts.
const TELLS: f64 = 1.5;
/// Minimum number of blocks that support a shift, and the maximum number against it, relative to that.
const VOTES: usize = 8;
const AGAINST: f64 = 0.2;
/// Minimum number of successive frames with a shift for a moving camera.
const FRAMES: usize = 3;
/// Ratio of the squared difference to the median of earlier frames from which a wider search is made.
const UNUSUAL: f64 = 2.0;

struct Block {
    /// Position of the first sample, px.
    place: [f64; 2],
    /// Per sample: deviation from the mean and its derivatives to the right and downwards, all divided by the norm of
    /// the deviations.
    values: Vec<[f64; 3]>,
    /// Norm of the deviations, grey values.
    structure: f64,
}

/// Shift of a frame relative to the first one, px.
#[derive(Clone, Copy, Debug)]
struct Shift {
    by: [f64; 2],
    /// True if most blocks beside the tubes and within their strips support it.
    is_common: bool,
}

/// Measurement of the camera motion.
pub(crate) struct Backdrop {
    /// Point and direction of the axis of each tube.
    axes: Vec<([f64; 2], [f64; 2])>,
    /// Distance between samples, px.
    step: f64,
    /// Blocks beside the tubes, followed by blocks within their strips.
    blocks: Vec<Block>,
    beside: usize,
    shifts: Vec<Shift>,
    /// Median of the normalized squared differences of the blocks, for each frame after the first.
    left: Vec<f64>,
}

impl Backdrop {
    /// State before the first frame. `axes`: a point (px) and the direction of each tube.
    pub(crate) fn new(axes: Vec<([f64; 2], [f64; 2])>) -> Backdrop {
        Backdrop { axes, step: 1.0, blocks: Vec::new(), beside: 0, shifts: Vec::new(), left: Vec::new() }
    }

    /// Measures the shift of the next frame.
    pub(crate) fn take(&mut self, plane: &Plane) {
        let Some(last) = self.shifts.last().copied() else {
            self.choose(plane);
            self.shifts.push(Shift { by: [0.0; 2], is_common: true });
            return;
        };
        if self.blocks.is_empty() {
            return;
        }
        let (mut by, mut left) = self.refine(plane, last.by, 8);
        if !self.left.is_empty() && left > UNUSUAL * median(self.left.clone()) {
            let sought = self.search(plane, last.by);
            let (found, rest) = self.refine(plane, sought, 8);
            if rest < left {
                (by, left) = (found, rest);
            }
        }
        self.left.push(left);
        let is_common = self.is_common(plane, by);
        self.shifts.push(Shift { by, is_common });
    }

    /// Shift of each frame relative to the first one, px to the right and downwards; `None` if the camera stands still.
    /// A frame without a clear shift has that of the frame before.
    pub(crate) fn moved(&self) -> Option<Vec<[f64; 2]>> {
        let is_far = |shift: &&Shift| libm::hypot(shift.by[0], shift.by[1]) > STILL;
        let far = self.shifts.iter().filter(is_far).count();
        let common = self.shifts.iter().filter(is_far).filter(|shift| shift.is_common).count();
        let mut runs =
            self.shifts.chunk_by(|one, next| (is_far(&one) && one.is_common) == (is_far(&next) && next.is_common));
        let has_run = runs.any(|run| run.len() >= FRAMES && is_far(&&run[0]) && run[0].is_common);
        if !has_run || 2 * common < far {
            return None;
        }
        let mut last = [0.0; 2];
        let known = |shift: &Shift| {
            if shift.is_common || !is_far(&shift) {
                last = shift.by;
            }
            last
        };
        Some(self.shifts.iter().map(known).collect())
    }

    /// Selects the blocks with the most structure.
    fn choose(&mut self, plane: &Plane) {
        let (wide, high) = (plane.width() as f64, plane.height() as f64);
        self.step = (high / 240.0).round().max(1.0);
        let size = self.step * SIDE as f64;
        let strip = high / 16.0;
        let (mut beside, mut within) = (Vec::new(), Vec::new());
        let margin = size / 2.0;
        let count = |length: f64| ((length - 2.0 * margin) / size).max(0.0) as usize;
        for row in 0..count(high).min(64) {
            for column in 0..count(wide).min(64) {
                let place = [margin + column as f64 * size, margin + row as f64 * size];
                let middle = place.map(|at| at + size / 2.0);
                let distance =
                    |&([x, y], [u, v]): &([f64; 2], [f64; 2])| ((middle[0] - x) * v - (middle[1] - y) * u).abs();
                let is_within = self.axes.iter().any(|axis| distance(axis) < strip);
                let block = Block::new(plane, place, self.step);
                if is_within { within.extend(block) } else { beside.extend(block) }
            }
        }
        for (blocks, most) in [(&mut beside, BESIDE), (&mut within, WITHIN)] {
            sort_by(blocks, |one, other| other.structure.total_cmp(&one.structure));
            blocks.truncate(most);
        }
        self.beside = beside.len();
        self.blocks = beside;
        self.blocks.extend(within);
    }

    /// Normalized squared difference of each block at a shift (px), with the sums of the normal equations for its
    /// improvement.
    fn squares(&self, plane: &Plane, by: [f64; 2]) -> Vec<(f64, [f64; 5])> {
        self.blocks.iter().map(|block| block.compare(plane, by, self.step)).collect()
    }

    /// Improves a shift by Gauss-Newton steps with small weights for blocks that differ much. Returns the shift and the
    /// median squared difference before the last step.
    fn refine(&self, plane: &Plane, start: [f64; 2], steps: usize) -> ([f64; 2], f64) {
        let mut by = start;
        let mut left = f64::INFINITY;
        for _ in 0..steps {
            let squares = self.squares(plane, by);
            let usual = median(squares.iter().map(|one| one.0).collect());
            let mut sums = [0.0; 5];
            for (square, own) in &squares {
                let far = 1.0 + square / usual.max(1e-6);
                sums.iter_mut().zip(own).for_each(|(sum, own)| *sum += own / (far * far));
            }
            left = usual;
            let [xx, xy, yy, x, y] = sums;
            // Keeps the shift in a direction without structure.
            let (xx, yy) = (1.02 * xx + 1e-9, 1.02 * yy + 1e-9);
            let determinant = xx * yy - xy * xy;
            let step = [(x * yy - y * xy) / determinant, (y * xx - x * xy) / determinant];
            if step.iter().any(|part| !part.is_finite()) {
                break;
            }
            by = [by[0] + step[0].clamp(-2.0, 2.0), by[1] + step[1].clamp(-2.0, 2.0)];
            if libm::hypot(step[0], step[1]) < 0.02 {
                break;
            }
        }
        (by, left)
    }

    /// Best shift on a grid around another one, px.
    fn search(&self, plane: &Plane, around: [f64; 2]) -> [f64; 2] {
        let reach = (REACH * plane.height() as f64 / self.step).clamp(6.0, 12.0) as i32;
        let shift =
            |right: i32, down: i32| [around[0] + self.step * f64::from(right), around[1] + self.step * f64::from(down)];
        // Prefers the nearest of similar minima, such as the lines of a scale.
        let factor = |right: i32, down: i32| 1.0 + 0.01 * f64::from(right.abs().max(down.abs()));
        let staying = self.roughly(plane, shift(0, 0), (factor(0, 0), f64::INFINITY));
        let mut best = (f64::INFINITY, around);
        for down in -reach..=reach {
            for right in -reach..=reach {
                let by = shift(right, down);
                let sum = self.roughly(plane, by, (factor(right, down), staying.min(best.0)));
                if sum < best.0 {
                    best = (sum, by);
                }
            }
        }
        best.1
    }

    /// Sum of the squared differences of the blocks at a shift (px), each at most 1, times a factor. Infinite if it exceeds `most`.
    fn roughly(&self, plane: &Plane, by: [f64; 2], (factor, most): (f64, f64)) -> f64 {
        let mut sum = 0.0;
        for block in &self.blocks {
            sum += block.roughly(plane, by, self.step).min(1.0);
            if sum * factor > most {
                return f64::INFINITY;
            }
        }
        sum * factor
    }

    fn is_common(&self, plane: &Plane, by: [f64; 2]) -> bool {
        if libm::hypot(by[0], by[1]) <= STILL {
            return false;
        }
        let (rest, moved) = (self.squares(plane, [0.0; 2]), self.squares(plane, by));
        let votes = |range: std::ops::Range<usize>| {
            let pairs = || rest[range.clone()].iter().zip(&moved[range.clone()]);
            let pro = pairs().filter(|(rest, moved)| rest.0 > TELLS * moved.0).count();
            let contra = pairs().filter(|(rest, moved)| moved.0 > TELLS * rest.0).count();
            (pro, contra)
        };
        let (beside, within) = (votes(0..self.beside), votes(self.beside..self.blocks.len()));
        let clear = |(pro, contra): (usize, usize)| contra as f64 <= AGAINST * pro as f64;
        beside.0 + within.0 >= VOTES && clear(beside) && clear(within)
    }
}

impl Block {
    /// `None` if the block has too little structure.
    fn new(plane: &Plane, place: [f64; 2], step: f64) -> Option<Block> {
        let at = |right: f64, down: f64| plane.linear(place[0] + right, place[1] + down);
        let mut values: Vec<[f64; 3]> = (0..SIDE * SIDE)
            .map(|k| {
                let (x, y) = ((k % SIDE) as f64 * step, (k / SIDE) as f64 * step);
                let slope = |u: f64, v: f64| 0.5 * (at(x + u, y + v) - at(x - u, y - v));
                [at(x, y), slope(1.0, 0.0), slope(0.0, 1.0)]
            })
            .collect();
        let count = values.len() as f64;
        let mean = values.iter().map(|value| value[0]).sum::<f64>() / count;
        let norm = values.iter().map(|value| (value[0] - mean) * (value[0] - mean)).sum::<f64>().sqrt();
        if norm < LEAST * count.sqrt() {
            return None;
        }
        values.iter_mut().for_each(|[value, right, down]| {
            *value = (*value - mean) / norm;
            (*right, *down) = (*right / norm, *down / norm);
        });
        Some(Block { place, values, structure: norm })
    }

    /// Squared difference at a shift after normalization of mean and contrast, and the sums of products of derivatives
    /// and differences.
    fn compare(&self, plane: &Plane, by: [f64; 2], step: f64) -> (f64, [f64; 5]) {
        let places = |k: usize| std::array::from_fn(|at| self.place[k] + at as f64 * step + by[k]);
        let seen = plane.linear_grid::<SIDE>(places(0), places(1));
        let seen = seen.as_flattened();
        let mean = seen.iter().sum::<f64>() / seen.len() as f64;
        let norm = seen.iter().map(|value| (value - mean) * (value - mean)).sum::<f64>().sqrt().max(1.0);
        let (mut square, mut sums) = (0.0, [0.0; 5]);
        for (seen, [value, right, down]) in seen.iter().zip(&self.values) {
            let difference = value - (seen - mean) / norm;
            square += difference * difference;
            let products = [right * right, right * down, down * down, right * difference, down * difference];
            sums.iter_mut().zip(products).for_each(|(sum, product)| *sum += product);
        }
        (square, sums)
    }

    /// Squared difference from a quarter of the samples, without interpolation.
    fn roughly(&self, plane: &Plane, by: [f64; 2], step: f64) -> f64 {
        let places = |k: usize| -> [i64; SIDE / 2] {
            std::array::from_fn(|part| (self.place[k] + (2 * part) as f64 * step + by[k]) as i64)
        };
        let (columns, rows) = (places(0), places(1));
        let mut seen = [[0.0; SIDE / 2]; SIDE / 2];
        for (line, row) in seen.iter_mut().zip(rows) {
            line.iter_mut().zip(columns).for_each(|(seen, column)| *seen = f64::from(plane.pixel(column, row)));
        }
        let seen = seen.as_flattened();
        let mean = seen.iter().sum::<f64>() / seen.len() as f64;
        let norm = seen.iter().map(|value| (value - mean) * (value - mean)).sum::<f64>().sqrt().max(1.0);
        let values = self.values.chunks(SIDE).step_by(2).flat_map(|row| row.iter().step_by(2));
        let differences = values.zip(seen).map(|([value, ..], seen)| 2.0 * value - (seen - mean) / norm);
        differences.map(|difference| difference * difference).sum()
    }
}
