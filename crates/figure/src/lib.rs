//! Figures: layout of axes, ticks and series as a display list, and its output as SVG.
//!
//! A [`Plot`] borrows the data: labels and columns of numbers. [`layout()`] turns it into a [`Figure`]: lines, polylines and
//! texts in pixels, each with its [`Ink`], and the scales from pixels back to values. The page paints the items on a
//! canvas; [`Figure::svg`] writes the same items to a file. Figures of page, report and command line are therefore
//! identical.
//!
//! This crate is independent of models and browsers: values are in the unit of their axis, and the unit is a text.

mod axes;
mod cloud;
mod ends;
mod figure;
mod hover;
mod items;
mod layout;
mod limits;
mod palette;
mod plot;
mod raster;
mod scales;
mod series;
mod spread;
mod svg;
mod text;
mod ticks;
mod trace;
mod view;
mod word_cloud;

pub use figure::Figure;
pub use hover::{Readout, Sample};
pub use items::{Anchor, Dash, Ink, Item, Point, Rect, Scale, Stroke};
pub use layout::{layout, layout_into};
pub use palette::{Colour, Palette, RUN_COLOURS, SERIES_COLOURS};
pub use plot::{Axis, Interval, Level, Plot, Series, Settings, Style, View};
pub use scales::{ScaleRow, scale_bars};
pub use svg::FONT_FAMILY;
pub use view::Direction;
pub use word_cloud::{PlacedWord, WordCloud, word_cloud};
