//! Conversion of pixels to metres.
//!
//! A calibration maps pixels to metres and back: scale, axes, rectangle in perspective, parallax.

mod notes;
mod rectangle;
mod refusal;
mod ruler;
mod scale;

pub use rectangle::Rectangle;
pub use refusal::Refusal;
pub use ruler::by_marks;
pub use scale::{CLICK, Mark, Scale};

/// Definition of lengths.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Lengths {
    /// No scale: coordinates in px.
    #[default]
    Pixels,
    /// Size of a pixel.
    Scale(Scale),
    /// Rectangle in the plane of the motion.
    Rectangle(Rectangle),
}

/// Clockwise rotation from the stored to the upright picture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Rotation {
    /// No rotation.
    #[default]
    None,
    /// 90 degrees.
    Quarter,
    /// 180 degrees.
    Half,
    /// 270 degrees.
    ThreeQuarters,
}

impl Rotation {
    /// Maps a point of the stored picture to the upright one. Coordinates and size (width, height) of the stored
    /// picture in px.
    pub fn apply(self, [x, y]: [f64; 2], [width, height]: [f64; 2]) -> [f64; 2] {
        match self {
            Self::None => [x, y],
            Self::Quarter => [height - y, x],
            Self::Half => [width - x, height - y],
            Self::ThreeQuarters => [y, width - x],
        }
    }

    /// Maps a point of the upright picture to the stored one. Inverse of [`Rotation::apply`], with the same size.
    pub fn undo(self, [x, y]: [f64; 2], [width, height]: [f64; 2]) -> [f64; 2] {
        match self {
            Self::None => [x, y],
            Self::Quarter => [y, height - x],
            Self::Half => [width - x, height - y],
            Self::ThreeQuarters => [width - y, x],
        }
    }

    /// Maps a direction of the stored picture to the upright one.
    fn turn(self, direction: [f64; 2]) -> [f64; 2] {
        self.apply(direction, [0.0, 0.0])
    }

    /// Maps a direction of the upright picture to the stored one.
    fn turn_back(self, direction: [f64; 2]) -> [f64; 2] {
        self.undo(direction, [0.0, 0.0])
    }
}

/// Correction for a ruler that is nearer or further away than the motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parallax {
    /// Distance of the ruler behind the motion, m; negative in front of it.
    pub behind: f64,
    /// Distance from the camera to the motion, m.
    pub distance: f64,
}

impl Parallax {
    /// Ratio of a true length to the length by the ruler.
    pub fn factor(self) -> f64 {
        self.distance / (self.distance + self.behind)
    }
}

/// Map from px of the stored picture to m. In the upright picture `x` points to the right and `y` up.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Calibration {
    /// Definition of lengths.
    pub lengths: Lengths,
    /// Origin of the coordinates, px of the stored picture.
    pub origin: [f64; 2],
    /// Counter-clockwise rotation of the axes, rad.
    pub angle: f64,
    /// Rotation to the upright picture. Ignored for a rectangle, whose corners define the directions.
    pub rotation: Rotation,
    /// Place of the ruler, if it is not in the plane of the motion.
    pub parallax: Option<Parallax>,
}

impl Calibration {
    /// Coordinates of a point of the stored picture (px), in m, or in px without a scale.
    pub fn apply(&self, point: [f64; 2]) -> [f64; 2] {
        let factor = self.parallax.map_or(1.0, Parallax::factor);
        let [x, y] = match &self.lengths {
            Lengths::Pixels => self.upwards(point, 1.0),
            Lengths::Scale(scale) => self.upwards(point, scale.pixel * factor),
            Lengths::Rectangle(rectangle) => {
                let (at, zero) = (rectangle.apply(point), rectangle.apply(self.origin));
                [(at[0] - zero[0]) * factor, (at[1] - zero[1]) * factor]
            }
        };
        let (sine, cosine) = libm::sincos(self.angle);
        [cosine * x + sine * y, cosine * y - sine * x]
    }

    fn upwards(&self, point: [f64; 2], pixel: f64) -> [f64; 2] {
        let [x, y] = self.rotation.turn([point[0] - self.origin[0], point[1] - self.origin[1]]);
        [pixel * x, -pixel * y]
    }

    /// Point of the stored picture (px) with these coordinates. Inverse of [`Calibration::apply`]. Not finite if there
    /// is no such point.
    pub fn undo(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let (sine, cosine) = libm::sincos(self.angle);
        let factor = self.parallax.map_or(1.0, Parallax::factor);
        let [x, y] = [(cosine * x - sine * y) / factor, (sine * x + cosine * y) / factor];
        let downwards = |pixel: f64| {
            let [u, v] = self.rotation.turn_back([x / pixel, -y / pixel]);
            [self.origin[0] + u, self.origin[1] + v]
        };
        match &self.lengths {
            // Without a scale the place of the ruler has no effect.
            Lengths::Pixels => downwards(1.0 / factor),
            Lengths::Scale(scale) => downwards(scale.pixel),
            Lengths::Rectangle(rectangle) => {
                let zero = rectangle.apply(self.origin);
                rectangle.undo([zero[0] + x, zero[1] + y])
            }
        }
    }

    /// Standard errors of the coordinates, in m or px, from those of `point` in px. The error of the scale is not
    /// included.
    pub fn sigma(&self, point: [f64; 2], sigma: [f64; 2]) -> [f64; 2] {
        // The map is practically linear over a standard error, so that a central difference gives the slope.
        let slope = |step: [f64; 2]| {
            let (a, b) = (
                self.apply([point[0] - step[0], point[1] - step[1]]),
                self.apply([point[0] + step[0], point[1] + step[1]]),
            );
            [(b[0] - a[0]) / 2.0, (b[1] - a[1]) / 2.0]
        };
        let (across, down) = (slope([sigma[0], 0.0]), slope([0.0, sigma[1]]));
        [0, 1].map(|k| libm::hypot(across[k], down[k]))
    }

    /// Unit vector, in these coordinates, in which the level rises in a tube of this direction (px): up, or to the
    /// right in a horizontal tube. Also the length of a pixel along it, m or px.
    pub fn upwards_along(&self, direction: [f64; 2]) -> ([f64; 2], f64) {
        let zero = self.apply(self.origin);
        let end = self.apply([0, 1].map(|k| self.origin[k] + direction[k]));
        let axis = [end[0] - zero[0], end[1] - zero[1]];
        let pixel = libm::hypot(axis[0], axis[1]);
        let sense = if (axis[1], axis[0]) < (0.0, 0.0) { -1.0 } else { 1.0 };
        (axis.map(|part| sense * part / pixel), pixel)
    }

    /// Relative standard error of the scale, shared by all lengths; `None` without a scale.
    pub fn relative_sigma(&self) -> Option<f64> {
        match &self.lengths {
            Lengths::Pixels => None,
            Lengths::Scale(scale) => Some(scale.relative_sigma),
            Lengths::Rectangle(rectangle) => Some(rectangle.relative_sigma),
        }
    }
}
