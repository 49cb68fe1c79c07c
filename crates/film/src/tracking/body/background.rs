//! Stationary background of a body.

use crate::plane::Plane;
use crate::tracking::median::median_shade;

/// Number of frames for an update of all rows: each frame updates every eighth row.
const TURN: usize = 8;
/// Divisor of the deviation by which an updated pixel changes.
const PACE: i32 = 3;
/// Approximate number of pixels for the estimates of brightness and noise.
const COMPARED: usize = 4000;
/// Minimum standard deviation of a grey value; smaller ones are due to rounding.
pub(crate) const LEAST: f32 = 1.5;

/// Grey value of black.
const BLACK: f32 = 16.0;
/// Brightness of a shadow relative to that of the background, and maximum difference of its colours from those of the background at that
/// brightness.
const SHADED: (std::ops::Range<f32>, f32) = (0.5..0.95, 4.0);

/// Picture without the body. Pixels that the body has always covered are unknown.
pub(crate) struct Background {
    width: usize,
    height: usize,
    shades: Vec<[u8; 3]>,
    known: Vec<bool>,
    frames: usize,
}

/// Frame with the background for comparison.
pub(crate) struct Compared<'a> {
    pub plane: &'a Plane,
    pub background: &'a Background,
    /// Brightness of the frame relative to the background, grey values.
    brighter: f32,
    /// Standard deviation of a grey value.
    pub noise: f32,
    /// Squared distance of colours that may be due to noise.
    pub dull: f32,
}

/// Centre and radius of a disc, px.
pub(crate) type Around = ([f64; 2], f64);

impl Background {
    /// Background from the first frame, except the disc `body`.
    pub(crate) fn new(plane: &Plane, body: Around) -> Background {
        let (width, height) = (plane.width(), plane.height());
        let places = (0..height as i64).flat_map(|row| (0..width as i64).map(move |column| (column, row)));
        let shades = places.map(|(column, row)| plane.shade(column, row)).collect();
        let mut background = Background { width, height, shades, known: vec![true; width * height], frames: 0 };
        background.hide(body);
        background
    }

    /// Calls `act` for each pixel of a disc.
    fn within(&mut self, ([x, y], radius): Around, mut act: impl FnMut(&mut bool, &mut [u8; 3], (i64, i64))) {
        let range = |at: f64, size: usize| {
            let (least, most) = ((at - radius).floor().max(0.0), (at + radius).ceil().clamp(0.0, size as f64));
            least as usize..most as usize
        };
        for row in range(y, self.height) {
            for column in range(x, self.width) {
                let (u, v) = (column as f64 + 0.5 - x, row as f64 + 0.5 - y);
                let place = row * self.width + column;
                if u * u + v * v <= radius * radius
                    && let Some((known, shade)) = self.known.get_mut(place).zip(self.shades.get_mut(place))
                {
                    act(known, shade, (column as i64, row as i64));
                }
            }
        }
    }

    /// Forgets the pixels of a disc, which a body covers.
    pub(crate) fn hide(&mut self, disc: Around) {
        self.within(disc, |known, _, _| *known = false);
    }

    /// Sets the pixels of a disc to their temporal median in some frames.
    pub(crate) fn reveal(&mut self, planes: &[&Plane], disc: Around) {
        self.within(disc, |known, shade, (column, row)| (*known, *shade) = (true, usual(planes, column, row)));
    }

    /// Updates the background from a frame, except the discs of bodies. `uncovered`: disc in which pixels may have
    /// become visible.
    pub(crate) fn learn(&mut self, plane: &Plane, bodies: &[Option<Around>], uncovered: Around) {
        let outside = |column: i64, row: i64| {
            bodies.iter().flatten().all(|([x, y], radius)| {
                let (u, v) = (column as f64 + 0.5 - x, row as f64 + 0.5 - y);
                u * u + v * v > radius * radius
            })
        };
        self.within(uncovered, |known, shade, (column, row)| {
            if !*known && outside(column, row) {
                (*known, *shade) = (true, plane.shade(column, row));
            }
        });
        let turn = self.frames % TURN;
        self.frames += 1;
        let width = self.width.max(1);
        let rows = self.shades.chunks_mut(width).zip(self.known.chunks_mut(width)).enumerate().skip(turn).step_by(TURN);
        for (row, (shades, known)) in rows {
            for ((shade, known), column) in shades.iter_mut().zip(known).zip(0_i64..) {
                if !outside(column, row as i64) {
                    continue;
                }
                let now = plane.shade(column, row as i64);
                for (old, new) in shade.iter_mut().zip(now) {
                    let step = i32::from(new) - i32::from(*old);
                    *old = if *known { (i32::from(*old) + step / PACE) as u8 } else { new };
                }
                *known = true;
            }
        }
    }

    fn at(&self, column: i64, row: i64) -> Option<[u8; 3]> {
        let column = usize::try_from(column).ok().filter(|column| *column < self.width)?;
        let place = usize::try_from(row).ok()? * self.width + column;
        self.known.get(place).filter(|known| **known).and_then(|_| self.shades.get(place)).copied()
    }

    /// Estimates brightness and noise of a frame relative to the background.
    pub(crate) fn compare<'a>(&'a self, plane: &'a Plane) -> Compared<'a> {
        let step = (self.shades.len() / COMPARED).max(1) | 1;
        let width = self.width.max(1);
        let places = (0..self.shades.len()).step_by(step).map(|place| (place, place % width, place / width));
        let steps: Vec<[i16; 3]> = places
            .filter_map(|(place, column, row)| {
                let now = plane.shade(column as i64, row as i64);
                let shade = self.shades.get(place)?;
                Some([0, 1, 2].map(|k| i16::from(now[k]) - i16::from(shade[k])))
            })
            .collect();
        let [brighter, ..] = median_shade(&steps, i16::cmp);
        let deviations: Vec<[i16; 3]> =
            steps.iter().map(|[grey, blue, red]| [(grey - brighter).abs(), blue.abs(), red.abs()]).collect();
        // 0.6745 converts the median absolute deviation of a normal distribution to its standard deviation.
        let [grey, blue, red] = median_shade(&deviations, i16::cmp).map(|deviation| f32::from(deviation) / 0.6745);
        let dull = dull([blue, red]);
        Compared { plane, background: self, brighter: f32::from(brighter), noise: grey.max(LEAST), dull }
    }
}

impl Compared<'_> {
    /// True if a place lies in the picture.
    pub(crate) fn holds(&self, [x, y]: [f64; 2]) -> bool {
        (0.0..self.plane.width() as f64).contains(&x) && (0.0..self.plane.height() as f64).contains(&y)
    }

    /// Shade of a pixel at the brightness of the background.
    pub(crate) fn shade(&self, column: i64, row: i64) -> [f32; 3] {
        let [grey, blue, red] = self.plane.shade(column, row).map(f32::from);
        [grey - self.brighter, blue, red]
    }

    /// Squared distance of a shade from the background; `None` if the background is unknown there.
    pub(crate) fn still(&self, shade: [f32; 3], column: i64, row: i64) -> Option<f32> {
        Some(self.distance(shade, self.background.at(column, row)?.map(f32::from)))
    }

    /// Difference of a pixel from the background, 0 to 1; 0 in a shadow.
    pub(crate) fn differs(&self, column: i64, row: i64) -> f32 {
        let shade = self.shade(column, row);
        let Some(lit) = self.background.at(column, row).map(|shade| shade.map(f32::from)) else { return 0.0 };
        let light = (shade[0] - BLACK) / (lit[0] - BLACK).max(1.0);
        let colours = [1, 2].map(|k| shade[k] - 128.0 - light * (lit[k] - 128.0));
        let is_shaded = SHADED.0.contains(&light) && colours.iter().all(|colour| colour.abs() < SHADED.1);
        let far = self.distance(shade, lit);
        if is_shaded { 0.0 } else { far / (far + 16.0 * self.noise * self.noise) }
    }

    /// Squared distance of two shades, without what noise adds to that of their colours.
    pub(crate) fn distance(&self, one: [f32; 3], other: [f32; 3]) -> f32 {
        distance(one, other, self.dull)
    }
}

/// At most so many of some frames, the first and the last among them.
pub(crate) fn few<'a>(planes: &[&'a Plane], most: usize) -> Vec<&'a Plane> {
    let count = planes.len().min(most);
    let last = planes.len().saturating_sub(1);
    (0..count).filter_map(|at| planes.get(at * last / (count - 1).max(1)).copied()).collect()
}

/// Temporal median of each component of a pixel.
pub(crate) fn usual(planes: &[&Plane], column: i64, row: i64) -> [u8; 3] {
    let shades: Vec<[u8; 3]> = planes.iter().map(|plane| plane.shade(column, row)).collect();
    median_shade(&shades, u8::cmp)
}

/// Squared distance of colours with noise of these standard deviations below which they are not distinguished; it exceeds 95 % of those by
/// noise alone.
pub(crate) fn dull([blue, red]: [f32; 2]) -> f32 {
    6.0 * (blue * blue + red * red)
}

/// Squared distance of two shades. Colour differences have twice the weight: they and their noise are smaller than
/// those of grey values. `dull` is taken from that of the colours, so that the noise of colours does not hide a difference of grey values.
pub(crate) fn distance(one: [f32; 3], other: [f32; 3], dull: f32) -> f32 {
    let [grey, blue, red] = [one[0] - other[0], one[1] - other[1], one[2] - other[2]];
    grey * grey + (2.0 * (blue * blue + red * red) - dull).max(0.0)
}
