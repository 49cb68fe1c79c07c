//! What the page sends to a worker.

use class::collection::WorkOrder;
use desk::FitWork;
use serde::{Deserialize, Serialize};

/// Work for a worker. Its answers are bytes of postcard's format.
#[derive(Debug, Serialize, Deserialize)]
pub enum Order {
    /// A fit; the answers are [`desk::FitNews`].
    Fit(Box<FitWork>),
    /// Hand-ins to be computed again; the answer is a list of `Option<class::collection::Computed>` in the same order.
    HandIns(Vec<WorkOrder>),
}
