//! Errors of calibration.

use units::{Words, words};

/// Reason why a calibration is not possible.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Refusal {
    /// The marks are too close together, or a coordinate is not finite.
    Close,
    /// A length is not positive.
    Length,
    /// The corners are not those of a rectangle seen from one side.
    Corners,
    /// The ruler has no visible marks at this spacing.
    Marks,
}

impl Refusal {
    /// Message: what happened, and what to do.
    pub fn words(self) -> Words {
        match self {
            Self::Close => words("The marks lie too close together. Choose marks that are far apart."),
            Self::Length => words("A length must be positive. Enter a length such as 10 cm."),
            Self::Corners => words(
                "The four points are not the corners of a rectangle. Click them in order: bottom left, bottom right, top right, top left.",
            ),
            Self::Marks => words(
                "No regular marks were found between the two points. Check the number of intervals, or use the two marks alone.",
            ),
        }
    }
}
