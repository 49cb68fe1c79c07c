//! The evidence that a thing moves with the positions that are found for it.

use crate::plane::Plane;
use crate::tracking::body::background::{Around, Background, Compared, distance};
use crate::tracking::body::disc::Disc;
use crate::tracking::body::look::ALIKE;

/// Least way between two frames that are compared, in pixels and in radii.
const WAY: (f64, f64) = (2.0, 0.25);
/// Least coherence of pixels that move, and of pixels at rest with the opposite sign.
const COHERENT: f64 = 0.12;
/// Radius of a disc in cells.
const CELLS: f64 = 16.0;
/// Change of a cell that may be noise.
const FLOOR: f64 = 0.15;

/// Comparison of the pixels at successive positions. The pixels of a thing at rest, or of a wall that looks like the body, do not move with
/// the position.
pub(super) struct Moving {
    /// The frame that is compared next, and the position there.
    earlier: (Plane, [f64; 2]),
    /// Index of the last position with which pixels moved.
    pub last: usize,
    /// True if pixels have rested since then while the position moved.
    pub rests: bool,
    /// True once pixels have moved with a position.
    pub moved: bool,
}

impl Moving {
    /// Starts at a click, which is the position with this index.
    pub(super) fn new(plane: &Plane, position: [f64; 2], index: usize) -> Moving {
        Moving { earlier: (plane.clone(), position), last: index, rests: false, moved: false }
    }

    /// Takes the position with this index. Pixels that agree with motion and rest alike change nothing.
    pub(super) fn take(
        &mut self,
        background: &Background,
        (plane, position): (&Plane, [f64; 2]),
        disc: Disc,
        index: usize,
    ) {
        let (earlier, from) = &self.earlier;
        let way = [0, 1].map(|k| position[k] - from[k]);
        if libm::hypot(way[0], way[1]) < WAY.0.max(WAY.1 * disc.outline) {
            return;
        }
        let (first, now) = (background.compare(earlier), background.compare(plane));
        let coherence = coherence(&first, &now, (disc.middle(*from), disc.outline), way);
        self.earlier = (plane.clone(), position);
        if coherence > COHERENT {
            (self.last, self.rests, self.moved) = (index, false, true);
        } else if coherence < -COHERENT {
            self.rests = true;
        }
    }
}

/// Mean shades of square cells around a click, in two frames.
struct Cells {
    /// Number of cells on each side of the middle one.
    reach: i64,
    shades: [Vec<[f32; 3]>; 2],
    /// Squared distance of shades that may be due to noise.
    alike: f32,
    /// Squared distance of colours that may be due to noise.
    dull: f32,
}

impl Cells {
    fn new(first: &Compared<'_>, now: &Compared<'_>, click: [f64; 2], size: i64, extent: f64) -> Cells {
        let reach = (extent / size as f64).ceil() as i64;
        let [x, y] = click.map(|at| at.floor() as i64 - size / 2);
        let mean = |frame: &Compared<'_>, [column, row]: [i64; 2]| {
            let mut sum = [0.0; 3];
            for v in 0..size {
                for u in 0..size {
                    let shade = frame.shade(x + column * size + u, y + row * size + v);
                    sum.iter_mut().zip(shade).for_each(|(sum, part)| *sum += part);
                }
            }
            sum.map(|sum| sum / (size * size) as f32)
        };
        let all = |frame| {
            let rows = (-reach..=reach).flat_map(|row| (-reach..=reach).map(move |column| [column, row]));
            rows.map(|place| mean(frame, place)).collect()
        };
        // Means over cells have less noise, but compression and fractional shifts still change them.
        let noise = (now.noise / size as f32).max(1.5);
        let dull = now.dull / (size * size) as f32;
        Cells { reach, shades: [all(first), all(now)], alike: ALIKE * ALIKE * noise * noise, dull }
    }

    fn shade(&self, frame: usize, [column, row]: [i64; 2]) -> Option<[f32; 3]> {
        let within = column.abs() <= self.reach && row.abs() <= self.reach;
        let place = (row + self.reach) * (2 * self.reach + 1) + column + self.reach;
        within.then(|| self.shades.get(frame)?.get(usize::try_from(place).ok()?).copied()).flatten()
    }

    /// Change from a cell of the first frame to a cell of the second, 0 to 1.
    fn change(&self, from: [i64; 2], to: [i64; 2]) -> f64 {
        let Some((one, other)) = self.shade(0, from).zip(self.shade(1, to)) else { return 0.0 };
        let far = distance(one, other, self.dull);
        f64::from(far / (far + self.alike))
    }

    /// Agreement of the cells of a disc with the motion rather than with rest, -1 to 1; 0 without a visible change.
    fn coherence(&self, radius: f64, way: [i64; 2]) -> f64 {
        let extent = radius.floor() as i64;
        let (mut difference, mut sum) = (0.0, f64::MIN_POSITIVE);
        for v in -extent..=extent {
            for u in -extent..=extent {
                if (u * u + v * v) as f64 > radius * radius {
                    continue;
                }
                let (from, to) = ([u, v], [u + way[0], v + way[1]]);
                let change = |from, to| (self.change(from, to) - FLOOR).max(0.0);
                let (resting, moving) = (change(from, from) + change(to, to), 2.0 * change(from, to));
                difference += resting - moving;
                sum += resting + moving;
            }
        }
        difference / sum
    }
}

/// How much better the pixels of a disc agree with a way in pixels than with rest, from -1 to 1; 0 where neither shows.
fn coherence(first: &Compared<'_>, now: &Compared<'_>, (middle, radius): Around, way: [f64; 2]) -> f64 {
    let size = ((radius / CELLS) as i64).max(1);
    let cells = Cells::new(first, now, middle, size, radius + libm::hypot(way[0], way[1]));
    let way = way.map(|part| (part / size as f64).round() as i64);
    cells.coherence(radius / size as f64, way)
}
