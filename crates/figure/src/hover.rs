//! Reading values off a figure: what lies under the pointer or the keyboard's cursor.

use crate::figure::{Figure, Point};
use crate::plot::Plot;

/// What a figure says about a place.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Readout {
    /// The abscissa with its unit, `t = 1.25 s`; the same for all samples of a time plot.
    pub heading: String,
    /// The samples there: in a time plot one of each series, else the nearest one alone.
    pub samples: Vec<Sample>,
}

/// One sample of a series.
#[derive(Clone, Debug, PartialEq)]
pub struct Sample {
    /// Which of the plot's series.
    pub series: usize,
    /// Which row of it.
    pub row: usize,
    /// Its abscissa in the unit of the axis.
    pub x: f64,
    /// Its ordinate in the unit of the axis.
    pub y: f64,
    /// Where it is in the figure.
    pub at: Point,
    /// The ordinate with name and unit, `y = 0.412 m`.
    pub text: String,
}

impl Figure {
    /// The samples nearest to a pixel: of each series the one nearest along the horizontal axis if all abscissas ascend,
    /// else the single nearest sample of all. None when there is no finite sample in the panel.
    pub fn hover(&self, plot: &Plot<'_>, at: Point) -> Option<Readout> {
        let _ = (plot, at);
        None
    }

    /// The read-out at a row of a series, for a cursor moved by keyboard.
    pub fn readout(&self, plot: &Plot<'_>, series: usize, row: usize) -> Option<Readout> {
        let _ = (plot, series, row);
        None
    }

    /// The row to which a cursor moves by `rows` from `row` in a series: clamped to those that are finite and in the panel.
    pub fn step(&self, plot: &Plot<'_>, series: usize, row: usize, rows: isize) -> Option<usize> {
        let _ = (plot, series, row, rows);
        None
    }
}
