//! A plane that is seen at an angle.

use crate::calibration::refusal::Refusal;

/// The projective map from pixels to a plane in metres, by the corners of a rectangle in that plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rectangle {
    /// The corners in pixels: bottom left, bottom right, top right, top left.
    pub corners: [[f64; 2]; 4],
    /// Width and height in metres.
    pub size: [f64; 2],
    /// The relative standard error of lengths, from the errors of the clicks.
    pub relative_sigma: f64,
    /// From (x, y, 1) in pixels to homogeneous coordinates of the unit square.
    map: [[f64; 3]; 3],
}

impl Rectangle {
    /// From the corners in pixels (bottom left, bottom right, top right, top left) and width and height in metres; `click` is the standard
    /// error of each coordinate of a click, in pixels.
    ///
    /// P. S. Heckbert, *Fundamentals of Texture Mapping and Image Warping* (Berkeley 1989), section 2.2.3.
    ///
    /// # Errors
    ///
    /// Where the corners form no convex quadrangle in this order, or a length is not positive.
    pub fn new(corners: [[f64; 2]; 4], size: [f64; 2], click: f64) -> Result<Rectangle, Refusal> {
        if !size.iter().all(|length| *length > 0.0 && length.is_finite()) {
            return Err(Refusal::Length);
        }
        let turn = |k: usize| {
            let [a, b, c] = [corners[k], corners[(k + 1) % 4], corners[(k + 2) % 4]];
            (b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0])
        };
        // y grows downwards: this order turns to the left, which is negative there.
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
        // Two sides of each direction, each with two clicks.
        let mean = (0..4).map(side).sum::<f64>() / 4.0;
        Ok(Rectangle { corners, size, relative_sigma: click / mean, map: adjugate(square) })
    }

    /// The point of the plane in metres, to the right and upwards from the bottom left corner, and of infinite coordinates on the horizon.
    pub fn apply(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let [u, v, w] = self.map.map(|row| row[0] * x + row[1] * y + row[2]);
        [self.size[0] * u / w, self.size[1] * v / w]
    }

    /// The point in pixels that is at this place of the plane, in metres.
    pub fn undo(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let [x, y] = [x / self.size[0], y / self.size[1]];
        let [u, v, w] = adjugate(self.map).map(|row| row[0] * x + row[1] * y + row[2]);
        [u / w, v / w]
    }
}

/// The inverse of a matrix, up to a factor.
fn adjugate(m: [[f64; 3]; 3]) -> [[f64; 3]; 3] {
    let minor = |row: usize, column: usize| {
        let (r, s) = ((row + 1) % 3, (row + 2) % 3);
        let (c, d) = ((column + 1) % 3, (column + 2) % 3);
        m[r][c] * m[s][d] - m[r][d] * m[s][c]
    };
    [0, 1, 2].map(|row| [0, 1, 2].map(|column| minor(column, row)))
}
