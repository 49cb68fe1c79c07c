//! Disc of a body from its motion between two frames. The motion distinguishes a body from a similar wall, and from a
//! spot on the body.

use crate::tracking::body::background::{Around, Compared, distance};
use crate::tracking::body::disc::{BESIDE, Disc, SMALLEST};
use crate::tracking::body::look::ALIKE;

/// Radius of a disc in cells of the coarse and of the fine comparison.
const CELLS: [f64; 2] = [5.0, 16.0];
/// Ratio of successive trial radii.
const RATIO: f64 = 1.25;
/// Maximum displacement between the frames, in radii and additional px.
const WAY: (f64, f64) = (2.2, 6.0);
/// Cost of a cell that is visible in one frame only, relative to a cell that contradicts the motion. It balances small
/// and large discs.
const UNSEEN: f64 = 0.35;
/// Change of a cell that may be noise.
const FLOOR: f64 = 0.15;
/// Number of displacements that are evaluated completely for each radius.
const CANDIDATES: usize = 60;
/// Minimum change explained by the motion, per cell of the disc.
const EXPLAINED: f64 = 0.2;
/// Minimum change explained by the motion, in pixels altogether.
const EVIDENT: f64 = 150.0;
/// Minimum displacement for an outline, px.
const SHORTEST: f64 = 2.0;

/// Disc of a body and its displacement since the first frame, px.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Departure {
    pub disc: Disc,
    pub way: [f64; 2],
    /// Number of changed pixels that the motion explains, in both frames.
    pub explained: f64,
    /// Agreement of the pixels of the disc with the motion rather than with rest, -1 to 1.
    pub coherence: f64,
}

/// Mean shades of square cells around a click, in two frames.
struct Cells {
    /// Side of a cell, px.
    size: i64,
    /// Number of cells on each side of the middle one.
    reach: i64,
    shades: [Vec<[f32; 3]>; 2],
    /// Squared distance of shades that may be due to noise.
    alike: f32,
}

/// Disc and displacement, in cells relative to the cell of the click.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Motion {
    middle: [i64; 2],
    way: [i64; 2],
    radius: f64,
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
        Cells { size, reach, shades: [all(first), all(now)], alike: ALIKE * ALIKE * noise * noise }
    }

    fn shade(&self, frame: usize, [column, row]: [i64; 2]) -> Option<[f32; 3]> {
        let within = column.abs() <= self.reach && row.abs() <= self.reach;
        let place = (row + self.reach) * (2 * self.reach + 1) + column + self.reach;
        within.then(|| self.shades.get(frame)?.get(usize::try_from(place).ok()?).copied()).flatten()
    }

    /// Change from a cell of the first frame to a cell of the second, 0 to 1.
    fn change(&self, from: [i64; 2], to: [i64; 2]) -> f64 {
        let Some((one, other)) = self.shade(0, from).zip(self.shade(1, to)) else { return 0.0 };
        let far = distance(one, other);
        f64::from(far / (far + self.alike))
    }

    /// Change explained by a motion, in cells. Compares each frame with the other one, with and without displacement.
    fn gain(&self, motion: &Motion) -> f64 {
        let [across, down] = motion.way;
        let inside = |u: i64, v: i64| ((u * u + v * v) as f64) <= motion.radius * motion.radius;
        let extent = motion.radius.floor() as i64;
        let mut gain = 0.0;
        for v in -extent..=extent {
            for u in (-extent..=extent).filter(|u| inside(*u, v)) {
                let from = [motion.middle[0] + u, motion.middle[1] + v];
                let to = [from[0] + across, from[1] + down];
                let (left, reached) = (self.change(from, from), self.change(to, to));
                gain += left + reached - 2.0 * self.change(from, to);
                gain += if inside(u - across, v - down) { 0.0 } else { left - UNSEEN };
                gain += if inside(u + across, v + down) { 0.0 } else { reached - UNSEEN };
            }
        }
        gain
    }

    /// Agreement of the cells of a disc with the motion rather than with rest, -1 to 1; 0 without a visible change.
    fn coherence(&self, motion: &Motion) -> f64 {
        let extent = motion.radius.floor() as i64;
        let (mut difference, mut sum) = (0.0, f64::MIN_POSITIVE);
        for v in -extent..=extent {
            for u in -extent..=extent {
                if (u * u + v * v) as f64 > motion.radius * motion.radius {
                    continue;
                }
                let from = [motion.middle[0] + u, motion.middle[1] + v];
                let to = [from[0] + motion.way[0], from[1] + motion.way[1]];
                let change = |from, to| (self.change(from, to) - FLOOR).max(0.0);
                let (resting, moving) = (change(from, from) + change(to, to), 2.0 * change(from, to));
                difference += resting - moving;
                sum += resting + moving;
            }
        }
        difference / sum
    }

    /// Change explained by a motion, in pixels, reduced for a click far from the middle. 0 for an inadmissible motion.
    /// `known`: true if the disc is given.
    fn value(&self, motion: &Motion, known: bool) -> f64 {
        let off = hypot(motion.middle) / motion.radius;
        if motion.radius * (self.size as f64) < SMALLEST || off > if known { 0.0 } else { BESIDE } {
            return 0.0;
        }
        self.gain(motion) * (1.0 - 0.15 * off * off) * (self.size * self.size) as f64
    }

    /// Best motion of a disc with a radius in cells.
    fn search(&self, radius: f64, known: bool) -> Option<(f64, Motion)> {
        let extent = self.reach - radius.ceil() as i64;
        let inside = |reach: f64| {
            let most = reach.floor() as i64;
            let all = (-most..=most).flat_map(move |v| (-most..=most).map(move |u| [u, v]));
            all.filter(move |place| hypot(*place) <= reach)
        };
        // Sum of the changes within the disc around each cell.
        let side = 2 * extent + 1;
        let disc: Vec<[i64; 2]> = inside(radius).collect();
        let changed: Vec<f64> = (0..side * side)
            .map(|at| {
                let [x, y] = [at % side - extent, at / side - extent];
                disc.iter().map(|[u, v]| self.change([x + u, y + v], [x + u, y + v])).sum()
            })
            .collect();
        let changed = |[x, y]: [i64; 2]| {
            let place = (y + extent) * side + x + extent;
            usize::try_from(place).ok().and_then(|place| changed.get(place)).copied().unwrap_or(0.0)
        };
        let most = WAY.0 * radius + WAY.1 / self.size as f64;
        let ways: Vec<([i64; 2], f64)> = inside(most)
            .filter(|way| hypot(*way) * self.size as f64 >= SHORTEST)
            .map(|way| {
                let far = (hypot(way) / (2.0 * radius)).min(1.0);
                (way, (libm::acos(far) - far * (1.0 - far * far).sqrt()) / std::f64::consts::FRAC_PI_2)
            })
            .collect();
        let mut motions = Vec::new();
        for middle in inside(if known { 0.0 } else { BESIDE * radius }) {
            for (way, common) in &ways {
                let changes = changed(middle) + changed([middle[0] + way[0], middle[1] + way[1]]);
                let bound = changes * (1.0 - common / 2.0) - UNSEEN * disc.len() as f64 * (1.0 - common);
                motions.push((bound, Motion { middle, way: *way, radius }));
            }
        }
        let last = CANDIDATES.min(motions.len().checked_sub(1)?);
        motions.select_nth_unstable_by(last, |one, other| other.0.total_cmp(&one.0));
        let best = motions[..=last].iter().map(|(_, motion)| (self.value(motion, known), *motion));
        best.max_by(|one, other| one.0.total_cmp(&other.0))
    }

    /// Improves a motion by single steps.
    fn climb(&self, mut best: (f64, Motion), known: bool) -> (f64, Motion) {
        for step in [3, 1] {
            loop {
                let before = best;
                for k in 0..2 {
                    for sign in [-step, step] {
                        let mut shifted = before.1;
                        shifted.middle[k] += sign;
                        let mut turned = before.1;
                        turned.way[k] += sign;
                        let mut kept = shifted;
                        kept.way[k] -= sign;
                        let sized = Motion { radius: before.1.radius + sign as f64 / 2.0, ..before.1 };
                        let motions = [shifted, turned, kept, sized];
                        for motion in motions.iter().take(if known { 3 } else { 4 }) {
                            let value = self.value(motion, known);
                            if value > best.0 {
                                best = (value, *motion);
                            }
                        }
                    }
                }
                if best == before {
                    break;
                }
            }
        }
        best
    }
}

/// How much better the pixels of a disc agree with a way in pixels than with rest, from -1 to 1; 0 where neither shows.
pub(crate) fn coherence(first: &Compared<'_>, now: &Compared<'_>, (middle, radius): Around, way: [f64; 2]) -> f64 {
    let size = ((radius / CELLS[1]) as i64).max(1);
    let cells = Cells::new(first, now, middle, size, radius + libm::hypot(way[0], way[1]));
    let way = way.map(|part| (part / size as f64).round() as i64);
    cells.coherence(&Motion { middle: [0, 0], way, radius: radius / size as f64 })
}

fn hypot([x, y]: [i64; 2]) -> f64 {
    libm::hypot(x as f64, y as f64)
}

/// Motion of a clicked body from the first frame to `now`. `click`: position in the first frame, px; `greatest`:
/// maximum radius, px; `known`: given disc, whose size is kept. `None` if no motion is evident.
pub(crate) fn departure(
    first: &Compared<'_>,
    now: &Compared<'_>,
    click: [f64; 2],
    greatest: f64,
    known: Option<Disc>,
) -> Option<Departure> {
    let size = |radius: f64, cells: f64| ((radius / cells) as i64).max(1);
    let extent = |radius: f64| (1.0 + BESIDE + WAY.0) * radius + WAY.1 + 3.0;
    let (is_known, click) = (known.is_some(), known.map_or(click, |disc| disc.middle(click)));
    let (least, greatest) = known.map_or((SMALLEST, greatest), |disc| (disc.outline, disc.outline));
    let mut best: Option<(f64, Motion, i64)> = None;
    let mut radius = least;
    while radius <= greatest {
        let cells = Cells::new(first, now, click, size(radius, CELLS[0]), extent(radius));
        let found = cells.search(radius / cells.size as f64, is_known);
        if let Some((value, motion)) = found.filter(|found| best.is_none_or(|best| found.0 > best.0)) {
            best = Some((value, motion, cells.size));
        }
        radius = (radius * RATIO).max(radius + 1.0);
    }
    let (_, coarse, side) = best.filter(|best| best.0 > 0.0)?;
    let radius = coarse.radius * side as f64;
    let cells = Cells::new(first, now, click, size(radius, CELLS[1]), 1.5 * extent(radius));
    let scaled = |place: [i64; 2]| place.map(|at| (at * side + cells.size / 2).div_euclid(cells.size));
    let (middle, way) = (scaled(coarse.middle), scaled(coarse.way));
    let start = Motion { middle, way, radius: radius / cells.size as f64 };
    let (explained, motion) = cells.climb((cells.value(&start, is_known), start), is_known);
    let [middle, way] = [motion.middle, motion.way].map(|place| place.map(|at| (at * cells.size) as f64));
    let radius = motion.radius * cells.size as f64;
    let moved = libm::hypot(way[0], way[1]) >= SHORTEST;
    let enough = explained > EVIDENT.max(EXPLAINED * std::f64::consts::PI * radius * radius);
    (moved && enough).then_some(Departure {
        disc: known.unwrap_or(Disc::of(middle, radius)),
        way,
        explained,
        coherence: cells.coherence(&motion),
    })
}
