//! Solutions of equations of motion at measured times, with an upper bound of the work.

use engine::{Compiled, Listing, Routine, RunError, Setup, Stepper};
use program::{Model, NodeId};
use std::rc::Rc;

/// Upper bound of the evaluations of the equations for one solution.
const MOST_EVALUATIONS: u64 = 2_000_000;
/// Upper bound of the work for the solutions of all records in one trial, in floating-point operations: some seconds.
const MOST_WORK: u64 = 5_000_000_000;

/// Solver of the equations of motion of a model.
#[derive(Clone, Debug)]
pub(super) struct Motion {
    stepper: Stepper,
    initial: Routine,
    /// Initial values of the last solution, SI.
    start: Vec<f64>,
    zeros: Vec<f64>,
    /// Work of the present trial, in floating-point operations.
    spent: u64,
    /// True once a solution was given up because of one of the upper bounds.
    gave_up: bool,
}

impl Motion {
    /// Solver of the equations of `model` by the method of `setup`.
    pub fn new(model: &Model, setup: &Setup) -> Result<Self, RunError> {
        let nodes: Vec<NodeId> = model.states.iter().map(|state| state.initial).collect();
        let zeros = vec![0.0; nodes.len()];
        let (stepper, initial) = (Stepper::new(model, setup)?, Routine::compile(model, &nodes));
        Ok(Self { stepper, initial, start: zeros.clone(), zeros, spent: 0, gave_up: false })
    }

    /// Makes the steps in compiled code from now on, if `compile` makes it from their listing.
    pub fn compile(&mut self, compile: impl FnOnce(Listing) -> Option<Rc<dyn Compiled>>) {
        if let Some(code) = self.stepper.listing().ok().and_then(compile) {
            self.stepper.use_compiled(code);
        }
    }

    /// Sets the error tolerance of later solutions, relative to the greatest value of each state.
    pub fn set_tolerance(&mut self, tolerance: f64) {
        self.stepper.allow_of_peak(tolerance);
    }

    /// Begins a trial: its solutions together are bounded.
    pub fn begin_trial(&mut self) {
        self.spent = 0;
    }

    /// True if a solution took more computation than is allowed, and was given up.
    pub fn gave_up(&self) -> bool {
        self.gave_up
    }

    /// Adds the work of a solution that was computed elsewhere. False, without adding it, if the upper bound would be exceeded.
    pub fn may_spend(&mut self, work: u64) -> bool {
        let within = self.spent + work <= MOST_WORK;
        self.spent += if within { work } else { 0 };
        within
    }

    /// Evaluates `routine` along a solution, at `times` of the model, SI, ascending and not before 0. `values` becomes the values
    /// of its first root at all times, then those of the second, and so on. Returns the number of times that the solution reaches.
    pub fn solve(&mut self, parameters: &[f64], times: &[f64], routine: &mut Routine, values: &mut [f64]) -> usize {
        self.initial.prepare(parameters, &self.zeros);
        self.initial.evaluate(0.0, &self.zeros, &mut self.start);
        if !self.start.iter().all(|value| value.is_finite()) {
            return 0;
        }
        routine.prepare(parameters, &self.start);
        let stepper = &mut self.stepper;
        stepper.begin(parameters.to_vec(), &self.start);
        let (evaluations, work) = (stepper.evaluations(), stepper.work());
        let (spent, mut made) = (self.spent, evaluations);
        let mut roots = vec![0.0; routine.len()];
        for (row, &time) in times.iter().enumerate() {
            if time > stepper.time() {
                if stepper.advance_to(time).is_err() {
                    return row;
                }
                // Most times lie within the last step and need no evaluation.
                if stepper.evaluations() != made {
                    made = stepper.evaluations();
                    self.spent = spent + (stepper.work() - work);
                    if made - evaluations > MOST_EVALUATIONS || self.spent > MOST_WORK {
                        self.gave_up = true;
                        return row;
                    }
                }
            }
            routine.evaluate(time, stepper.state(), &mut roots);
            for (values, root) in values.chunks_mut(times.len()).zip(&roots) {
                values[row] = *root;
            }
        }
        times.len()
    }
}
