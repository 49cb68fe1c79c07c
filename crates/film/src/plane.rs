//! Frame as grey values, optionally with colours.

/// Grey values of a frame or a part of it, row by row from the top. Coordinates in px: `x` to the right, `y` down, the
/// centre of the first pixel at (0.5, 0.5).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Plane {
    width: usize,
    height: usize,
    grey: Vec<u8>,
    colour: Option<Colour>,
}

/// Colour differences, one value per block of 2 × 2 pixels; 128 is neutral.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Colour {
    /// Blue difference (Cb of Rec. ITU-R BT.601), row by row from the top.
    pub blue: Vec<u8>,
    /// Red difference (Cr).
    pub red: Vec<u8>,
}

impl Plane {
    /// Picture of `width` × `height` pixels. `None` if it is empty or `grey` does not have one value per pixel.
    pub fn new(width: usize, height: usize, grey: Vec<u8>) -> Option<Plane> {
        let whole = width.checked_mul(height) == Some(grey.len()) && !grey.is_empty();
        whole.then_some(Plane { width, height, grey, colour: None })
    }

    /// Picture from red, green and blue of each pixel, row by row. `None` as for [`Plane::new`].
    pub fn of_rgb(width: usize, height: usize, pixels: &[[u8; 3]]) -> Option<Plane> {
        let plane = Plane::new(width, height, pixels.iter().copied().map(luma).collect())?;
        // One pixel per block: the mean would cost more time than it improves.
        let rows = pixels.chunks(width).step_by(2);
        let (blue, red) = rows.flat_map(|row| row.iter().step_by(2)).copied().map(chroma).unzip();
        plane.coloured(Colour { blue, red })
    }

    /// Adds colours. `None` unless they have one value per block of 2 × 2 pixels.
    pub fn coloured(self, colour: Colour) -> Option<Plane> {
        let count = self.width.div_ceil(2) * self.height.div_ceil(2);
        let fits = colour.blue.len() == count && colour.red.len() == count;
        fits.then_some(Plane { colour: Some(colour), ..self })
    }

    /// Removes the colours.
    pub fn uncoloured(self) -> Plane {
        Plane { colour: None, ..self }
    }

    /// Colour differences, if any.
    pub fn colour(&self) -> Option<&Colour> {
        self.colour.as_ref()
    }

    /// Grey value and both colour differences of a pixel; 128 without colours. Outside, those of the nearest pixel.
    pub(crate) fn shade(&self, column: i64, row: i64) -> [u8; 3] {
        let Some(colour) = &self.colour else { return [self.pixel(column, row), 128, 128] };
        let within = |at: i64, size: usize| usize::try_from(at).unwrap_or(0).min(size.saturating_sub(1));
        let (column, row) = (within(column, self.width), within(row, self.height));
        let place = row / 2 * self.width.div_ceil(2) + column / 2;
        let value = |values: &[u8], place: usize| values.get(place).copied().unwrap_or(128);
        [value(&self.grey, row * self.width + column), value(&colour.blue, place), value(&colour.red, place)]
    }

    /// Width in px.
    pub fn width(&self) -> usize {
        self.width
    }

    /// Height in px.
    pub fn height(&self) -> usize {
        self.height
    }

    /// Grey values, row by row from the top.
    pub fn grey(&self) -> &[u8] {
        &self.grey
    }

    /// Grey value of a pixel; outside the picture, that of the nearest pixel.
    pub fn pixel(&self, column: i64, row: i64) -> u8 {
        let within = |at: i64, size: usize| usize::try_from(at).unwrap_or(0).min(size.saturating_sub(1));
        self.grey.get(within(row, self.height) * self.width + within(column, self.width)).copied().unwrap_or(0)
    }

    /// Copy of the grey values of `width` × `height` pixels from (`column`, `row`), clipped to the picture. `None` if
    /// it is empty.
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

    /// Grey value at a point (px), by bilinear interpolation between pixel centres.
    pub fn linear(&self, x: f64, y: f64) -> f64 {
        let ((column, right), (row, below)) = (parts(x), parts(y));
        let inside = |at: i64, size: usize| usize::try_from(at).ok().filter(|at| at + 1 < size);
        if let Some((column, row)) = inside(column, self.width).zip(inside(row, self.height)) {
            let pair = |row: usize| self.grey.get(row * self.width + column..)?.first_chunk::<2>();
            if let Some(([a, b], [c, d])) = pair(row).zip(pair(row + 1)) {
                let mixed = |one: &u8, other: &u8| (1.0 - right) * f64::from(*one) + right * f64::from(*other);
                // Exact at the centre line of a row too.
                return (1.0 - below) * mixed(a, b) + below * mixed(c, d);
            }
        }
        let above = self.mixed(row, (column, right));
        // One row suffices at its centre line, the usual case of an upright tube.
        if below == 0.0 { above } else { (1.0 - below) * above + below * self.mixed(row + 1, (column, right)) }
    }

    /// Grey values at all pairs of coordinates to the right and downwards (px), row by row, as [`Plane::linear`].
    pub(crate) fn linear_grid<const SIDE: usize>(&self, across: [f64; SIDE], down: [f64; SIDE]) -> [[f64; SIDE]; SIDE] {
        let columns = across.map(parts);
        down.map(|y| {
            let (row, below) = parts(y);
            columns.map(|column| {
                let above = self.mixed(row, column);
                if below == 0.0 { above } else { (1.0 - below) * above + below * self.mixed(row + 1, column) }
            })
        })
    }

    /// Value between two pixels of a row: the first one, and the fraction of the way to the next.
    fn mixed(&self, row: i64, (column, right): (i64, f64)) -> f64 {
        let pair = usize::try_from(column).ok().and_then(|column| self.row(row).get(column..)?.first_chunk::<2>());
        let pair = pair.copied().unwrap_or_else(|| [self.pixel(column, row), self.pixel(column + 1, row)]);
        (1.0 - right) * f64::from(pair[0]) + right * f64::from(pair[1])
    }

    /// Grey values at all pairs of coordinates to the right and downwards (px), row by row, by cubic convolution over the 16 pixels that are
    /// nearest to each. The coordinates should lie close together: all pixels between them are read.
    ///
    /// Keys, *IEEE Trans. Acoust. Speech Signal Process.* 29 (1981) 1153, with a = -1/2.
    pub fn cubic(&self, across: &[f64], down: &[f64]) -> Vec<f64> {
        let placed = |at: &f64| {
            let (whole, fraction) = parts(*at);
            (whole - 1, keys(fraction))
        };
        let columns: Vec<(i64, [f64; 4])> = across.iter().map(placed).collect();
        let rows: Vec<(i64, [f64; 4])> = down.iter().map(placed).collect();
        let first = rows.iter().map(|row| row.0).min().unwrap_or(0);
        let end = rows.iter().map(|row| row.0 + 4).max().unwrap_or(0);
        let width = columns.len();
        let mut lines = Vec::with_capacity((end - first) as usize * width);
        for row in first..end {
            let line = self.row(row);
            lines.extend(columns.iter().map(|(column, [p, q, r, s])| {
                let pixels = usize::try_from(*column).ok().and_then(|column| line.get(column..)?.first_chunk::<4>());
                let pixels =
                    pixels.copied().unwrap_or_else(|| std::array::from_fn(|k| self.pixel(column + k as i64, row)));
                let [a, b, c, d] = pixels.map(f64::from);
                p * a + q * b + r * c + s * d
            }));
        }
        let mut values = vec![0.0; width * rows.len()];
        for ((row, weights), values) in rows.iter().zip(values.chunks_mut(width.max(1))) {
            let lines = lines[(row - first) as usize * width..].chunks(width.max(1));
            for (line, weight) in lines.zip(weights) {
                values.iter_mut().zip(line).for_each(|(value, across)| *value += weight * across);
            }
        }
        values
    }

    /// Grey values of a row; outside the picture, those of the nearest one.
    fn row(&self, row: i64) -> &[u8] {
        let row = usize::try_from(row).unwrap_or(0).min(self.height.saturating_sub(1));
        self.grey.get(row * self.width..(row + 1) * self.width).unwrap_or_default()
    }
}

/// Luma of red, green and blue (Rec. ITU-R BT.601, 2.5.1), in integer arithmetic with 256ths.
fn luma([red, green, blue]: [u8; 3]) -> u8 {
    ((77 * u32::from(red) + 150 * u32::from(green) + 29 * u32::from(blue) + 128) >> 8) as u8
}

/// Blue and red difference of red, green and blue (Rec. ITU-R BT.601, 2.5.3), in integer arithmetic with 256ths.
fn chroma(colour: [u8; 3]) -> (u8, u8) {
    let [red, green, blue] = colour.map(i32::from);
    let shifted = |value: i32| ((value + (128 << 8) + 128) >> 8).clamp(0, 255) as u8;
    (shifted(-43 * red - 85 * green + 128 * blue), shifted(128 * red - 107 * green - 21 * blue))
}

/// Index of the last pixel whose centre is at or before a coordinate, and the fraction of the way to the next one.
fn parts(at: f64) -> (i64, f64) {
    // Still far outside any picture, and small enough for an exact conversion.
    let at = (at - 0.5).clamp(-1e9, 1e9);
    // Rounds down, faster than `floor`.
    let whole = at as i64 - i64::from(at < 0.0);
    (whole, if at.is_nan() { 0.0 } else { at - whole as f64 })
}

/// Weights of four successive values for interpolation at the fraction `f` between the second and the third.
fn keys(f: f64) -> [f64; 4] {
    [
        ((2.0 - f) * f - 1.0) * f / 2.0,
        ((3.0 * f - 5.0) * f * f + 2.0) / 2.0,
        (((4.0 - 3.0 * f) * f) + 1.0) * f / 2.0,
        (f - 1.0) * f * f / 2.0,
    ]
}
