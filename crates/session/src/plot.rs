//! The plots: figures of what has been recorded, zoomed, panned and read by pointer or keyboard.

use crate::Session;
use figure::{Direction, Figure, Palette, Point, Readout, Settings};

/// A plot in the list.
#[derive(Clone, Debug, PartialEq)]
pub struct PlotView {
    /// Which of [`document::Document::plots`].
    pub index: usize,
    /// The title in the session's language.
    pub title: String,
    /// Whether it is to be shown.
    pub shown: bool,
    /// Whether it shows all of the data.
    pub automatic: bool,
}

impl Session {
    /// The plots, in the order of the text.
    pub fn plots(&self) -> Vec<PlotView> {
        Vec::new()
    }

    /// Shows a plot or not.
    pub fn show_plot(&mut self, index: usize, shown: bool) {
        let _ = (index, shown);
    }

    /// Lays a plot out for the time shown; the figure's buffers are kept from frame to frame. `None` if there is no such
    /// plot.
    pub fn layout_plot(&mut self, index: usize, settings: &Settings) -> Option<&Figure> {
        let _ = (index, settings);
        None
    }

    /// The figure of the last [`Session::layout_plot`].
    pub fn plot_figure(&self, index: usize) -> Option<&Figure> {
        let _ = index;
        None
    }

    /// The plot as a standalone SVG file.
    pub fn plot_svg(&mut self, index: usize, settings: &Settings, palette: &Palette) -> String {
        let _ = (index, settings, palette);
        String::new()
    }

    /// What lies at a pixel of the last layout. Any keyboard cursor moves there.
    pub fn hover_plot(&mut self, index: usize, at: Point) -> Option<Readout> {
        let _ = (index, at);
        None
    }

    /// Moves the keyboard cursor by so many rows along the first series (from the present row at first) and reads there.
    pub fn move_cursor(&mut self, index: usize, rows: isize) -> Option<Readout> {
        let _ = (index, rows);
        None
    }

    /// Zooms by `factor` (2 shows half as much) about a pixel; about the centre without one.
    pub fn zoom_plot(
        &mut self,
        index: usize,
        at: Option<Point>,
        factor: f64,
        direction: Direction,
    ) {
        let _ = (index, at, factor, direction);
    }

    /// Zooms to the rectangle between two pixels.
    pub fn zoom_plot_to(&mut self, index: usize, one: Point, other: Point) {
        let _ = (index, one, other);
    }

    /// Moves what is shown by so many pixels.
    pub fn pan_plot(&mut self, index: usize, right: f64, down: f64) {
        let _ = (index, right, down);
    }

    /// Shows all of the data again.
    pub fn reset_plot(&mut self, index: usize) {
        let _ = index;
    }
}
