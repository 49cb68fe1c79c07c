//! From a plot to a figure.

use crate::figure::Figure;
use crate::plot::{Plot, Settings};

/// Lays a plot out.
pub fn layout(plot: &Plot<'_>, settings: &Settings) -> Figure {
    let mut figure = Figure::default();
    layout_into(&mut figure, plot, settings);
    figure
}

/// Lays a plot out in the buffers of an earlier figure.
pub fn layout_into(figure: &mut Figure, plot: &Plot<'_>, settings: &Settings) {
    let _ = plot;
    figure.width = settings.width;
    figure.height = settings.height;
}
