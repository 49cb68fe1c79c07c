//! The right-hand side f of the first-order system y' = f(t, y) of a model, and its derivatives.

use crate::Routine;
use program::{Model, NodeId};
use units::order::sort_by_key;

/// The function f and, for stiff methods, its Jacobian; counts evaluations.
#[derive(Clone, Debug)]
pub(crate) struct Equations {
    rates: Routine,
    slopes: Option<Routine>,
    /// Sparsity pattern of the Jacobian: index of the rate, index of the state.
    pattern: Vec<(usize, usize)>,
    /// Order of the states in the routine, `None` if it is that of the model.
    order: Option<Order>,
    /// Parameters, then the held values of the switches.
    inputs: Vec<f64>,
    /// Number of evaluations of f.
    pub evaluations: u64,
    /// Number of evaluations of the derivatives of f.
    pub jacobians: u64,
}

impl Equations {
    /// The function f alone.
    pub fn new(model: &Model) -> Self {
        let nodes = rate_nodes(model);
        let order = Order::of(model);
        let rates = match &order {
            Some(Order { states, .. }) => {
                let nodes: Vec<NodeId> = states.iter().map(|&state| nodes[state as usize]).collect();
                Routine::with_order(&model.graph, states, &nodes)
            }
            None => Routine::compile(model, &nodes),
        };
        Self { rates, order, slopes: None, pattern: Vec::new(), inputs: Vec::new(), evaluations: 0, jacobians: 0 }
    }

    /// The function f with exact derivatives with respect to the states and the independent variable; `None` if there are
    /// too many.
    pub fn with_slopes(model: &Model) -> Option<Self> {
        let found = model.slopes()?;
        let roots: Vec<NodeId> =
            found.by_states.iter().map(|slope| slope.node).chain(found.by_independent.iter().copied()).collect();
        let slopes = Routine::from_graph(&found.graph, model.states.len(), &roots);
        let pattern = found.by_states.iter().map(|slope| (slope.rate as usize, slope.state as usize)).collect();
        Some(Self { slopes: Some(slopes), pattern, ..Self::new(model) })
    }

    /// Sets parameters, held values of the switches ([`program::Held`]) and initial values, SI units.
    pub fn prepare(&mut self, parameters: &[f64], held: &[f64], initial: &[f64]) {
        self.inputs.clear();
        self.inputs.extend(parameters.iter().chain(held));
        self.rates.prepare(&self.inputs, initial);
        if let Some(slopes) = &mut self.slopes {
            slopes.prepare(&self.inputs, initial);
        }
    }

    /// Evaluates f(time, state): one rate per state, SI units.
    #[inline]
    pub fn rates(&mut self, time: f64, state: &[f64], out: &mut [f64]) {
        self.evaluations += 1;
        match &mut self.order {
            Some(Order { states, rates, .. }) => {
                let set = |registers: &mut [f64]| gather(registers, states, state);
                self.rates.evaluate_at(time, rates, set);
                scatter(out, states, rates);
            }
            None => self.rates.evaluate(time, state, out),
        }
    }

    /// Evaluates f with states and rates in the order of [`Equations::order`]; `set` writes the state.
    #[inline]
    pub fn ordered_rates(&mut self, time: f64, out: &mut [f64], set: impl FnOnce(&mut [f64])) {
        self.evaluations += 1;
        self.rates.evaluate_at(time, out, set);
    }

    /// Indices of the states in the order in which f is computed fastest; `None` for the order of the model.
    pub fn order(&self) -> Option<&[u32]> {
        self.order.as_ref().map(|order| order.states.as_slice())
    }

    /// Sparsity pattern of the Jacobian: index of the rate and index of the state per entry.
    pub fn pattern(&self) -> &[(usize, usize)] {
        &self.pattern
    }

    /// Evaluates the derivatives of f: with respect to the states in the order of [`Equations::pattern`], then of all rates
    /// with respect to the independent variable. SI units.
    pub fn slopes(&mut self, time: f64, state: &[f64], out: &mut [f64]) {
        self.jacobians += 1;
        match &mut self.slopes {
            Some(slopes) => slopes.evaluate(time, state, out),
            None => out.fill(f64::NAN),
        }
    }

    /// Approximate number of floating-point operations of all evaluations.
    pub fn work(&self) -> u64 {
        let slopes = self.slopes.as_ref().map_or(0, Routine::work);
        self.evaluations * self.rates.work() + self.jacobians * slopes
    }

    /// True if the linear systems for the highest derivatives were singular at the last evaluation of f.
    pub fn singular(&self) -> bool {
        self.rates.singular()
    }
}

/// A permutation of the states.
#[derive(Clone, Debug)]
struct Order {
    /// Model indices of the states in the new order.
    states: Vec<u32>,
    /// Working storage for the rates in this order.
    rates: Vec<f64>,
}

impl Order {
    /// Minimum number of states for which a new order pays off.
    const LEAST_STATES: usize = 32;

    /// All states of order 0 first, then those of order 1, and so on: repeated operations then use consecutive registers.
    fn of(model: &Model) -> Option<Self> {
        let count = model.states.len();
        if count < Self::LEAST_STATES || model.states.iter().all(|state| state.order == 0) {
            return None;
        }
        let mut states: Vec<u32> = (0..count as u32).collect();
        sort_by_key(&mut states, |&state| model.states[state as usize].order);
        Some(Self { states, rates: vec![0.0; count] })
    }
}

/// Permutes `values`: element `k` of `out` is element `order[k]` of `values`.
pub(crate) fn gather(out: &mut [f64], order: &[u32], values: &[f64]) {
    for (out, &number) in out.iter_mut().zip(order) {
        *out = values[number as usize];
    }
}

/// Inverse of [`gather`].
pub(crate) fn scatter(out: &mut [f64], order: &[u32], values: &[f64]) {
    for (value, &number) in values.iter().zip(order) {
        out[number as usize] = *value;
    }
}

fn rate_nodes(model: &Model) -> Vec<NodeId> {
    model.states.iter().map(|state| state.derivative).collect()
}
