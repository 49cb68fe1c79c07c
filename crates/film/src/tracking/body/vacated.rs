//! Disc of a clicked body from the pixels that it covers in the frame of the click and has left some frames later.

use crate::plane::Plane;
use crate::tracking::body::background::{LEAST, distance, dull, usual};
use crate::tracking::body::disc::{BESIDE, Disc, SMALLEST};
use crate::tracking::body::look::ALIKE;
use crate::tracking::median::median;

/// Outer radius of the ring around a disc: multiple of the radius, and additional px.
const RING: (f64, f64) = (1.25, 2.0);
/// Distance of the ring from the disc, px. The pixels between them show both.
const OUTLINE: f64 = 1.0;
/// Minimum mean change of the pixels in a disc, and minimum difference from the ring.
const CHANGED: (f64, f64) = (0.15, 0.1);
/// Maximum change of the pixels in the disc once the body has left it, relative to the change in the frame of the
/// click, both beyond that of noise.
const REST: f64 = 0.2;
/// Mean change by noise.
const NOISE: f64 = 0.06;
/// Eighths of the frames after which the disc must be at rest.
const AFTER: [usize; 3] = [5, 6, 8];
/// Number of pixels along the greatest radius.
const FINE: f64 = 48.0;

/// Changes of pixels relative to their temporal median, 0 to 1, in the first frame and in some of the second half.
struct Changes {
    /// First pixel, and distance between pixels, px.
    corner: [i64; 2],
    step: i64,
    width: usize,
    height: usize,
    /// For each of these frames, sums of each row from its left end, one more than pixels.
    sums: Vec<Vec<f64>>,
}

impl Changes {
    /// `None` if the square around the point (px) lies outside the picture.
    fn new(planes: &[&Plane], [x, y]: [f64; 2], reach: f64, step: i64) -> Option<Changes> {
        let first = planes.first()?;
        let after = AFTER.iter().filter_map(|part| planes.get((planes.len() - 1) * part / 8));
        let compared: Vec<&&Plane> = std::iter::once(first).chain(after).collect();
        let range = |at: f64, size: usize| {
            let (least, most) = ((at - reach).floor().max(0.0) as i64, (at + reach).ceil().min(size as f64) as i64);
            (least, usize::try_from((most - least + step - 1) / step).ok())
        };
        let ((left, width), (top, height)) = (range(x, first.width()), range(y, first.height()));
        let (width, height) = (width?, height?);
        let places = (0..height as i64).flat_map(|row| (0..width as i64).map(move |column| (column, row)));
        let places = places.map(|(column, row)| (left + step * column, top + step * row));
        let mut differences = vec![Vec::with_capacity(width * height); compared.len()];
        for (column, row) in places {
            let usual = usual(planes, column, row).map(f32::from);
            for (plane, differences) in compared.iter().zip(&mut differences) {
                let shade = plane.shade(column, row).map(f32::from);
                differences.push([0, 1, 2].map(|k| shade[k] - usual[k]));
            }
        }
        let middle = |k: usize, of: &[[f32; 3]], from: f32, absolute: bool| {
            let value = |step: &[f32; 3]| f64::from(if absolute { (step[k] - from).abs() } else { step[k] });
            median(of.iter().map(value).collect()) as f32
        };
        let summed = |mut differences: Vec<[f32; 3]>| {
            let brighter = middle(0, &differences, 0.0, false);
            differences.iter_mut().for_each(|step| step[0] -= brighter);
            // 0.6745 converts the median absolute deviation of a normal distribution to its standard deviation.
            let noise = [0, 1, 2].map(|k| middle(k, &differences, 0.0, true) / 0.6745);
            let grey = noise[0].max(LEAST);
            let (alike, dull) = (ALIKE * ALIKE * grey * grey, dull([noise[1], noise[2]]));
            let mut sums = Vec::with_capacity((width + 1) * height);
            for row in differences.chunks(width.max(1)) {
                let mut sum = 0.0;
                sums.push(sum);
                sums.extend(row.iter().map(|step| {
                    let far = distance(*step, [0.0; 3], dull);
                    sum += f64::from(far / (far + alike));
                    sum
                }));
            }
            sums
        };
        let sums = differences.into_iter().map(summed).collect();
        Some(Changes { corner: [left, top], step, width, height, sums })
    }

    /// Sum of the changes in a frame within a disc, and number of pixels.
    fn within(&self, [x, y]: [f64; 2], radius: f64, frame: usize) -> (f64, f64) {
        let scale = 1.0 / self.step as f64;
        let (x, y) = ((x - self.corner[0] as f64) * scale, (y - self.corner[1] as f64) * scale);
        let radius = radius * scale;
        let (mut sum, mut count) = (0.0, 0.0);
        let rows = ((y - radius).max(0.0) as usize)..((y + radius).clamp(0.0, self.height as f64) as usize);
        for row in rows {
            let down = row as f64 + 0.5 - y;
            let half = (radius * radius - down * down).max(0.0).sqrt();
            let place = |edge: f64| row * (self.width + 1) + edge.round().clamp(0.0, self.width as f64) as usize;
            let (from, to) = (place(x - half), place(x + half));
            let at = |place: usize| self.sums[frame].get(place).copied().unwrap_or(0.0);
            sum += at(to) - at(from);
            count += (to - from) as f64;
        }
        (sum, count)
    }

    /// Mean change in a disc and in the ring around it, in the first frame.
    fn means(&self, middle: [f64; 2], radius: f64) -> (f64, f64) {
        let inside = self.within(middle, radius, 0);
        let gap = self.within(middle, radius + OUTLINE, 0);
        let ring = self.within(middle, RING.0 * radius + RING.1, 0);
        (inside.0 / inside.1.max(1.0), (ring.0 - gap.0) / (ring.1 - gap.1).max(1.0))
    }

    /// Mean change on a circle, in the first frame.
    fn at(&self, middle: [f64; 2], radius: f64) -> f64 {
        let half = self.step as f64;
        let (inner, outer) = (self.within(middle, radius - half, 0), self.within(middle, radius + half, 0));
        (outer.0 - inner.0) / (outer.1 - inner.1).max(1.0)
    }

    /// True if the body has left the disc.
    fn is_vacated(&self, middle: [f64; 2], radius: f64) -> bool {
        let (inside, around) = self.means(middle, radius);
        let rests = |frame: usize| {
            let (sum, count) = self.within(middle, radius, frame);
            sum / count.max(1.0) - NOISE < REST * (inside - NOISE)
        };
        // The body may have come back in one of them.
        let resting = (1..self.sums.len()).filter(|frame| rests(*frame)).count();
        inside > CHANGED.0 && inside - around > CHANGED.1 && resting + 2 > self.sums.len()
    }
}

/// Disc around a click (px) in the first of some frames whose pixels differ most from their temporal median, and those
/// around it least, and true if the body has left it. `greatest`: maximum radius, px; `given`: the disc, if it is given.
pub(crate) fn vacated(planes: &[&Plane], [x, y]: [f64; 2], greatest: f64, given: Option<Disc>) -> Option<(Disc, bool)> {
    let step = ((greatest / FINE) as i64).max(1);
    let changes = Changes::new(planes, [x, y], (RING.0 + BESIDE) * greatest + RING.1, step)?;
    if let Some(disc) = given {
        return Some((disc, changes.is_vacated(disc.middle([x, y]), disc.outline)));
    }
    let mut best = (0.0, [x, y], SMALLEST);
    let seek = |best: &mut (f64, [f64; 2], f64), middle: [f64; 2], radius: f64| {
        let off = libm::hypot(middle[0] - x, middle[1] - y) / radius;
        if off > BESIDE || !(SMALLEST..=greatest).contains(&radius) {
            return;
        }
        let (inside, around) = changes.means(middle, radius);
        let own = (inside - around) * radius * (1.0 - 0.15 * off * off);
        if own > best.0 {
            *best = (own, middle, radius);
        }
    };
    let mut radius = SMALLEST;
    while radius <= greatest {
        let step = (radius / 5.0).max(1.0);
        let steps = (BESIDE * radius / step).ceil() as i32;
        for row in -steps..=steps {
            for column in -steps..=steps {
                seek(&mut best, [x + step * f64::from(column), y + step * f64::from(row)], radius);
            }
        }
        radius += (radius / 8.0).max(1.0);
    }
    for step in [2.0, 1.0, 0.5] {
        loop {
            let (before, middle, radius) = best;
            for k in 0..3 {
                for by in [-step, step] {
                    let by = |axis: usize| if axis == k { by } else { 0.0 };
                    seek(&mut best, [middle[0] + by(0), middle[1] + by(1)], radius + by(2));
                }
            }
            if best.0 <= before {
                break;
            }
        }
    }
    let (own, middle, mut radius) = best;
    // Motion during the exposure blurs the outline: it is where the change falls to half.
    let (inside, around) = changes.means(middle, radius);
    while radius > SMALLEST + 1.0 && changes.at(middle, radius) < (inside + around) / 2.0 {
        radius -= 0.5;
    }
    let disc = Disc::of([middle[0] - x, middle[1] - y], radius);
    (own > 0.0).then(|| (disc, changes.is_vacated(middle, radius)))
}
