//! Values at the ends of runs, in lanes.

use crate::body::Body;
use crate::ensemble::Ensemble;
use crate::grid::Grid;
use crate::reason::NoLanes;
use engine::{Interpreted, Routine, RunError};
use program::{Model, NodeId};

/// Formulas that are evaluated at the last row of each run.
#[derive(Clone, Debug, Default)]
pub(crate) struct Ends {
    body: Body,
    /// Number of parameters that follow those of the model.
    further: usize,
    /// The parameters of all lanes, then the further ones.
    inputs: Grid,
    /// Further parameters of a lane.
    list: Vec<f64>,
}

impl Ensemble {
    /// Reads these nodes also at the ends of runs. `further`: number of parameters that follow those of the model.
    ///
    /// # Errors
    /// The nodes are solutions of linear systems, which are found run by run.
    pub fn with_ends(mut self, model: &Model, nodes: &[NodeId], further: usize) -> Result<Self, NoLanes> {
        let body = Body::of_routine(&Routine::compile(model, nodes), model.states.len());
        let body = body.ok_or(NoLanes::Interpreted(Interpreted::LinearSystem))?;
        self.ends = Ends { body, further, inputs: Grid::default(), list: vec![0.0; further] };
        Ok(self)
    }

    /// Evaluates the nodes of [`Ensemble::with_ends`] at the last row of each run at or before its end. `set` gets the index of a run
    /// and sets its further parameters, SI units.
    pub fn evaluate_ends(&mut self, set: &mut dyn FnMut(usize, &mut [f64])) {
        let Self { ends: Ends { body, further, inputs, list }, lanes, width, .. } = self;
        let parameters = lanes.parameters.rows();
        if inputs.blocks() != lanes.blocks {
            *inputs = Grid::new(parameters + *further, lanes.blocks);
        }
        body.resize(lanes.blocks, *width);
        (0..parameters).for_each(|row| inputs.row_mut(row).copy_from_slice(lanes.parameters.row(row)));
        for run in (0..lanes.runs).filter(|_| *further > 0) {
            set(run, list);
            list.iter().enumerate().for_each(|(number, value)| inputs.set(parameters + number, run, *value));
        }
        body.prepare(inputs, &lanes.initial);
        body.set_time(&lanes.last_time, 0);
        body.set_states(&lanes.last);
        body.evaluate();
    }

    /// Value of a node at the end of a run, SI units, after [`Ensemble::evaluate_ends`].
    pub fn value_at_end(&self, run: usize, node: usize) -> f64 {
        self.ends.body.value(node, run)
    }

    /// Error of a run; `None` if it has none. An event that ends the run is none.
    pub fn error(&self, run: usize) -> Option<&RunError> {
        self.lanes.errors[run].as_ref()
    }
}
