//! Values at the ends of runs, in lanes.

use crate::body::Body;
use crate::grid::Grid;
use crate::lanes::Lanes;
use crate::reason::NoLanes;
use crate::width::Width;
use engine::{Interpreted, Routine};
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

impl Ends {
    /// Reads these nodes. `further`: number of parameters that follow those of the model.
    ///
    /// # Errors
    /// The nodes are solutions of linear systems, which are found run by run.
    pub fn new(model: &Model, nodes: &[NodeId], further: usize) -> Result<Self, NoLanes> {
        let body = Body::of_routine(&Routine::compile(model, nodes), model.states.len());
        let body = body.ok_or(NoLanes::Interpreted(Interpreted::LinearSystem))?;
        Ok(Self { body, further, inputs: Grid::default(), list: vec![0.0; further] })
    }

    /// Evaluates the nodes at the last row of each lane. `set` gets the index of a run and sets its further parameters, SI units.
    pub fn evaluate(&mut self, lanes: &Lanes, width: Width, set: &mut dyn FnMut(usize, &mut [f64])) {
        let Self { body, further, inputs, list } = self;
        let parameters = lanes.parameters.rows();
        if inputs.blocks() != lanes.blocks {
            *inputs = Grid::new(parameters + *further, lanes.blocks);
        }
        body.resize(lanes.blocks, width);
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

    /// Value of a node for a run, SI units.
    pub fn value(&self, run: usize, node: usize) -> f64 {
        self.body.value(node, run)
    }
}
