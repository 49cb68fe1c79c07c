//! The parts of *See it measured*, in their order.

/// Part of the story.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Moment {
    /// The film plays while it is tracked.
    Film,
    /// The film plays again, and the measured points appear.
    Curve,
    /// The drawing moves over the film, with the curve of the present values.
    Theory,
    /// The fit.
    Fit,
}

/// All moments, in their order.
pub const MOMENTS: [Moment; 4] = [Moment::Film, Moment::Curve, Moment::Theory, Moment::Fit];

impl Moment {
    /// Name for the style sheet.
    pub fn name(self) -> &'static str {
        match self {
            Self::Film => "film",
            Self::Curve => "curve",
            Self::Theory => "theory",
            Self::Fit => "fit",
        }
    }
}
