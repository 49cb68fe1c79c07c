//! Figures: the document's plots with the present and kept runs, and content added by other crates.

mod added;
mod drawn;
pub(crate) mod histogram;
mod labelling;
mod labels;
pub(crate) mod members;
pub(crate) mod plot;
mod reading;
pub(crate) mod section;
mod series;
pub(crate) mod sweep;
pub(crate) mod traces;
mod viewing;

pub use added::{AddedPlot, AddedSeries, Points, points_colour};
pub use labels::Labels;
pub use plot::{PlotId, PlotView};
pub use series::LegendEntry;
