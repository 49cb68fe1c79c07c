//! Fits that are being computed.

use crate::fits::fit::Job;
use crate::fits::workers::{Finding, FitWork, NothingFound};
use analysis::fit::Task;

/// A fit that is being computed.
#[derive(Debug)]
pub(crate) struct Running {
    pub job: Job,
    pub task: Task,
    /// Its number among the workers; `None` before one of them has it.
    pub number: Option<u32>,
    /// Number of trials so far, and coefficient of determination of the best one.
    pub progress: (usize, f64),
    /// Its result, if it is finished.
    pub found: Option<Result<Box<Finding>, NothingFound>>,
}

impl Running {
    /// Order for a worker.
    pub fn work(&self) -> FitWork {
        let known = self.job.found.as_ref().map(|found| found.values.clone());
        FitWork::new(self.job.document.program.model.clone(), self.task.clone(), known)
    }
}
