//! Conversion of pixels of a project to lengths.

/// Axes and scale, which may change from frame to frame.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Coordinates {
    /// Stated placements, by ascending frames; each holds until the next one.
    pub placements: Vec<Placement>,
    /// True if the origin of the last placement holds in all frames.
    pub fixed_origin: bool,
    /// True if the angle of the last placement holds in all frames.
    pub fixed_angle: bool,
    /// True if the scale of the last placement holds in all frames.
    pub fixed_scale: bool,
}

/// Axes and scale from a frame on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placement {
    /// First frame for which they hold.
    pub frame: u32,
    /// Origin in pixels, to the right and down from the top left corner of the picture.
    pub origin: [f64; 2],
    /// Angle of the x axis, degrees counterclockwise from the horizontal.
    pub angle: f64,
    /// Scale along the rows and the columns of the picture, pixels per unit of length.
    pub scale: [f64; 2],
}

impl Default for Placement {
    fn default() -> Self {
        Self { frame: 0, origin: [0.0; 2], angle: 0.0, scale: [1.0; 2] }
    }
}

impl Placement {
    /// True if lengths can be computed with it.
    pub(super) fn is_usable(&self) -> bool {
        let finite = self.origin.iter().chain([&self.angle]).all(|number| number.is_finite());
        finite && self.scale.iter().all(|scale| scale.is_normal())
    }

    /// Position of a pixel in units of length: the inverse of `ImageCoordSystem.updateTransforms`. x and y are
    /// perpendicular; y is upwards if x is to the right.
    pub fn world(&self, pixel: [f64; 2]) -> [f64; 2] {
        let right = (pixel[0] - self.origin[0]) / self.scale[0];
        let up = (self.origin[1] - pixel[1]) / self.scale[1];
        if self.angle == 0.0 {
            return [right, up];
        }
        let (sine, cosine) = libm::sincos(self.angle.to_radians());
        [cosine * right + sine * up, cosine * up - sine * right]
    }
}

impl Coordinates {
    /// Axes and scale in a frame.
    pub fn at(&self, frame: u32) -> Placement {
        let behind = self.placements.partition_point(|placement| placement.frame <= frame);
        let here = self.placements.get(behind.saturating_sub(1)).copied().unwrap_or_default();
        let last = self.placements.last().copied().unwrap_or_default();
        Placement {
            frame: here.frame,
            origin: if self.fixed_origin { last.origin } else { here.origin },
            angle: if self.fixed_angle { last.angle } else { here.angle },
            scale: if self.fixed_scale { last.scale } else { here.scale },
        }
    }

    /// True if a scale is stated; without one, Tracker uses pixels as the unit of length.
    pub fn is_scaled(&self) -> bool {
        self.placements.iter().any(|placement| placement.scale != [1.0; 2])
    }

    /// True if the axes or the scale change.
    pub fn changes(&self) -> bool {
        let first = self.placements.first().map_or_else(Placement::default, |first| self.at(first.frame));
        self.placements.iter().any(|placement| Placement { frame: first.frame, ..self.at(placement.frame) } != first)
    }
}
