//! Shapes of bodies: sets of pixels, and the distances of other pixels from them.

use std::sync::Arc;

/// Pixels of a square grid around a middle one, row by row.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Mask {
    /// Number of pixels on each side of the middle one.
    half: i64,
    inside: Vec<bool>,
}

impl Mask {
    /// Pixels whose offset from the middle one fulfils a condition.
    pub(super) fn of(half: i64, is_inside: impl FnMut([i64; 2]) -> bool) -> Mask {
        let rows = (-half..=half).flat_map(|row| (-half..=half).map(move |column| [column, row]));
        Mask { half, inside: rows.map(is_inside).collect() }
    }

    fn place(&self, [column, row]: [i64; 2]) -> Option<usize> {
        let is_within = column.abs() <= self.half && row.abs() <= self.half;
        is_within.then_some(((row + self.half) * (2 * self.half + 1) + column + self.half) as usize)
    }

    /// Number of pixels on each side of the middle one.
    pub(super) fn half(&self) -> i64 {
        self.half
    }

    fn offset(&self, place: usize) -> [i64; 2] {
        let side = (2 * self.half + 1) as usize;
        [(place % side) as i64 - self.half, (place / side) as i64 - self.half]
    }

    pub(super) fn holds(&self, offset: [i64; 2]) -> bool {
        self.place(offset).is_some_and(|place| self.inside[place])
    }

    /// Offsets of the pixels.
    pub(super) fn offsets(&self) -> impl Iterator<Item = [i64; 2]> {
        let inside = self.inside.iter().enumerate().filter(|(_, inside)| **inside);
        inside.map(|(place, _)| self.offset(place))
    }

    /// Offsets of all pixels of the grid, row by row.
    pub(super) fn grid(&self) -> impl Iterator<Item = [i64; 2]> {
        (0..self.inside.len()).map(|place| self.offset(place))
    }

    pub(super) fn count(&self) -> usize {
        self.inside.iter().filter(|inside| **inside).count()
    }

    /// Mean offset of the pixels.
    pub(super) fn middle(&self) -> [f64; 2] {
        let count = self.count().max(1) as f64;
        let sum = self.offsets().fold([0, 0], |sum, offset| [sum[0] + offset[0], sum[1] + offset[1]]);
        sum.map(|sum| sum as f64 / count)
    }

    /// True if a pixel lies at the edge of the grid.
    pub(super) fn touches_edge(&self) -> bool {
        self.offsets().any(|[column, row]| column.abs() == self.half || row.abs() == self.half)
    }

    /// Copy whose middle pixel is that at an offset.
    pub(super) fn around(&self, [column, row]: [i64; 2], half: i64) -> Mask {
        Mask::of(half, |[u, v]| self.holds([u + column, v + row]))
    }

    /// Distance in px of each pixel from the nearest one that is `inside` or is not; infinite without one.
    pub(super) fn distances(&self, inside: bool) -> Vec<f64> {
        let side = (2 * self.half + 1) as usize;
        let mut down = vec![f64::INFINITY; self.inside.len()];
        for column in 0..side {
            let mut line = |rows: &mut dyn Iterator<Item = usize>| {
                let mut far = f64::INFINITY;
                for row in rows {
                    let place = row * side + column;
                    far = if self.inside[place] == inside { 0.0 } else { far + 1.0 };
                    down[place] = down[place].min(far);
                }
            };
            line(&mut (0..side));
            line(&mut (0..side).rev());
        }
        let mut distances = Vec::with_capacity(down.len());
        for row in down.chunks(side) {
            for column in 0..side {
                let mut least = row[column] * row[column];
                for off in 1..side {
                    let across = (off * off) as f64;
                    if across >= least {
                        break;
                    }
                    for other in [column.checked_sub(off), Some(column + off)].into_iter().flatten() {
                        least = row.get(other).map_or(least, |far| least.min(across + far * far));
                    }
                }
                distances.push(least.sqrt());
            }
        }
        distances
    }

    /// Pixels at most so many px from one of these.
    pub(super) fn dilated(&self, by: f64) -> Mask {
        Mask { half: self.half, inside: self.distances(true).into_iter().map(|far| far <= by).collect() }
    }

    /// Pixels more than so many px from all others.
    pub(super) fn eroded(&self, by: f64) -> Mask {
        Mask { half: self.half, inside: self.distances(false).into_iter().map(|far| far > by).collect() }
    }

    /// Pixels that are connected to that at an offset.
    pub(super) fn connected(&self, from: [i64; 2]) -> Mask {
        let mut inside = vec![false; self.inside.len()];
        let mut open: Vec<[i64; 2]> = vec![from];
        while let Some(offset) = open.pop() {
            let Some(place) = self.place(offset).filter(|place| self.inside[*place] && !inside[*place]) else {
                continue;
            };
            inside[place] = true;
            open.extend([[-1, 0], [1, 0], [0, -1], [0, 1]].map(|[u, v]| [offset[0] + u, offset[1] + v]));
        }
        Mask { half: self.half, inside }
    }

    /// These pixels and the holes that they surround.
    pub(super) fn filled(&self) -> Mask {
        let half = self.half + 1;
        let outside = Mask::of(half, |offset| !self.holds(offset)).connected([half, half]);
        Mask::of(self.half, |offset| !outside.holds(offset))
    }

    /// These pixels without others.
    pub(super) fn without(&self, other: &Mask) -> Mask {
        let pairs = self.inside.iter().zip(&other.inside);
        Mask { half: self.half, inside: pairs.map(|(one, other)| *one && !*other).collect() }
    }

    /// These pixels without those that are not among others.
    pub(super) fn and(&self, other: &Mask) -> Mask {
        let pairs = self.inside.iter().zip(&other.inside);
        Mask { half: self.half, inside: pairs.map(|(one, other)| *one && *other).collect() }
    }
}

/// Shape of a body around its middle: a disc, or pixels.
#[derive(Clone, Debug)]
pub(crate) struct Shape {
    /// Radius of the disc of the same area, px.
    pub radius: f64,
    /// Maximum distance of a pixel of the body from the middle, px.
    pub extent: f64,
    field: Option<Arc<Field>>,
    /// Size relative to the field.
    scale: f64,
}

/// Distances in px of pixels from the body, 0 inside.
#[derive(Debug)]
struct Field {
    half: i64,
    beyond: Vec<f32>,
}

/// Distance from the outline that the field covers: multiple of the radius, and additional px.
const COVERED: (f64, f64) = (0.5, 6.0);

impl Shape {
    pub(crate) fn disc(radius: f64) -> Shape {
        Shape { radius, extent: radius, field: None, scale: 1.0 }
    }

    /// Shape of some pixels around the middle one.
    pub(super) fn of(mask: &Mask) -> Shape {
        let radius = (mask.count() as f64 / std::f64::consts::PI).sqrt();
        let extent = mask.offsets().map(|[u, v]| libm::hypot(u as f64, v as f64)).fold(radius, f64::max);
        let half = (extent + COVERED.0 * radius + COVERED.1).ceil() as i64;
        let beyond = mask.around([0, 0], half).distances(true).into_iter().map(|far| far as f32).collect();
        Shape { radius, extent, field: Some(Arc::new(Field { half, beyond })), scale: 1.0 }
    }

    /// Distance of an offset (px) from the body: 0 inside.
    pub(crate) fn beyond(&self, [u, v]: [f64; 2]) -> f64 {
        let Some(field) = &self.field else { return (libm::hypot(u, v) - self.radius).max(0.0) };
        let [column, row] = [u, v].map(|at| (at / self.scale).round() as i64);
        if column.abs() > field.half || row.abs() > field.half {
            return f64::INFINITY;
        }
        let place = (row + field.half) * (2 * field.half + 1) + column + field.half;
        field.beyond.get(place as usize).map_or(f64::INFINITY, |far| self.scale * f64::from(*far))
    }

    /// Shape with so many times the size.
    pub(super) fn scaled(&self, by: f64) -> Shape {
        let [radius, extent, scale] = [self.radius, self.extent, self.scale].map(|length| length * by);
        Shape { radius, extent, scale, field: self.field.clone() }
    }
}
