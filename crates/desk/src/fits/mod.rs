//! Fits: settings, queue, results, application to the sliders, reports.

mod applied;
mod choices;
pub(crate) mod fit;
mod queue;
mod ranges;
pub(crate) mod reporting;
mod results;
pub(crate) mod setup;
pub(crate) mod state;
mod task;
mod workers;
mod zero;

pub use choices::{ChoiceView, FitRecordView, KnownView};
pub use queue::FitProgress;
pub use ranges::{PeriodComparison, PeriodQuestion};
pub use reporting::{Export, ExportKind, Imprint};
pub use results::{EstimateView, FitDetail, FitView, MOST_FITS};
pub use workers::{Finding, FitComputation, FitNews, FitWork, InProcess, NothingFound, Workers};
