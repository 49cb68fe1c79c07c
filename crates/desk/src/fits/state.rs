//! State of all fits: settings, queue, running fits and results.

use crate::fits::fit::{Fitted, Job, Waiting};
use crate::fits::setup::Setup;
use crate::fits::workers::{Finding, FitWork, InProcess, NothingFound};
use analysis::fit::Task;
use std::collections::VecDeque;
use units::Words;

/// All fits of a desk.
#[derive(Debug, Default)]
pub(crate) struct Fits {
    pub setup: Setup,
    pub finished: Vec<Fitted>,
    /// Id of the fit whose values are set on the sliders.
    pub applied: Option<u32>,
    /// Fits of an earlier visit that are to be reconstructed.
    pub waiting: VecDeque<Waiting>,
    /// Number of ids issued so far. Ids are never reused, because old references may exist.
    pub issued: u32,
    /// Theories of the queue that could not be fitted, each with the reason.
    pub left_out: Vec<String>,
    /// A sentence for each fit that could not be reconstructed.
    pub lost: Vec<Words>,
    pub queue: Vec<Job>,
    /// Length of the queue when it was started.
    pub total: usize,
    /// Fits that are being computed, in the order of the queue, in which their results are taken.
    pub running: VecDeque<Running>,
    /// Computes fits where no other workers are given.
    pub here: InProcess,
}

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

impl Fits {
    /// Takes the fits, and the settings that do not depend on the document, from a desk with another document.
    pub fn adopt(&mut self, other: &mut Self) {
        self.finished = std::mem::take(&mut other.finished);
        self.waiting = std::mem::take(&mut other.waiting);
        self.issued = other.issued;
        self.waiting.extend(other.running.drain(..).filter_map(|running| Waiting::of(running.job)));
        let (setup, before) = (&mut self.setup, &mut other.setup);
        setup.window = before.window;
        setup.loss = before.loss;
        setup.chosen = before.chosen;
        setup.others = std::mem::take(&mut before.others);
        setup.same = std::mem::take(&mut before.same);
    }
}
