//! Identifiers of plots, and their list.

use std::fmt;

/// Identifies a plot while the document is open. The document's plots come first, in the order of the text.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct PlotId(pub(crate) usize);

impl PlotId {
    /// Identifier of the plot at a position in the list.
    pub fn at(place: usize) -> Self {
        Self(place)
    }

    /// Position in the list.
    pub fn place(self) -> usize {
        self.0
    }
}

/// Writes the position, for ids of HTML elements.
impl fmt::Display for PlotId {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(formatter)
    }
}

/// A plot, for the list of plots.
#[derive(Clone, Debug, PartialEq)]
pub struct PlotView {
    /// Identifier.
    pub id: PlotId,
    /// Title in the chosen language.
    pub title: String,
    /// True if the user has not hidden it.
    pub shown: bool,
    /// True if it is not zoomed: all data are visible.
    pub automatic: bool,
    /// True if it has anything to show; residuals, for instance, only if there are measurements.
    pub offered: bool,
    /// True if it stands apart from the other plots.
    pub apart: bool,
    /// True if its curves are drawn against the independent variable of the run.
    pub follows_run: bool,
    /// Expression of its only curve, if that is drawn against the independent variable; otherwise empty.
    pub quantity: String,
    /// Symbols of its curves, those of a path in the plane with their abscissa: `T, V, E`, `y′(y)`.
    pub symbols: String,
    /// True if both axes have the same scale, so that its height limits its width.
    pub equal: bool,
}
