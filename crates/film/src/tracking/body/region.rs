//! Shape of a clicked body: the pixels around the click that have changed once it has moved away. The wall behind it becomes visible then.

use crate::plane::Plane;
use crate::tracking::body::background::{Background, LEAST, distance, dull, few, usual};
use crate::tracking::body::disc::{Disc, SMALLEST, fitted};
use crate::tracking::body::look::ALIKE;
use crate::tracking::body::shape::{Mask, Shape};
use crate::tracking::median::{median, median_shade};

/// Maximum distance of the examined pixels from the click, relative to the greatest radius.
const AROUND: f64 = 2.0;
/// Maximum number of frames for the temporal median.
const MEDIAN: usize = 17;
/// Eighths of the frames after which the body must have left.
const AFTER: [usize; 3] = [5, 6, 8];
/// Change of a pixel in units of what noise may be, from which it shows the body.
const CHANGED: f64 = 0.5;
/// Quantile of the changes of the pixels of a body, and change of a pixel relative to it below which it is a trace.
const FAINT: (f64, f64) = (0.85, 0.2);
/// Width of the blurred edge in px, within which the outline is where the change falls to half.
const BLURRED: i64 = 3;
/// Maximum distance of a click from the changed pixels, px.
const BESIDE: i64 = 4;
/// Weight of the squared distance of a circle from the click, relative to its radius.
const ASIDE: f64 = 0.15;
/// Width of what is taken for a thread, a rod or a spring, relative to that of the body.
const THREAD: f64 = 0.5;
/// Ratio of the changed pixels in the best circle to those of the body from which the body is more than connected pixels.
const SCATTERED: f64 = 1.25;
/// Radius of the best circle relative to that of the body from which the rest of the circle may belong to the body, squared distance of shades that are
/// alike, and that of shades that differ.
const WIDER: f64 = 1.15;
const SAME: f32 = 20.0 * 20.0;
const OTHER: f32 = 30.0 * 30.0;
/// Half the width in px of gaps in a body, where it looks like the background.
const GAP: f64 = 3.0;
/// Brightness of a shadow relative to that of the lit background, its maximum change per px, and the maximum difference of its colours from those
/// of the background, grey values.
const SHADOW: (std::ops::Range<f64>, f64, f64) = (0.5..0.92, 0.012, 3.0);
/// Half the width of the square whose mean shade is examined for shadows, and distance in px over which its change is.
const EVEN: (i64, i64) = (2, 3);
/// Grey value of black.
const BLACK: f64 = 16.0;
/// Fraction of the frames in which a pixel of the body differs from the background, and range of the size of a completed body relative to that at
/// the click.
const MOSTLY: f32 = 0.5;
const LARGER: f64 = 1.06;
const LARGEST: f64 = 1.6;
/// Width of the blurred edge that differs from the background, too, px.
const EDGE: f64 = 2.0;
/// Maximum change of the pixels of the body once it has left them, relative to the change at the click, both beyond that of noise.
const REST: f64 = 0.35;
const NOISE: f64 = 0.2;
/// Width of the surroundings relative to the radius of the body.
const BESIDES: f64 = 0.5;

/// Body at a click.
#[derive(Clone, Debug)]
pub(super) struct Region {
    /// Circle around the body.
    pub disc: Disc,
    pub shape: Shape,
    /// True if the body has left the place of the click.
    pub has_left: bool,
    /// True if nothing has been near that place since then.
    pub is_vacated: bool,
}

/// Changes of pixels relative to their temporal median in units of what noise may be, in the first frame and in some of the second half.
struct Changes {
    half: i64,
    frames: Vec<Vec<f64>>,
    /// Shades of the pixels in the first frame and their medians; `None` outside of the picture.
    shades: Vec<Option<[[f64; 3]; 2]>>,
}

impl Changes {
    /// Changes of the pixels around one, at most `half` px away along each coordinate. Outside of the picture there are none.
    fn new(planes: &[&Plane], [x, y]: [i64; 2], half: i64) -> Option<Changes> {
        let first = planes.first()?;
        let last = planes.len() - 1;
        let after = AFTER.iter().filter_map(|part| planes.get(last * part / 8));
        let compared: Vec<&&Plane> = std::iter::once(first).chain(after).collect();
        let some = few(planes, MEDIAN);
        let (wide, high) = (first.width() as i64, first.height() as i64);
        let side = (2 * half + 1) as usize;
        let mut steps = vec![vec![None; side * side]; compared.len()];
        let mut shades = vec![None; side * side];
        for (place, (row, column)) in
            (y - half..=y + half).flat_map(|row| (x - half..=x + half).map(move |c| (row, c))).enumerate()
        {
            if (0..wide).contains(&column) && (0..high).contains(&row) {
                let usual = usual(&some, column, row).map(f32::from);
                shades[place] = Some([first.shade(column, row).map(f64::from), usual.map(f64::from)]);
                for (plane, steps) in compared.iter().zip(&mut steps) {
                    let shade = plane.shade(column, row).map(f32::from);
                    steps[place] = Some([0, 1, 2].map(|k| shade[k] - usual[k]));
                }
            }
        }
        let frames = steps.iter().map(|steps| changes(steps, side)).collect();
        Some(Changes { half, frames, shades })
    }

    fn at(&self, frame: usize, place: [i64; 2]) -> f64 {
        self.place(place).map_or(0.0, |place| self.frames[frame][place])
    }

    fn place(&self, [column, row]: [i64; 2]) -> Option<usize> {
        let is_within = column.abs() <= self.half && row.abs() <= self.half;
        is_within.then_some(((row + self.half) * (2 * self.half + 1) + column + self.half) as usize)
    }

    /// Brightness relative to the background in a square around a pixel, and difference of the colours from those of the background at that
    /// brightness, grey values.
    fn light(&self, [column, row]: [i64; 2]) -> Option<(f64, f64)> {
        let half = EVEN.0;
        let square = (-half..=half).flat_map(|v| (-half..=half).map(move |u| [column + u, row + v]));
        let mut sums = [[0.0; 3]; 2];
        let mut count = 0.0_f64;
        for shades in square.filter_map(|place| self.shades[self.place(place)?]) {
            sums.iter_mut().flatten().zip(shades.as_flattened()).for_each(|(sum, shade)| *sum += shade);
            count += 1.0;
        }
        let [now, usual] = sums.map(|sum| [sum[0] / count - BLACK, sum[1] / count - 128.0, sum[2] / count - 128.0]);
        let ratio = now[0] / usual[0].max(1.0);
        let off = libm::hypot(now[1] - ratio * usual[1], now[2] - ratio * usual[2]);
        (count > 0.0).then_some((ratio, off))
    }

    /// Pixels at which the background is darker by a factor that is the same around them.
    fn shadow(&self) -> Mask {
        let all: Vec<Option<(f64, f64)>> =
            Mask::of(self.half, |_| true).grid().map(|place| self.light(place)).collect();
        let light = |place: [i64; 2]| all[self.place(place)?];
        let is_dark = |place: [i64; 2]| light(place).filter(|(ratio, off)| SHADOW.0.contains(ratio) && *off < SHADOW.2);
        let slope = |[column, row]: [i64; 2], [u, v]: [i64; 2]| {
            let far = EVEN.1;
            let [one, other] = [-far, far].map(|by| is_dark([column + by * u, row + by * v]));
            one.zip(other).map(|(one, other)| (other.0 - one.0) / (2 * far) as f64)
        };
        let core = Mask::of(self.half, |place| {
            is_dark(place)
                .and(slope(place, [1, 0]).zip(slope(place, [0, 1])))
                .is_some_and(|(x, y)| libm::hypot(x, y) < SHADOW.1)
        });
        let dark = Mask::of(self.half, |place| light(place).is_some_and(|(ratio, off)| ratio < 1.0 && off < SHADOW.2));
        core.dilated((EVEN.0 + 2 * EVEN.1) as f64).and(&dark)
    }

    /// Sum of the changes of some pixels beyond those of noise.
    fn sum(&self, frame: usize, pixels: &Mask) -> f64 {
        pixels.offsets().map(|offset| (self.at(frame, offset) - NOISE).clamp(0.0, 1.0)).sum()
    }

    /// True if most of some pixels have a shade of the body in the first frame: they belong to it and look like the background.
    fn is_alike(&self, body: &Mask, pixels: &Mask) -> bool {
        let shades = |mask: &Mask| -> Vec<[f32; 3]> {
            let places = mask.offsets().filter_map(|place| self.shades[self.place(place)?]);
            places.map(|[first, _]| first.map(|part| part as f32)).collect()
        };
        let own = shades(body);
        let most = median_shade(&own, f32::total_cmp);
        let others: Vec<[f32; 3]> = own.into_iter().filter(|shade| distance(*shade, most, 0.0) > OTHER).collect();
        let second = if others.is_empty() { most } else { median_shade(&others, f32::total_cmp) };
        let pixels = shades(pixels);
        let is_own = |shade: &&[f32; 3]| distance(**shade, most, 0.0).min(distance(**shade, second, 0.0)) < SAME;
        2 * pixels.iter().filter(is_own).count() > pixels.len()
    }

    /// Pixels that show something else than usual in the first frame.
    fn changed(&self) -> Mask {
        Mask::of(self.half, |place| self.at(0, place) > CHANGED)
    }

    /// Some pixels without those that changed much less than those of a body: compression and half the resolution of colours leave traces around it.
    fn without_faint(&self, pixels: &Mask, body: &Mask) -> Mask {
        let mut all: Vec<f64> = body.offsets().map(|place| self.at(0, place)).collect();
        all.sort_by(f64::total_cmp);
        let least = FAINT.1 * all.get((FAINT.0 * all.len() as f64) as usize).copied().unwrap_or(0.0);
        Mask::of(self.half, |place| pixels.holds(place) && self.at(0, place) >= least)
    }

    /// Some pixels without those of a blurred edge that show the background for the most part.
    fn without_blur(&self, body: &Mask) -> Mask {
        let greatest = |[column, row]: [i64; 2]| {
            let square = (-BLURRED..=BLURRED).flat_map(|v| (-BLURRED..=BLURRED).map(move |u| [column + u, row + v]));
            square.filter(|place| body.holds(*place)).map(|place| self.at(0, place)).fold(0.0, f64::max)
        };
        Mask::of(self.half, |place| body.holds(place) && self.at(0, place) >= 0.5 * greatest(place))
    }

    /// True if the body has left its pixels and those so many px around. It may have come back in one of the later frames.
    fn is_left(&self, body: &Mask, by: f64) -> bool {
        let around = body.dilated(by);
        let first = self.sum(0, body);
        let resting = (1..self.frames.len()).filter(|frame| self.sum(*frame, &around) < REST * first).count();
        first > 0.0 && resting + 2 > self.frames.len()
    }
}

/// Changes by these differences of shades, as means over three pixels along each coordinate.
fn changes(steps: &[Option<[f32; 3]>], side: usize) -> Vec<f64> {
    let known = || steps.iter().flatten();
    let middle = |k: usize, from: f32, absolute: bool| {
        let value = |step: &[f32; 3]| f64::from(if absolute { (step[k] - from).abs() } else { step[k] });
        median(known().map(value).collect()) as f32
    };
    let usual = [0, 1, 2].map(|k| middle(k, 0.0, false));
    // 0.6745 converts the median absolute deviation of a normal distribution to its standard deviation.
    let noise = [0, 1, 2].map(|k| middle(k, usual[k], true) / 0.6745);
    let (alike, dull) = (ALIKE * noise[0].max(LEAST), dull([noise[1], noise[2]]));
    let own: Vec<f64> = steps
        .iter()
        .map(|step| step.map_or(0.0, |step| f64::from(distance(step, usual, dull).sqrt() / alike)))
        .collect();
    let mean = |place: usize| {
        let (column, row) = (place % side, place / side);
        let range = |at: usize| at.saturating_sub(1)..(at + 2).min(side);
        let (rows, columns) = (range(row), range(column));
        let count = (rows.len() * columns.len()) as f64;
        rows.flat_map(|row| columns.clone().map(move |column| row * side + column)).map(|place| own[place]).sum::<f64>()
            / count
    };
    (0..own.len()).map(mean).collect()
}

/// Radius of the largest circle in a body around a pixel, and its middle.
fn inscribed(body: &Mask, [x, y]: [i64; 2]) -> (f64, [i64; 2]) {
    let distances = body.distances(false);
    let (mut best, mut radius) = ((0.0, [x, y]), 0.0);
    for ([u, v], far) in body.grid().zip(distances) {
        let off = libm::hypot((u - x) as f64, (v - y) as f64);
        // Prefers circles about the click.
        let value = far * (1.0 - ASIDE * (off / far.max(1.0)) * (off / far.max(1.0)));
        if off <= far.max(BESIDE as f64) && value > best.0 {
            (best, radius) = ((value, [u, v]), far);
        }
    }
    (radius, best.1)
}

/// Body at a click (px) in the first of some frames. `greatest`: maximum radius, px.
pub(super) fn region(planes: &[&Plane], [x, y]: [f64; 2], greatest: f64) -> Option<Region> {
    let click = [x, y].map(|at| at.floor() as i64);
    let changes = Changes::new(planes, click, (AROUND * greatest).ceil() as i64)?;
    let changed = changes.changed();
    let nearest = |among: &Mask| {
        let nearest = among.offsets().min_by_key(|[u, v]| u * u + v * v)?;
        (nearest[0].abs().max(nearest[1].abs()) <= BESIDE).then_some(nearest)
    };
    nearest(&changed)?;
    let shadow = changes.shadow();
    let lit = if shadow.holds([0, 0]) { changed.clone() } else { changed.without(&shadow) };
    let lit = changes.without_faint(&lit, &lit.connected(nearest(&lit)?));
    let sharp = changes.without_blur(&lit);
    let whole = sharp.dilated(GAP).eroded(GAP).and(&lit);
    let closed = whole.connected(nearest(&whole)?).filled();
    let (radius, middle) = inscribed(&closed, [0, 0]);
    let by = THREAD * radius;
    let body = closed.eroded(by).dilated(by).and(&closed).connected(middle);
    let [u, v] = body.middle();
    let shape = Shape::of(&body.around([u, v].map(|at| at.round() as i64), body.half()));
    let (centre, round) = fitted(&sharp, greatest);
    let circle = Mask::of(body.half(), |[u, v]| libm::hypot(u as f64 - centre[0], v as f64 - centre[1]) <= round);
    // Before a background that looks like the body in part, a circle shows the outline better than the pixels do.
    let count = body.count() as f64;
    let is_hidden = || round > WIDER * shape.radius && changes.is_alike(&body, &circle.without(&body));
    let is_scattered = sharp.and(&circle).count() as f64 > SCATTERED * count || is_hidden();
    let body = if is_scattered { circle } else { body };
    let [has_left, is_vacated] = [0.0, BESIDES * shape.radius].map(|by| changes.is_left(&body, by));
    let shift = |[u, v]: [f64; 2]| [click[0] as f64 + u + 0.5 - x, click[1] as f64 + v + 0.5 - y];
    let is_whole = !body.touches_edge() && (SMALLEST - 1.0..=greatest).contains(&shape.radius);
    let (disc, shape) = if is_scattered {
        (Disc::of(shift(centre), round), Shape::disc(round))
    } else if is_whole {
        (Disc::around_shape(shift([u, v]), &shape), shape)
    } else if radius >= SMALLEST - 1.0 {
        (Disc::of(shift(middle.map(|at| at as f64)), radius), Shape::disc(radius))
    } else {
        return None;
    };
    Some(Region { disc, shape, has_left, is_vacated })
}

/// A body with the pixels around it that differ from the background in most frames in which it was found: at the click a part of it may have looked
/// like the background. `seen`: these frames with the positions (px). `None` if there is nothing more.
pub(super) fn completed(
    (disc, shape): (Disc, &Shape),
    background: &Background,
    seen: &[(&Plane, [f64; 2])],
) -> Option<(Disc, Shape)> {
    let half = (LARGEST * shape.extent).ceil() as i64 + GAP as i64;
    let own = Mask::of(half, |[u, v]| shape.beyond([u as f64, v as f64]) <= 0.0);
    let mut sums = vec![0.0; own.grid().count()];
    for (plane, position) in seen {
        let compared = background.compare(plane);
        let [column, row] = disc.middle(*position).map(|at| at.floor() as i64);
        for (sum, [u, v]) in sums.iter_mut().zip(own.grid()) {
            *sum += compared.differs(column + u, row + v);
        }
    }
    let mut sums = sums.into_iter();
    let least = MOSTLY * seen.len() as f32;
    let blurred = Mask::of(half, |_| sums.next().is_some_and(|sum| sum > least));
    let sharp = blurred.eroded(EDGE);
    let mostly = Mask::of(half, |offset| sharp.holds(offset) || own.holds(offset));
    let by = THREAD * shape.radius;
    let body = mostly.eroded(by).dilated(by).and(&mostly);
    let body = Mask::of(half, |offset| body.holds(offset) || own.holds(offset)).connected([0, 0]).filled();
    let middle = body.middle();
    let whole = Shape::of(&body.around(middle.map(|at| at.round() as i64), half));
    let shift = [0, 1].map(|k| disc.shift[k] + middle[k]);
    (LARGER..LARGEST).contains(&(whole.radius / shape.radius)).then(|| (Disc::around_shape(shift, &whole), whole))
}

/// Given disc at a click (px) in the first of some frames.
pub(super) fn disc_region(planes: &[&Plane], [x, y]: [f64; 2], disc: Disc) -> Option<Region> {
    let half = (AROUND * disc.outline).ceil() as i64;
    let changes = Changes::new(planes, [x, y].map(|at| at.floor() as i64), half)?;
    let body = Mask::of(half, |[u, v]| libm::hypot(u as f64, v as f64) <= disc.outline);
    let has_left = changes.is_left(&body, 0.0);
    Some(Region { disc, shape: Shape::disc(disc.outline), has_left, is_vacated: has_left })
}
