//! The figure: result of a layout, ready to be painted.

use crate::items::{Entry, Item, Point, Rect, Scale};
use crate::plot::{Interval, Level, View};
use crate::raster::Cloud;
use crate::ticks::Ticks;

/// A laid-out plot: the items to paint, and the scales from pixels back to values.
///
/// A figure can be laid out repeatedly with [`crate::layout_into`], which reuses its buffers.
#[derive(Clone, Debug, Default)]
pub struct Figure {
    /// Width of the figure, CSS pixels.
    pub width: f64,
    /// Height of the figure, CSS pixels.
    pub height: f64,
    /// Rectangle in which the series are drawn, CSS pixels.
    pub panel: Rect,
    pub(crate) font_size: f64,
    pub(crate) title: String,
    pub(crate) description: String,
    pub(crate) x: Option<Scale>,
    pub(crate) y: Vec<Scale>,
    pub(crate) y_ticks: Vec<Ticks>,
    pub(crate) x_power: i32,
    /// The view of this layout; `home_x` and `home_y` are the automatic limits.
    pub(crate) view: View,
    pub(crate) home_x: Option<Interval>,
    pub(crate) home_y: Vec<Interval>,
    pub(crate) style: units::number::Style,
    pub(crate) entries: Vec<Entry>,
    pub(crate) points: Vec<f32>,
    pub(crate) text: String,
    /// Data of series with very many points, kept between layouts.
    pub(crate) clouds: Vec<Cloud>,
    /// True if some of their points are still missing.
    pub(crate) unfinished: bool,
    /// Scale of the drawing beside the plot.
    pub(crate) level: Option<Level>,
    /// True if the vertical axis has it.
    pub(crate) is_level: bool,
    /// Dot of the present moment of the first series that has one.
    pub(crate) present: Option<Point>,
}

impl Figure {
    /// True if points of very long series are still missing; further layouts add them.
    pub fn is_unfinished(&self) -> bool {
        self.unfinished
    }

    /// Items to paint, in drawing order.
    pub fn items(&self) -> impl Iterator<Item = Item<'_>> {
        self.entries.iter().map(|entry| match entry {
            Entry::Fill(area, ink) => Item::Fill(*area, *ink),
            Entry::Line(from, to, stroke) => Item::Line(*from, *to, *stroke),
            Entry::Polyline(points, stroke) => Item::Polyline(&self.points[points.clone()], *stroke),
            Entry::Area(points, ink) => Item::Area(&self.points[points.clone()], *ink),
            Entry::Dots { centres, radius, ink, ringed } => {
                Item::Dots { centres: &self.points[centres.clone()], radius: *radius, ink: *ink, ringed: *ringed }
            }
            Entry::Bars { bars, radius, ink } => {
                Item::Bars { bars: &self.points[bars.clone()], radius: *radius, ink: *ink }
            }
            Entry::Text { text, at, anchor, size, strong, ink } => Item::Text {
                text: &self.text[text.clone()],
                at: *at,
                anchor: *anchor,
                size: *size,
                strong: *strong,
                ink: *ink,
            },
        })
    }

    /// Dot of the present moment if the vertical axis has the scale of the drawing beside the plot ([`crate::Settings::level`]).
    pub fn level_point(&self) -> Option<Point> {
        self.present.filter(|_| self.is_level)
    }

    /// True if there is a scale of a drawing beside the plot, and the automatic range does not fit into it.
    pub fn exceeds_level(&self) -> bool {
        self.level.is_some() && !self.is_level && self.view.is_automatic()
    }

    /// Horizontal scale; `None` before the first layout or if there is no room for the panel.
    pub fn x_scale(&self) -> Option<&Scale> {
        self.x.as_ref()
    }

    /// Scales of the vertical axes.
    pub fn y_scales(&self) -> &[Scale] {
        &self.y
    }
}
