//! A frame as grey values.

/// The grey values of one frame, or of a part of it, row by row from the top. Coordinates count pixels: `x` to the right, `y`
/// downwards, and the middle of the first pixel is at (0.5, 0.5).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Plane {
    width: usize,
    height: usize,
    grey: Vec<u8>,
}

impl Plane {
    /// The picture of `width` times `height` pixels; `None` if it has no pixels or `grey` does not hold exactly one value for
    /// each of them.
    pub fn new(width: usize, height: usize, grey: Vec<u8>) -> Option<Plane> {
        let whole = width.checked_mul(height) == Some(grey.len()) && !grey.is_empty();
        whole.then_some(Plane { width, height, grey })
    }

    /// Pixels in a row.
    pub fn width(&self) -> usize {
        self.width
    }

    /// Rows.
    pub fn height(&self) -> usize {
        self.height
    }

    /// The values, row by row from the top.
    pub fn grey(&self) -> &[u8] {
        &self.grey
    }

    /// The value of a pixel; beyond the edge that of the nearest pixel.
    pub fn pixel(&self, column: i64, row: i64) -> u8 {
        let within = |at: i64, size: usize| usize::try_from(at).unwrap_or(0).min(size.saturating_sub(1));
        self.grey.get(within(row, self.height) * self.width + within(column, self.width)).copied().unwrap_or(0)
    }

    /// The part whose first pixel is (`column`, `row`), `width` times `height` pixels large; what lies beyond the picture is cut
    /// off. `None` if nothing remains.
    pub fn crop(&self, column: usize, row: usize, width: usize, height: usize) -> Option<Plane> {
        let right = column.saturating_add(width).min(self.width);
        let bottom = row.saturating_add(height).min(self.height);
        let width = right.checked_sub(column)?;
        let mut grey = Vec::with_capacity(width * bottom.saturating_sub(row));
        for line in row..bottom {
            grey.extend_from_slice(self.grey.get(line * self.width + column..line * self.width + right)?);
        }
        Plane::new(width, bottom.checked_sub(row)?, grey)
    }

    /// The value at a point, linear between the middles of the pixels.
    pub fn linear(&self, x: f64, y: f64) -> f64 {
        let (column, right) = parts(x);
        let (row, below) = parts(y);
        let mix = |pair: [u8; 2]| (1.0 - right) * f64::from(pair[0]) + right * f64::from(pair[1]);
        let above = mix(self.block::<2, 1>(column, row)[0]);
        // The row in the middle of its pixels needs no other: the usual case of an upright tube.
        if below == 0.0 { above } else { (1.0 - below) * above + below * mix(self.block::<2, 1>(column, row + 1)[0]) }
    }

    /// The value at a point by cubic convolution over the sixteen pixels around it.
    ///
    /// R. G. Keys, *IEEE Trans. Acoust. Speech Signal Process.* 29 (1981) 1153, with a = -1/2.
    pub fn cubic(&self, x: f64, y: f64) -> f64 {
        let (column, right) = parts(x);
        let (row, below) = parts(y);
        let (across, down) = (keys(right), keys(below));
        let block: [[u8; 4]; 4] = self.block(column - 1, row - 1);
        let mut value = 0.0;
        for (line, weight) in block.iter().zip(down) {
            let [a, b, c, d] = line.map(f64::from);
            value += weight * (across[0] * a + across[1] * b + across[2] * c + across[3] * d);
        }
        value
    }

    /// The pixels from (`column`, `row`) on.
    fn block<const WIDE: usize, const HIGH: usize>(&self, column: i64, row: i64) -> [[u8; WIDE]; HIGH] {
        let mut block = [[0; WIDE]; HIGH];
        let inside = column >= 0 && column as usize + WIDE <= self.width;
        for (line, at) in block.iter_mut().zip(row..) {
            let place = usize::try_from(at).ok().filter(|row| inside && *row < self.height);
            let pixels =
                place.and_then(|row| self.grey.get(row * self.width + column as usize..)?.first_chunk::<WIDE>());
            match pixels {
                Some(pixels) => *line = *pixels,
                None => line.iter_mut().zip(column..).for_each(|(value, column)| *value = self.pixel(column, at)),
            }
        }
        block
    }
}

/// The pixel whose middle lies before a coordinate, and the fraction of the way to the next one.
fn parts(at: f64) -> (i64, f64) {
    // Far beyond any picture, where a conversion is still exact.
    let at = (at - 0.5).clamp(-1e9, 1e9);
    // Towards zero, and so down from the left edge on; faster than rounding down.
    let whole = at as i64 - i64::from(at < 0.0);
    (whole, if at.is_nan() { 0.0 } else { at - whole as f64 })
}

/// Weights of the four values around a fraction.
fn keys(f: f64) -> [f64; 4] {
    [
        ((2.0 - f) * f - 1.0) * f / 2.0,
        ((3.0 * f - 5.0) * f * f + 2.0) / 2.0,
        (((4.0 - 3.0 * f) * f) + 1.0) * f / 2.0,
        (f - 1.0) * f * f / 2.0,
    ]
}
