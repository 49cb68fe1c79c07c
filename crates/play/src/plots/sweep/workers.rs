//! Who computes the runs of plots over a parameter beside the page: what is handed over, and what comes back.

use super::runs::Runs;
use super::taking::TakenRun;
use crate::motion::Motion;
use engine::{Compiler, Setup};
use program::{Method, Model, NodeId, Sweep};
use serde::{Deserialize, Serialize};
use std::ops::Range;
use std::rc::Rc;

/// Computes runs of plots over a parameter beside the page.
pub trait SweepWorkers {
    /// Number of batches that can be computed at the same time; 0 while no worker is ready, and if there is none: the page
    /// itself computes then.
    fn count(&mut self) -> usize;

    /// Accepts a batch and returns its number, which no other batch of these workers has. At most [`SweepWorkers::count`]
    /// batches are in progress.
    fn begin(&mut self, work: SweepWork) -> u32;

    /// News since the last call, with the numbers of the batches. The runs of a batch come in their order.
    fn news(&mut self) -> Vec<(u32, SweepNews)>;

    /// Gives up all batches whose numbers are not wanted.
    fn keep(&mut self, wanted: &[u32]);
}

/// A batch: runs of neighbouring parameter values, with all that they need. SI units.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct SweepWork {
    model: Model,
    sweep: Sweep,
    /// Final value of each curve.
    drawn: Vec<NodeId>,
    parameters: Vec<f64>,
    drawings: Vec<Vec<f64>>,
    method: Method,
    step: f64,
    tolerance: f64,
    /// Numbers of the runs among all of the plot.
    numbers: Range<usize>,
}

impl SweepWork {
    /// Batch of the runs with these numbers. The setup has neither a start set by hand nor presses of buttons.
    pub(super) fn new(
        model: &Model,
        (sweep, drawn): (&Sweep, &[NodeId]),
        setup: &Setup,
        numbers: Range<usize>,
    ) -> Self {
        Self {
            model: model.clone(),
            sweep: sweep.clone(),
            drawn: drawn.to_vec(),
            parameters: setup.parameters.clone(),
            drawings: setup.drawings.clone(),
            method: setup.method,
            step: setup.step,
            tolerance: setup.tolerance,
            numbers,
        }
    }

    /// Begins to compute. Runs are made in code of the compiler, side by side where it can; the result has the same bits.
    pub fn start(self, compiler: Option<Rc<dyn Compiler>>) -> SweepComputation {
        let Self { model, sweep, drawn, parameters, drawings, method, step, tolerance, numbers } = self;
        let setup = Setup { parameters, method, step, tolerance, start: None, drawings, presses: Vec::new() };
        SweepComputation { runs: Runs::new(&model, &sweep, &drawn), model, compiler, setup, numbers }
    }
}

/// A batch that is being computed.
#[derive(Debug)]
pub struct SweepComputation {
    model: Model,
    compiler: Option<Rc<dyn Compiler>>,
    setup: Setup,
    runs: Runs,
    /// Numbers of the runs that are not complete.
    numbers: Range<usize>,
}

impl SweepComputation {
    /// Continues by about `work` floating-point operations, and returns what is taken from the runs completed since.
    pub fn advance(&mut self, mut work: u64) -> Vec<TakenRun> {
        let motion = Motion::new(&self.model, self.compiler.as_ref());
        let mut complete = Vec::new();
        while work > 0 && !self.numbers.is_empty() {
            if let Some(taken) = self.runs.proceed(motion, &self.setup, self.numbers.clone(), &mut work) {
                complete.push(taken);
                self.numbers.start += 1;
            }
        }
        complete
    }

    /// True if all runs are complete.
    pub fn is_complete(&self) -> bool {
        self.numbers.is_empty()
    }
}

/// Report of a worker about a batch.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum SweepNews {
    /// Further runs are complete.
    Taken {
        /// Their values and points.
        runs: Vec<TakenRun>,
        /// True if they are the last ones of the batch.
        is_last: bool,
    },
    /// The worker has ended; the batch must be computed again.
    Lost,
}
