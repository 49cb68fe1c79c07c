//! The motion of the camera by what stands still: small blocks of the picture, all of which a camera moves alike.
//!
//! Leaves that move behind a tube are no camera's motion: the tube has to go along with them.

use crate::plane::Plane;
use crate::tracking::median::median;

/// Blocks at most: beside the tubes, and in their strips.
const BESIDE: usize = 28;
const WITHIN: usize = 24;
/// Samples of a block along each side.
const SIDE: usize = 8;
/// The least standard deviation of a block, in grey values, that can be recognised.
const LEAST: f64 = 4.0;
/// Shifts of less than so many pixels are those of noise.
const STILL: f64 = 1.0;
/// The greatest change from a frame to the next one, as a part of the picture's height.
const REACH: f64 = 1.0 / 24.0;
/// A block speaks for a shift if the mean square there is so many times less than without it.
const TELLS: f64 = 1.5;
/// Blocks that speak for a shift, at least, and the part of them that may speak against it.
const VOTES: usize = 8;
const AGAINST: f64 = 0.2;
/// A camera that moved is seen elsewhere in so many frames in a row.
const FRAMES: usize = 3;
/// A frame differs from the first one more than usual if its mean square is so many times greater.
const UNUSUAL: f64 = 2.0;

struct Block {
    /// The first sample.
    place: [f64; 2],
    /// Samples less their mean, divided by their norm; slopes to the right and downwards, divided by the same.
    values: Vec<[f64; 3]>,
    /// The structure in both directions.
    structure: f64,
}

/// The shift of a frame against the first one.
#[derive(Clone, Copy, Debug)]
struct Shift {
    by: [f64; 2],
    /// Most blocks beside the tubes and in their strips have moved by it.
    is_common: bool,
}

/// The measurement of the camera's motion.
pub(crate) struct Backdrop {
    /// Points and directions of the axes of the tubes.
    axes: Vec<([f64; 2], [f64; 2])>,
    /// Pixels between samples.
    step: f64,
    /// Blocks beside the tubes, then blocks in their strips.
    blocks: Vec<Block>,
    beside: usize,
    shifts: Vec<Shift>,
    /// The median mean square of each frame.
    left: Vec<f64>,
}

impl Backdrop {
    /// Before the first frame; `axes` has a point and the direction of each tube.
    pub(crate) fn new(axes: Vec<([f64; 2], [f64; 2])>) -> Backdrop {
        Backdrop { axes, step: 1.0, blocks: Vec::new(), beside: 0, shifts: Vec::new(), left: Vec::new() }
    }

    /// Measures the next frame.
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
        let mut usual = self.left.clone();
        usual.sort_by(f64::total_cmp);
        if usual.get(usual.len() / 2).is_some_and(|usual| left > UNUSUAL * usual) {
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

    /// How far the picture has moved in each frame since the first one, in pixels to the right and downwards; `None` if the camera stood still.
    /// Frames that do not tell have the shift of the frame before.
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

    /// The blocks with the most structure.
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
            blocks.sort_by(|one, other| other.structure.total_cmp(&one.structure));
            blocks.truncate(most);
        }
        self.beside = beside.len();
        self.blocks = beside;
        self.blocks.extend(within);
    }

    /// The mean square of each block at a shift, and the sums for a better shift.
    fn squares(&self, plane: &Plane, by: [f64; 2]) -> Vec<(f64, [f64; 5])> {
        self.blocks.iter().map(|block| block.compare(plane, by, self.step)).collect()
    }

    /// Steps of Gauss and Newton, in which blocks that differ much count little.
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
            // A direction without structure keeps its shift.
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

    /// The best whole shift around another one.
    fn search(&self, plane: &Plane, around: [f64; 2]) -> [f64; 2] {
        let reach = (REACH * plane.height() as f64 / self.step).clamp(6.0, 12.0) as i32;
        let mut best = (f64::INFINITY, around);
        for down in -reach..=reach {
            for right in -reach..=reach {
                let by = [around[0] + self.step * f64::from(right), around[1] + self.step * f64::from(down)];
                let squares = self.blocks.iter().map(|block| block.roughly(plane, by, self.step).min(1.0));
                let sum: f64 = squares.sum();
                // Of equals, such as the lines of a scale, the nearest.
                let sum = sum * (1.0 + 0.01 * f64::from(right.abs().max(down.abs())));
                if sum < best.0 {
                    best = (sum, by);
                }
            }
        }
        best.1
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
    /// `None` without structure.
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

    /// The squares of the differences at a shift, with mean and contrast evened; and the sums of products of slopes and differences.
    fn compare(&self, plane: &Plane, by: [f64; 2], step: f64) -> (f64, [f64; 5]) {
        let seen: Vec<f64> = (0..self.values.len())
            .map(|k| {
                let (x, y) = ((k % SIDE) as f64 * step, (k / SIDE) as f64 * step);
                plane.linear(self.place[0] + x + by[0], self.place[1] + y + by[1])
            })
            .collect();
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

    /// The squares by a quarter of the pixels, at whole pixels.
    fn roughly(&self, plane: &Plane, by: [f64; 2], step: f64) -> f64 {
        let column = |k: usize| (self.place[0] + (k % SIDE) as f64 * step + by[0]) as i64;
        let row = |k: usize| (self.place[1] + (k / SIDE) as f64 * step + by[1]) as i64;
        let some = || (0..self.values.len()).filter(|k| k.is_multiple_of(2) && (k / SIDE).is_multiple_of(2));
        let seen: Vec<f64> = some().map(|k| f64::from(plane.pixel(column(k), row(k)))).collect();
        let mean = seen.iter().sum::<f64>() / seen.len() as f64;
        let norm = seen.iter().map(|value| (value - mean) * (value - mean)).sum::<f64>().sqrt().max(1.0);
        let differences = some().zip(&seen).map(|(k, seen)| 2.0 * self.values[k][0] - (seen - mean) / norm);
        differences.map(|difference| difference * difference).sum()
    }
}
