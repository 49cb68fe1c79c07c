//! Figures: axes, ticks and series to a display list, and that to SVG.
//!
//! A [`Plot`] borrows what is to be drawn: labels and columns of numbers. [`layout`] turns it into a [`Figure`]: rules,
//! polylines and texts in pixels, each with the [`Ink`] it is drawn in, and the scales that lead back from a pixel to a
//! value. The page paints the items on a canvas, [`Figure::svg`] writes the same items as a file, so that the figure on
//! the page, in a report and from the command line is one figure.
//!
//! Nothing here knows a model, a browser or a unit: values come in the unit of their axis and the unit is a text.

mod axes;
mod cloud;
mod figure;
mod hover;
mod items;
mod layout;
mod limits;
mod palette;
mod plot;
mod raster;
mod series;
mod spread;
mod svg;
mod text;
mod ticks;
mod trace;
mod view;

pub use figure::Figure;
pub use hover::{Readout, Sample};
pub use items::{Anchor, Dash, Ink, Item, Point, Rect, Scale, Stroke};
pub use layout::{layout, layout_into};
pub use palette::{Colour, Palette, RUN_COLOURS, SERIES_COLOURS};
pub use plot::{Axis, Interval, Plot, Series, Settings, Style, View};
pub use svg::FONT_FAMILY;
pub use view::Direction;
