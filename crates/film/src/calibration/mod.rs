//! From pixels to metres.

mod notes;
mod rectangle;
mod refusal;
mod ruler;
mod scale;

pub use rectangle::Rectangle;
pub use refusal::Refusal;
pub use ruler::by_marks;
pub use scale::{CLICK, Mark, Scale};

/// How lengths are found.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Lengths {
    /// They are not: coordinates stay in pixels.
    #[default]
    Pixels,
    /// By the size of a pixel.
    Scale(Scale),
    /// By a rectangle in the plane of the motion.
    Rectangle(Rectangle),
}

/// By how many quarter turns to the right a film must be turned to be seen upright.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Rotation {
    /// It is upright.
    #[default]
    None,
    /// By 90 degrees.
    Quarter,
    /// By 180 degrees.
    Half,
    /// By 270 degrees.
    ThreeQuarters,
}

impl Rotation {
    /// Where a point of the stored picture, `size` pixels large, is in the upright one.
    pub fn apply(self, [x, y]: [f64; 2], [width, height]: [f64; 2]) -> [f64; 2] {
        match self {
            Self::None => [x, y],
            Self::Quarter => [height - y, x],
            Self::Half => [width - x, height - y],
            Self::ThreeQuarters => [y, width - x],
        }
    }

    /// Where a point of the upright picture is in the stored one, which is `size` pixels large.
    pub fn undo(self, [x, y]: [f64; 2], [width, height]: [f64; 2]) -> [f64; 2] {
        match self {
            Self::None => [x, y],
            Self::Quarter => [y, height - x],
            Self::Half => [width - x, height - y],
            Self::ThreeQuarters => [width - y, x],
        }
    }

    /// A direction of the stored picture, in the upright one.
    fn turn(self, direction: [f64; 2]) -> [f64; 2] {
        self.apply(direction, [0.0, 0.0])
    }

    /// A direction of the upright picture, in the stored one.
    fn turn_back(self, direction: [f64; 2]) -> [f64; 2] {
        self.undo(direction, [0.0, 0.0])
    }
}

/// A ruler that is not where the motion is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parallax {
    /// By how many metres the ruler is behind what moves; negative in front of it.
    pub behind: f64,
    /// The distance in metres from the camera to what moves.
    pub distance: f64,
}

impl Parallax {
    /// The true length for each metre that the ruler shows.
    pub fn factor(self) -> f64 {
        self.distance / (self.distance + self.behind)
    }
}

/// The map from pixels of the stored picture to metres, `x` to the right and `y` upwards as the film is seen upright.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Calibration {
    /// How lengths are found.
    pub lengths: Lengths,
    /// The point that becomes zero, in pixels of the stored picture.
    pub origin: [f64; 2],
    /// By which angle in radians the axes are turned to the left.
    pub angle: f64,
    /// How the film must be turned to be upright. A rectangle says itself what is up: its corners are named so.
    pub rotation: Rotation,
    /// The place of the ruler, if it is not that of the motion.
    pub parallax: Option<Parallax>,
}

impl Calibration {
    /// The coordinates of a point, in metres, or in pixels without a scale.
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

    /// The point in pixels of the stored picture that has these coordinates; it is not finite where no point has them.
    pub fn undo(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let (sine, cosine) = libm::sincos(self.angle);
        let factor = self.parallax.map_or(1.0, Parallax::factor);
        let [x, y] = [(cosine * x - sine * y) / factor, (sine * x + cosine * y) / factor];
        let downwards = |pixel: f64| {
            let [u, v] = self.rotation.turn_back([x / pixel, -y / pixel]);
            [self.origin[0] + u, self.origin[1] + v]
        };
        match &self.lengths {
            // Without a scale nothing is corrected for the place of the ruler.
            Lengths::Pixels => downwards(1.0 / factor),
            Lengths::Scale(scale) => downwards(scale.pixel),
            Lengths::Rectangle(rectangle) => {
                let zero = rectangle.apply(self.origin);
                rectangle.undo([zero[0] + x, zero[1] + y])
            }
        }
    }

    /// The standard errors of the coordinates of a point with such errors in pixels, without that of the scale.
    pub fn sigma(&self, point: [f64; 2], sigma: [f64; 2]) -> [f64; 2] {
        // The map is as good as linear over an error: a small difference shows its slope.
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

    /// The direction in which the level in a tube grows, of length 1 in these coordinates, for a tube with this direction in pixels:
    /// from its lower end to the upper one, or to the right. And how long a pixel along it is.
    pub fn upwards_along(&self, direction: [f64; 2]) -> ([f64; 2], f64) {
        let zero = self.apply(self.origin);
        let end = self.apply([0, 1].map(|k| self.origin[k] + direction[k]));
        let axis = [end[0] - zero[0], end[1] - zero[1]];
        let pixel = libm::hypot(axis[0], axis[1]);
        let sense = if (axis[1], axis[0]) < (0.0, 0.0) { -1.0 } else { 1.0 };
        (axis.map(|part| sense * part / pixel), pixel)
    }

    /// The relative standard error that all lengths share; `None` without a scale.
    pub fn relative_sigma(&self) -> Option<f64> {
        match &self.lengths {
            Lengths::Pixels => None,
            Lengths::Scale(scale) => Some(scale.relative_sigma),
            Lengths::Rectangle(rectangle) => Some(rectangle.relative_sigma),
        }
    }
}
