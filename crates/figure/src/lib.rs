//! Figures: layout of axes, ticks and series as a display list, and its output as SVG.
//!
//! A [`Plot`] borrows the data: labels and columns of numbers. [`layout()`] turns it into a [`Figure`]: lines, polylines and
//! texts in pixels, each with its [`Ink`], and the scales from pixels back to values. The page paints the items on a canvas;
//! [`Figure::svg`] writes the same items to a file. Figures of page, report and command line are therefore identical. Zoom,
//! hover and cursor are arithmetic on a laid-out [`Figure`]. [`Style::Run`] is for kept runs, [`Plot::equal`] for paths.
//! [`word_cloud()`] and [`scale_bars`] are drawings of their own, for surveys.
//!
//! - **Invariant:** no models, no DOM. Values are in the unit of their axis, and the unit is a text; from `units` the crate
//!   uses only the number writer.
//! - **Invariant:** the time of a frame grows with the pixels of the panel, not with the points of a record. `cloud.rs` keeps
//!   the occupied pixels as long as a series has the same [`Series::version`].
//!
//! ```
//! use figure::{Axis, Palette, Plot, Series, Settings, layout};
//!
//! let (t, y) = ([0.0, 0.5, 1.0], [0.0, 0.2, 0.1]);
//! let plot = Plot {
//!     x: Axis { label: "t", unit: "s", ..Axis::default() },
//!     y: vec![Axis { label: "y", unit: "m", ..Axis::default() }],
//!     series: vec![Series { label: "y", x: &t, y: &y, ..Series::default() }],
//!     ..Plot::default()
//! };
//! assert!(layout(&plot, &Settings::default()).svg(&Palette::LIGHT).starts_with("<svg"));
//! ```

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
