//! Part of a frame.

use crate::plane::Plane;

/// Margin around a template in px: steps of the alignment and support of the interpolation.
pub(crate) const MARGIN: f64 = 5.0;

/// Part of a frame whose first pixel is at `corner`, px.
#[derive(Clone, Debug)]
pub(crate) struct Part {
    pub plane: Plane,
    pub corner: [f64; 2],
}

/// Direction in the space of shades along which a body differs most from its surroundings.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Axis {
    middle: [f32; 3],
    along: [f32; 3],
}

/// Minimum ratio of colour to grey differences for the use of colours, which have half the resolution.
const COLOURED: f32 = 2.0;
/// Maximum gain of a difference of shades.
const ENLARGED: f32 = 3.0;

impl Axis {
    /// Direction between two shades; `None` if grey values suffice.
    pub(crate) fn between(body: [f32; 3], around: [f32; 3]) -> Option<Axis> {
        let apart = [0, 1, 2].map(|k| body[k] - around[k]);
        let colour = (apart[1] * apart[1] + apart[2] * apart[2]).sqrt();
        if colour < 8.0 || colour < COLOURED * apart[0].abs() {
            return None;
        }
        let length = (colour * colour + apart[0] * apart[0]).sqrt();
        let scale = (100.0 / length).min(ENLARGED) / length;
        Some(Axis { middle: [0, 1, 2].map(|k| (body[k] + around[k]) / 2.0), along: apart.map(|part| scale * part) })
    }

    fn value(&self, shade: [u8; 3]) -> u8 {
        let parts = shade.iter().zip(self.middle).zip(self.along);
        let value: f32 = parts.map(|((shade, middle), along)| (f32::from(*shade) - middle) * along).sum();
        (128.0 + value).round() as u8
    }
}

impl Part {
    /// Part of a frame within `reach` px of a point, as grey values or projected on an axis; `None` outside the
    /// picture.
    pub(crate) fn around(plane: &Plane, [x, y]: [f64; 2], reach: f64, axis: Option<&Axis>) -> Option<Part> {
        let (left, top) = ((x - reach).floor().max(0.0), (y - reach).floor().max(0.0));
        let size = |at: f64, first: f64| ((at + reach).ceil() - first).max(0.0) as usize;
        let (left, top, width, height) = (left as usize, top as usize, size(x, left), size(y, top));
        let mut part = plane.crop(left, top, width, height)?;
        if let Some(axis) = axis {
            let rows = (top as i64..).take(part.height());
            let places = rows.flat_map(|row| (left as i64..).take(part.width()).map(move |column| (column, row)));
            let values = places.map(|(column, row)| axis.value(plane.shade(column, row))).collect();
            part = Plane::new(part.width(), part.height(), values)?;
        }
        Some(Part { plane: part, corner: [left as f64, top as f64] })
    }

    /// Values at whole offsets of at most `reach` px from a point along each coordinate, row by row, all displaced by the same vector (px).
    fn displaced(&self, [x, y]: [f64; 2], reach: i64, [right, down]: [f64; 2]) -> Vec<f64> {
        let line = |at: f64, by: f64, corner: f64| -> Vec<f64> {
            (-reach..=reach).map(|offset| at + offset as f64 + by - corner).collect()
        };
        self.plane.cubic(&line(x, right, self.corner[0]), &line(y, down, self.corner[1]))
    }

    /// Values at whole offsets of at most `reach` px from a point along each coordinate, row by row.
    pub(crate) fn values(&self, point: [f64; 2], reach: i64) -> Vec<f64> {
        self.displaced(point, reach, [0.0; 2])
    }

    /// Values at the same places, with their derivatives to the right and downwards, per px.
    pub(crate) fn jets(&self, point: [f64; 2], reach: i64) -> Vec<(f64, [f64; 2])> {
        let at = |right: f64, down: f64| self.displaced(point, reach, [right, down]);
        let (right, left, below, above) = (at(0.5, 0.0), at(-0.5, 0.0), at(0.0, 0.5), at(0.0, -0.5));
        let across = right.iter().zip(left).map(|(right, left)| right - left);
        let down = below.iter().zip(above).map(|(below, above)| below - above);
        self.values(point, reach)
            .into_iter()
            .zip(across.zip(down))
            .map(|(value, (across, down))| (value, [across, down]))
            .collect()
    }
}
