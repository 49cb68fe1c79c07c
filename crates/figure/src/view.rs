//! Zooming and panning: from a gesture in pixels to the next view.

use crate::figure::{Figure, Point};
use crate::plot::View;

/// Along which axes a view changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// Along the horizontal axis.
    Horizontal,
    /// Along the vertical axes.
    Vertical,
    /// Along both.
    Both,
}

impl Figure {
    /// Zooms by a factor (2 shows half as much) about a pixel, which keeps its values.
    pub fn zoom(&self, at: Point, factor: f64, direction: Direction) -> View {
        let _ = (at, factor, direction);
        View::default()
    }

    /// Zooms by a factor about the centre of the panel.
    pub fn zoom_centre(&self, factor: f64, direction: Direction) -> View {
        let _ = (factor, direction);
        View::default()
    }

    /// Zooms to the rectangle between two pixels.
    pub fn zoom_to(&self, one: Point, other: Point) -> View {
        let _ = (one, other);
        View::default()
    }

    /// Moves what is shown by so many pixels, right and down, as if the paper were dragged.
    pub fn pan(&self, right: f64, down: f64) -> View {
        let _ = (right, down);
        View::default()
    }
}
