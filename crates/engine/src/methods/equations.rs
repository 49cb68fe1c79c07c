//! The right side of the first-order system y' = f(t, y) of a model, with what the methods need to know of it.

use crate::Routine;
use program::{Model, NodeId};

/// f and, for stiff methods, its derivatives; counts its evaluations.
#[derive(Clone, Debug)]
pub(crate) struct Equations {
    rates: Routine,
    slopes: Option<Routine>,
    /// The places of the derivatives by states: number of the rate, number of the state.
    pattern: Vec<(usize, usize)>,
    /// The order in which the routine takes the states, where it is another one than the model's.
    order: Option<Order>,
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

    /// f with its exact derivatives by the states and by the independent variable; `None` if they are too many.
    pub fn with_slopes(model: &Model) -> Option<Self> {
        let found = model.slopes()?;
        let roots: Vec<NodeId> =
            found.by_states.iter().map(|slope| slope.node).chain(found.by_independent.iter().copied()).collect();
        let slopes = Routine::from_graph(&found.graph, model.states.len(), &roots);
        let pattern = found.by_states.iter().map(|slope| (slope.rate as usize, slope.state as usize)).collect();
        Some(Self { slopes: Some(slopes), pattern, ..Self::new(model) })
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
        match &mut self.order {
            Some(Order { states, rates, .. }) => {
                let set = |registers: &mut [f64]| gather(registers, states, state);
                self.rates.evaluate_at(time, rates, set);
                scatter(out, states, rates);
            }
            None => self.rates.evaluate(time, state, out),
        }
    }

    /// f in the order of [`Equations::order`], at the state in that order that `set` writes.
    #[inline]
    pub fn ordered_rates(&mut self, time: f64, out: &mut [f64], set: impl FnOnce(&mut [f64])) {
        self.evaluations += 1;
        self.rates.evaluate_at(time, out, set);
    }

    /// The numbers of the states in the order in which f is computed fastest, if that is not the model's own.
    pub fn order(&self) -> Option<&[u32]> {
        self.order.as_ref().map(|order| order.states.as_slice())
    }

    /// Which derivatives by states are not 0 everywhere: the numbers of rate and state of each.
    pub fn pattern(&self) -> &[(usize, usize)] {
        &self.pattern
    }

    /// The derivatives of f: first by the states, in the order of [`Equations::pattern`], then of all by the independent
    /// variable.
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

/// Another order of the states.
#[derive(Clone, Debug)]
struct Order {
    /// Their numbers.
    states: Vec<u32>,
    /// Room for the rates of change in this order.
    rates: Vec<f64>,
}

impl Order {
    /// Models with fewer states are computed one by one.
    const LEAST_STATES: usize = 32;

    /// First all states of order 0, then those of order 1, and so on: what repeats then stands side by side.
    fn of(model: &Model) -> Option<Self> {
        let count = model.states.len();
        if count < Self::LEAST_STATES || model.states.iter().all(|state| state.order == 0) {
            return None;
        }
        let mut states: Vec<u32> = (0..count as u32).collect();
        states.sort_by_key(|&state| model.states[state as usize].order);
        Some(Self { states, rates: vec![0.0; count] })
    }
}

/// Writes `values` in another order, of which `order` has the numbers.
pub(crate) fn gather(out: &mut [f64], order: &[u32], values: &[f64]) {
    for (out, &number) in out.iter_mut().zip(order) {
        *out = values[number as usize];
    }
}

/// Takes [`gather`] back.
pub(crate) fn scatter(out: &mut [f64], order: &[u32], values: &[f64]) {
    for (value, &number) in values.iter().zip(order) {
        out[number as usize] = *value;
    }
}

fn rate_nodes(model: &Model) -> Vec<NodeId> {
    model.states.iter().map(|state| state.derivative).collect()
}
