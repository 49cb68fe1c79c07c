//! Calibration form of a film.

use crate::films::subject::Subject;

/// Calibration form. Marks in px of the upright picture, lengths as text with a unit.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CalibrationForm {
    /// Definition of lengths.
    pub lengths: LengthsForm,
    /// Origin of the coordinates, px. Default: bottom left corner of the picture.
    pub origin: Option<[f64; 2]>,
    /// Point on the positive x axis, px. Default: the axis points to the right.
    pub axis: Option<[f64; 2]>,
    /// Place of the ruler, if it is not in the plane of the motion.
    pub parallax: Option<ParallaxForm>,
}

/// Missing part of a calibration without which the record cannot be compared with a model.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lacking {
    /// Scale: the record is in px.
    Lengths,
    /// Origin: heights count from the bottom of the picture.
    Origin,
}

impl CalibrationForm {
    /// Missing part of the calibration. A surface in a tube needs an origin, since models count its height from the
    /// level of rest. A body may start anywhere.
    pub fn lacking(&self, subject: &Subject) -> Option<Lacking> {
        if self.lengths == LengthsForm::Pixels {
            return Some(Lacking::Lengths);
        }
        let needs_zero = matches!(subject, Subject::Surfaces(_)) && self.origin.is_none();
        needs_zero.then_some(Lacking::Origin)
    }
}

/// Definition of lengths.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum LengthsForm {
    /// No scale: the record is in px.
    #[default]
    Pixels,
    /// Two marks of a ruler.
    Ruler {
        /// Positions of the marks, px.
        marks: [[f64; 2]; 2],
        /// Length between the marks, such as `10 cm`.
        length: String,
        /// Number of equal intervals between the two marks, if those marks are used; else 1.
        intervals: u32,
    },
    /// Rectangle in the plane of the motion, seen at an angle.
    Rectangle {
        /// Corners in px: bottom left, bottom right, top right, top left.
        corners: [[f64; 2]; 4],
        /// Width and height, such as `20 cm`.
        size: [String; 2],
    },
}

/// Place of a ruler outside the plane of the motion.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ParallaxForm {
    /// Distance of the ruler behind the motion, such as `1 cm`; negative in front of it.
    pub behind: String,
    /// Distance of the camera from the motion, such as `80 cm`.
    pub distance: String,
}
