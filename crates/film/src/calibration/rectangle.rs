//! Calibration by a plane that is seen at an angle.

use crate::calibration::refusal::Refusal;

/// Projective map from px to m in a plane, by the corners of a rectangle in that plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rectangle {
    /// Corners in px: bottom left, bottom right, top right, top left.
    pub corners: [[f64; 2]; 4],
    /// Width and height, m.
    pub size: [f64; 2],
    /// Relative standard error of lengths, from the errors of the clicks.
    pub relative_sigma: f64,
    /// Maps (x, y, 1) in px to homogeneous coordinates of the unit square.
    map: [[f64; 3]; 3],
}

impl Rectangle {
    /// Map by `corners` in px (bottom left, bottom right, top right, top left) and `size` (width, height) in m.
    /// `click`: standard error of each coordinate of a click, px.
    ///
    /// Heckbert, *Fundamentals of Texture Mapping and Image Warping* (Berkeley 1989), section 2.2.3.
    ///
    /// # Errors
    ///
    /// [`Refusal::Length`] for a size that is not positive, [`Refusal::Corners`] if the corners are not a convex
    /// quadrangle in this order.
    pub fn new(corners: [[f64; 2]; 4], size: [f64; 2], click: f64) -> Result<Rectangle, Refusal> {
        if !size.iter().all(|length| *length > 0.0 && length.is_finite()) {
            return Err(Refusal::Length);
        }
        let turn = |k: usize| {
            let [a, b, c] = [corners[k], corners[(k + 1) % 4], corners[(k + 2) % 4]];
            (b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0])
        };
        // With `y` downwards, a turn to the left is negative.
        if !(0..4).all(|k| turn(k) < -25.0 && turn(k).is_finite()) {
            return Err(Refusal::Corners);
        }
        let [p, q, r, s] = corners;
        let sum = [p[0] - q[0] + r[0] - s[0], p[1] - q[1] + r[1] - s[1]];
        let (one, two) = ([q[0] - r[0], q[1] - r[1]], [s[0] - r[0], s[1] - r[1]]);
        let below = one[0] * two[1] - two[0] * one[1];
        let g = (sum[0] * two[1] - two[0] * sum[1]) / below;
        let h = (one[0] * sum[1] - sum[0] * one[1]) / below;
        let square = [
            [q[0] - p[0] + g * q[0], s[0] - p[0] + h * s[0], p[0]],
            [q[1] - p[1] + g * q[1], s[1] - p[1] + h * s[1], p[1]],
            [g, h, 1.0],
        ];
        let side = |k: usize| {
            let (a, b) = (corners[k], corners[(k + 1) % 4]);
            libm::hypot(b[0] - a[0], b[1] - a[1])
        };
        // Two sides per direction, each with two clicks.
        let mean = (0..4).map(side).sum::<f64>() / 4.0;
        Ok(Rectangle { corners, size, relative_sigma: click / mean, map: adjugate(square) })
    }

    /// Point of the plane in m from the bottom left corner, to the right and up. Infinite on the horizon.
    pub fn apply(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let [u, v, w] = self.map.map(|row| row[0] * x + row[1] * y + row[2]);
        [self.size[0] * u / w, self.size[1] * v / w]
    }

    /// Point in px of a point of the plane in m. Inverse of [`Rectangle::apply`].
    pub fn undo(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let [x, y] = [x / self.size[0], y / self.size[1]];
        let [u, v, w] = adjugate(self.map).map(|row| row[0] * x + row[1] * y + row[2]);
        [u / w, v / w]
    }
}

/// Inverse of a matrix up to a factor.
fn adjugate(m: [[f64; 3]; 3]) -> [[f64; 3]; 3] {
    let minor = |row: usize, column: usize| {
        let (r, s) = ((row + 1) % 3, (row + 2) % 3);
        let (c, d) = ((column + 1) % 3, (column + 2) % 3);
        m[r][c] * m[s][d] - m[r][d] * m[s][c]
    };
    [0, 1, 2].map(|row| [0, 1, 2].map(|column| minor(column, row)))
}
