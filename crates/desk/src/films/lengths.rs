//! What a person says of lengths in a film.

use crate::films::subject::Subject;

/// What a person says of lengths: marks are pixels of the upright picture, lengths are texts with a unit.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CalibrationForm {
    /// How long something is.
    pub lengths: LengthsForm,
    /// The point that becomes zero; the bottom left corner of the picture without it.
    pub origin: Option<[f64; 2]>,
    /// A point towards which the x axis points from the origin; to the right without it.
    pub axis: Option<[f64; 2]>,
    /// Where the ruler is, if it is not where the motion is.
    pub parallax: Option<ParallaxForm>,
}

/// What a calibration lacks before a record of it can be compared with a model.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lacking {
    /// A length: the record is in pixels.
    Lengths,
    /// The zero of the height: heights count from the bottom of the picture.
    Origin,
}

impl CalibrationForm {
    /// What is still to be clicked. A column in a tube needs its zero, since models count its height from the level of rest; a body
    /// may start anywhere.
    pub fn lacking(&self, subject: &Subject) -> Option<Lacking> {
        if self.lengths == LengthsForm::Pixels {
            return Some(Lacking::Lengths);
        }
        let needs_zero = matches!(subject, Subject::Surfaces(_)) && self.origin.is_none();
        needs_zero.then_some(Lacking::Origin)
    }
}

/// How lengths are found.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum LengthsForm {
    /// They are not: the record stays in pixels.
    #[default]
    Pixels,
    /// By two marks of a ruler.
    Ruler {
        /// The marks.
        marks: [[f64; 2]; 2],
        /// The length between them, such as `10 cm`.
        length: String,
        /// Into how many equal intervals marks between them divide it; 1 for none, or if they are not to be used.
        intervals: u32,
    },
    /// By a rectangle in the plane of the motion, seen at an angle.
    Rectangle {
        /// Bottom left, bottom right, top right, top left.
        corners: [[f64; 2]; 4],
        /// Width and height, such as `20 cm`.
        size: [String; 2],
    },
}

/// Where a ruler is that is not where the motion is.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ParallaxForm {
    /// By how much the ruler is behind what moves, such as `1 cm`; negative in front of it.
    pub behind: String,
    /// How far the camera is from what moves, such as `80 cm`.
    pub distance: String,
}
