//! What others add to the figures: points over the curves of a plot, and plots of their own.

use super::labels::Labels;
use figure::{Interval, SERIES_COLOURS, Style};

/// The first colour of points: the first curves have those before it, and a line could not be seen on points of its colour.
const POINTS: usize = 3;

/// The colour of the points of a measured column, by its number among all that are drawn.
pub fn points_colour(number: usize) -> u8 {
    (POINTS + number % (SERIES_COLOURS - POINTS)) as u8
}

/// Points over one curve of a plot of the document, in the units of its axes.
#[derive(Clone, Debug, Default)]
pub struct Points {
    /// Which curve.
    pub curve: usize,
    /// Which colour of the palette.
    pub colour: u8,
    /// The entry in the legend.
    pub label: String,
    /// Where they come from; a reading begins with it.
    pub source: String,
    /// Along the horizontal axis.
    pub x: Vec<f64>,
    /// Along the vertical axis.
    pub y: Vec<f64>,
    /// Standard errors along the vertical axis; empty where there are none.
    pub errors: Vec<f64>,
    /// See [`figure::Series::version`].
    pub version: u64,
}

/// A plot that is not the document's, such as residuals.
#[derive(Debug, Default)]
pub struct AddedPlot {
    /// Its texts.
    pub labels: Labels,
    /// What is drawn.
    pub series: Vec<AddedSeries>,
    /// What the horizontal axis shows at least.
    pub x_includes: Option<Interval>,
    /// What the vertical axes show at least.
    pub y_includes: Option<Interval>,
    /// What the vertical axis shows unless it is zoomed.
    pub y_limits: Option<Interval>,
    /// Whether the time shown is marked on the horizontal axis.
    pub marks_time: bool,
    /// Whether the abscissas ascend.
    pub ordered: bool,
    /// Whether there is anything to show.
    pub offered: bool,
    /// Whether it stands apart from the other plots, where its owner puts it.
    pub apart: bool,
    /// The series along which the keyboard's cursor goes.
    pub cursor: usize,
}

/// A series of an [`AddedPlot`], in the units of its axes.
#[derive(Debug, Default)]
pub struct AddedSeries {
    /// Which axis.
    pub axis: usize,
    /// Which colour of the palette.
    pub colour: u8,
    /// How it is drawn.
    pub style: Style,
    /// Whether it stands in the legend, with its name among [`Labels::curves`].
    pub in_legend: bool,
    /// Along the horizontal axis.
    pub x: Vec<f64>,
    /// Along the vertical axis.
    pub y: Vec<f64>,
    /// Standard errors; empty where there are none.
    pub errors: Vec<f64>,
    /// See [`figure::Series::version`].
    pub version: u64,
}
