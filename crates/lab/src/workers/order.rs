//! What the page sends to a worker.

use class::collection::WorkOrder;
use desk::FitWork;
use play::SweepWork;
use serde::{Deserialize, Serialize};

/// Work for a worker. A message is the number of the order and the order, an answer the number and what is found, as bytes of
/// postcard's format.
#[derive(Debug, Serialize, Deserialize)]
pub enum Order {
    /// A fit; the answers are [`desk::FitNews`].
    Fit(Box<FitWork>),
    /// Hand-ins to be computed again; the answer is a list of `Option<class::collection::Computed>` in the same order.
    HandIns(Vec<WorkOrder>),
    /// Runs of a plot over a parameter, which take the place of those in progress; the answers are [`play::SweepNews`].
    Sweep(Box<SweepWork>),
    /// The runs in progress are not wanted any more.
    Stop,
}
