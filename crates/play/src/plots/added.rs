//! Content added to the figures by other crates: points over the curves of a plot, and separate plots.

use super::labels::Labels;
use figure::{Interval, SERIES_COLOURS, Style};

/// First palette colour of points. The first curves use the colours before it; a line would be invisible on points of
/// its own colour.
const POINTS: usize = 3;

/// Palette colour of the points of a measured column, from its number among all drawn columns.
pub fn points_colour(number: usize) -> u8 {
    (POINTS + number % (SERIES_COLOURS - POINTS)) as u8
}

/// Points over one curve of a plot of the document, in the units of its axes.
#[derive(Clone, Debug, Default)]
pub struct Points {
    /// Index of the curve.
    pub curve: usize,
    /// Index of the palette colour.
    pub colour: u8,
    /// Legend entry.
    pub label: String,
    /// Source of the points; a read-out begins with it.
    pub source: String,
    /// Abscissas.
    pub x: Vec<f64>,
    /// Ordinates.
    pub y: Vec<f64>,
    /// Standard errors of the ordinates; empty if there are none.
    pub errors: Vec<f64>,
    /// Number of the measured column among all that are drawn.
    pub column: usize,
    /// Index of each point among the values of its column.
    pub places: Vec<usize>,
    /// True if they are left out of fits, and drawn faintly.
    pub unused: bool,
    /// See [`figure::Series::version`].
    pub version: u64,
}

/// A plot that does not come from the document, such as residuals.
#[derive(Debug, Default)]
pub struct AddedPlot {
    /// Texts of the plot.
    pub labels: Labels,
    /// Series, in drawing order.
    pub series: Vec<AddedSeries>,
    /// Interval that the horizontal axis shows at least.
    pub x_includes: Option<Interval>,
    /// Interval that the vertical axes show at least.
    pub y_includes: Option<Interval>,
    /// Interval that the vertical axis shows unless zoomed.
    pub y_limits: Option<Interval>,
    /// True if the time shown is marked on the horizontal axis.
    pub marks_time: bool,
    /// True if the abscissas ascend.
    pub ordered: bool,
    /// True if the plot has anything to show.
    pub offered: bool,
    /// True if it stands apart from the other plots, where its owner places it.
    pub apart: bool,
    /// Index of the series that the keyboard cursor follows.
    pub cursor: usize,
}

/// A series of an [`AddedPlot`], in the units of its axes.
#[derive(Debug, Default)]
pub struct AddedSeries {
    /// Index of the vertical axis.
    pub axis: usize,
    /// Index of the palette colour.
    pub colour: u8,
    /// Drawing style.
    pub style: Style,
    /// True if the legend lists it, with its name from [`Labels::curves`].
    pub in_legend: bool,
    /// Abscissas.
    pub x: Vec<f64>,
    /// Ordinates.
    pub y: Vec<f64>,
    /// Standard errors of the ordinates; empty if there are none.
    pub errors: Vec<f64>,
    /// See [`figure::Series::version`].
    pub version: u64,
}
