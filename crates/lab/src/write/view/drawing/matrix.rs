//! Affine maps of the plane between the picture and its elements.

use web_sys::SvgMatrix;

/// Affine map `x' = a x + c y + e`, `y' = b x + d y + f`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Matrix {
    a: f64,
    b: f64,
    c: f64,
    d: f64,
    e: f64,
    f: f64,
}

impl Matrix {
    /// Converts a matrix of the browser.
    pub fn of(matrix: &SvgMatrix) -> Self {
        let [a, b, c] = [matrix.a(), matrix.b(), matrix.c()].map(f64::from);
        let [d, e, f] = [matrix.d(), matrix.e(), matrix.f()].map(f64::from);
        Self { a, b, c, d, e, f }
    }

    /// Image of a point.
    pub fn point(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let [right, down] = self.way([x, y]);
        [right + self.e, down + self.f]
    }

    /// Image of a displacement.
    pub fn way(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [self.a * x + self.c * y, self.b * x + self.d * y]
    }

    /// Geometric mean of the length scales: square root of the absolute determinant.
    pub fn scale(&self) -> f64 {
        (self.a * self.d - self.b * self.c).abs().sqrt()
    }

    /// Composition: this map applied after `first`.
    pub fn after(&self, first: &Self) -> Self {
        let [a, b] = self.way([first.a, first.b]);
        let [c, d] = self.way([first.c, first.d]);
        let [e, f] = self.point([first.e, first.f]);
        Self { a, b, c, d, e, f }
    }

    /// Inverse map; `None` if the map is singular.
    pub fn inverse(&self) -> Option<Self> {
        let area = self.a * self.d - self.b * self.c;
        if area == 0.0 || !area.is_finite() {
            return None;
        }
        let (a, b, c, d) = (self.d / area, -self.b / area, -self.c / area, self.a / area);
        let (e, f) = (-(a * self.e + c * self.f), -(b * self.e + d * self.f));
        Some(Self { a, b, c, d, e, f })
    }
}
