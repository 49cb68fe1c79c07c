//! Certainty of rows of the surface.

/// A frame is doubtful below this lead or contrast, or above this misfit.
const LEAD: f32 = 0.25;
const CONTRAST: f32 = 1.0;
const MISFIT: f32 = 0.6;
/// A frame is clear above this lead and below this misfit.
const CLEAR_LEAD: f32 = 0.45;
const CLEAR_MISFIT: f32 = 0.3;
/// Fraction of the rows passed by the surface, showing neither region, from which the tube is covered.
const COVERED: f32 = 0.4;

/// Certainty of the row of a frame.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Certainty {
    /// Additional cost of a path through the best alternative row, relative to the additional cost predicted by the
    /// model.
    pub lead: f32,
    /// Predicted additional cost, in units of the noise.
    pub contrast: f32,
    /// Mean cost of a value around the surface, 0 to 1.
    pub misfit: f32,
    /// Fraction of the rows passed by the surface that shows neither region.
    pub covered: f32,
}

impl Certainty {
    /// True if the two regions determine the row to about a pixel, even if the picture around it differs from the
    /// others, for instance by leaves behind clear water.
    pub(crate) fn is_clear(&self) -> bool {
        self.lead > CLEAR_LEAD && self.misfit < CLEAR_MISFIT
    }

    /// True if something covers the tube.
    pub(crate) fn is_hidden(&self) -> bool {
        self.covered > COVERED && !self.is_clear()
    }

    /// True if the surface may be elsewhere, or is hidden.
    pub(crate) fn is_doubtful(&self) -> bool {
        self.lead < LEAD || self.contrast < CONTRAST || self.misfit > MISFIT
    }
}
