//! All fits of a desk: what is asked for, what waits, what is being made, what is finished.

use crate::fits::fit::{Fitted, Job, Waiting};
use crate::fits::setup::Setup;
use analysis::fit::{Fit, Task};
use std::collections::VecDeque;

/// What fits are asked for, and what has come of them.
#[derive(Debug, Default)]
pub(crate) struct Fits {
    pub setup: Setup,
    pub finished: Vec<Fitted>,
    /// The fit whose numbers stand in the sliders.
    pub applied: Option<u32>,
    /// Fits of an earlier visit, to be made again.
    pub waiting: VecDeque<Waiting>,
    /// How many ids fits have been given: none is given twice, because one may still be called by it.
    pub issued: u32,
    /// Theories of the queue that could not be fitted, each with the reason.
    pub left_out: Vec<String>,
    pub queue: Vec<Job>,
    /// How many there were when the queue began.
    pub total: usize,
    pub running: Option<Running>,
}

/// The fit that is being made.
#[derive(Debug)]
pub(crate) struct Running {
    pub job: Job,
    pub task: Task,
    pub fit: Fit,
}

impl Fits {
    /// Takes over from a desk that had another document open what does not depend on the document.
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
