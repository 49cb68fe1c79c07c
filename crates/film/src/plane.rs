//! A frame as grey values, perhaps with colours.

/// The grey values of one frame, or of a part of it, row by row from the top. Coordinates count pixels: `x` to the right, `y`
/// downwards, and the middle of the first pixel is at (0.5, 0.5).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Plane {
    width: usize,
    height: usize,
    grey: Vec<u8>,
    colour: Option<Colour>,
}

/// Colour differences, one of each for a block of two times two pixels; 128 is grey.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Colour {
    /// Blue less grey (Cb of Rec. ITU-R BT.601), row by row from the top.
    pub blue: Vec<u8>,
    /// Red less grey (Cr).
    pub red: Vec<u8>,
}

impl Plane {
    /// The picture of `width` times `height` pixels; `None` if it has no pixels or `grey` does not hold exactly one value for
    /// each of them.
    pub fn new(width: usize, height: usize, grey: Vec<u8>) -> Option<Plane> {
        let whole = width.checked_mul(height) == Some(grey.len()) && !grey.is_empty();
        whole.then_some(Plane { width, height, grey, colour: None })
    }

    /// The picture of pixels with red, green and blue, row by row; `None` as for [`Plane::new`].
    pub fn of_rgb(width: usize, height: usize, pixels: &[[u8; 3]]) -> Option<Plane> {
        let plane = Plane::new(width, height, pixels.iter().copied().map(luma).collect())?;
        // One pixel of each block: means would cost more than they show.
        let rows = pixels.chunks(width).step_by(2);
        let (blue, red) = rows.flat_map(|row| row.iter().step_by(2)).copied().map(chroma).unzip();
        plane.coloured(Colour { blue, red })
    }

    /// The picture with colours; `None` if they are not one for each block of two times two pixels.
    pub fn coloured(self, colour: Colour) -> Option<Plane> {
        let count = self.width.div_ceil(2) * self.height.div_ceil(2);
        let fits = colour.blue.len() == count && colour.red.len() == count;
        fits.then_some(Plane { colour: Some(colour), ..self })
    }

    /// The picture without colours.
    pub fn uncoloured(self) -> Plane {
        Plane { colour: None, ..self }
    }

    /// The colours.
    pub fn colour(&self) -> Option<&Colour> {
        self.colour.as_ref()
    }

    /// Grey value and both colour differences of a pixel, as for [`Plane::pixel`]; 128 without colours.
    pub(crate) fn shade(&self, column: i64, row: i64) -> [u8; 3] {
        let Some(colour) = &self.colour else { return [self.pixel(column, row), 128, 128] };
        let within = |at: i64, size: usize| usize::try_from(at).unwrap_or(0).min(size.saturating_sub(1));
        let (column, row) = (within(column, self.width), within(row, self.height));
        let place = row / 2 * self.width.div_ceil(2) + column / 2;
        let value = |values: &[u8], place: usize| values.get(place).copied().unwrap_or(128);
        [value(&self.grey, row * self.width + column), value(&colour.blue, place), value(&colour.red, place)]
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

    /// The grey values of the part whose first pixel is (`column`, `row`), `width` times `height` pixels large; what lies beyond
    /// the picture is cut off. `None` if nothing remains.
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

/// The grey value of red, green and blue (Rec. ITU-R BT.601, 2.5.1), in 256ths.
fn luma([red, green, blue]: [u8; 3]) -> u8 {
    ((77 * u32::from(red) + 150 * u32::from(green) + 29 * u32::from(blue) + 128) >> 8) as u8
}

/// The colour differences of red, green and blue (Rec. ITU-R BT.601, 2.5.3), in 256ths.
fn chroma(colour: [u8; 3]) -> (u8, u8) {
    let [red, green, blue] = colour.map(i32::from);
    let shifted = |value: i32| ((value + (128 << 8) + 128) >> 8).clamp(0, 255) as u8;
    (shifted(-43 * red - 85 * green + 128 * blue), shifted(128 * red - 107 * green - 21 * blue))
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
