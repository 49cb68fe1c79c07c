//! State of all fits: settings, queue, running fit and results.

use crate::fits::fit::{Fitted, Job, Waiting};
use crate::fits::setup::Setup;
use analysis::fit::{Fit, Task};
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
    pub running: Option<Running>,
}

/// The fit that is being computed.
#[derive(Debug)]
pub(crate) struct Running {
    pub job: Job,
    pub task: Task,
    pub fit: Fit,
}

impl Fits {
    /// Takes the fits, and the settings that do not depend on the document, from a desk with another document.
    pub fn adopt(&mut self, other: &mut Self) {
        self.finished = std::mem::take(&mut other.finished);
        self.waiting = std::mem::take(&mut other.waiting);
        self.issued = other.issued;
        if let Some(Running { job, .. }) = other.running.take() {
            self.waiting.extend(Waiting::of(job));
        }
        let (setup, before) = (&mut self.setup, &mut other.setup);
        setup.window = before.window;
        setup.loss = before.loss;
        setup.chosen = before.chosen;
        setup.others = std::mem::take(&mut before.others);
        setup.same = std::mem::take(&mut before.same);
    }
}
