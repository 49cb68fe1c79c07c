//! The right side of the first-order system y' = f(t, y) of a model, with what the methods need to know of it.

use crate::Routine;
use program::{Model, NodeId};

/// f and, for stiff methods, its derivatives; counts its evaluations.
#[derive(Clone, Debug)]
pub(crate) struct Equations {
    rates: Routine,
    slopes: Option<Routine>,
    /// The parameters, and behind them the values at which switches are held.
    inputs: Vec<f64>,
    /// How often f was evaluated.
    pub evaluations: u64,
    /// How often the derivatives of f were evaluated.
    pub jacobians: u64,
}

impl Equations {
    /// f alone.
    pub fn new(model: &Model) -> Self {
        let rates = Routine::compile(model, &rate_nodes(model));
        Self { rates, slopes: None, inputs: Vec::new(), evaluations: 0, jacobians: 0 }
    }

    /// f with its exact derivatives by the states and by the independent variable; `None` if they are too many.
    pub fn with_slopes(model: &Model) -> Option<Self> {
        let (graph, roots) = model.slopes()?;
        let slopes = Routine::from_graph(&graph, model.states.len(), &roots);
        Some(Self { slopes: Some(slopes), ..Self::new(model) })
    }

    /// Sets parameters, the values at which switches are held ([`program::Held`]), and initial values.
    pub fn prepare(&mut self, parameters: &[f64], held: &[f64], initial: &[f64]) {
        self.inputs.clear();
        self.inputs.extend(parameters.iter().chain(held));
        self.rates.prepare(&self.inputs, initial);
        if let Some(slopes) = &mut self.slopes {
            slopes.prepare(&self.inputs, initial);
        }
    }

    /// f(time, state).
    #[inline]
    pub fn rates(&mut self, time: f64, state: &[f64], out: &mut [f64]) {
        self.evaluations += 1;
        self.rates.evaluate(time, state, out);
    }

    /// f at the state whose number `k` is `state(k)`.
    #[inline]
    pub fn rates_at(&mut self, time: f64, out: &mut [f64], state: impl Fn(usize) -> f64) {
        self.evaluations += 1;
        self.rates.evaluate_at(time, out, state);
    }

    /// The derivatives of f: first by each state, one column after the other, then by the independent variable.
    pub fn slopes(&mut self, time: f64, state: &[f64], out: &mut [f64]) {
        self.jacobians += 1;
        match &mut self.slopes {
            Some(slopes) => slopes.evaluate(time, state, out),
            None => out.fill(f64::NAN),
        }
    }

    /// About how many floating-point operations all evaluations took.
    pub fn work(&self) -> u64 {
        let slopes = self.slopes.as_ref().map_or(0, Routine::work);
        self.evaluations * self.rates.work() + self.jacobians * slopes
    }

    /// Whether the equations could not be solved for the highest derivatives when f was evaluated last.
    pub fn singular(&self) -> bool {
        self.rates.singular()
    }
}

fn rate_nodes(model: &Model) -> Vec<NodeId> {
    model.states.iter().map(|state| state.derivative).collect()
}
