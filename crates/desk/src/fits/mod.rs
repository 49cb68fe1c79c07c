//! Fits: what is varied, the queue, the results, what stands in the sliders, reports.

mod applied;
pub(crate) mod fit;
pub(crate) mod queue;
pub(crate) mod reporting;
pub(crate) mod results;
mod saved;
pub(crate) mod setup;
mod task;

pub use queue::FitProgress;
pub use reporting::{Export, ExportKind, Imprint};
pub use results::{EstimateView, FitDetail, FitView, MOST_FITS};
pub use setup::{ChoiceView, FitRecordView, KnownView};
