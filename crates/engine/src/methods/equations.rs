//! The right-hand side f of the first-order system y' = f(t, y) of a model, and its derivatives.

use super::tableau::STAGES;
use crate::code::instruction::Register;
use crate::compiled::Compiled;
use crate::compiled::block::Block;
use crate::compiled::layout::Layout;
use crate::compiled::listing::{Interpreted, Listing, Preparation};
use crate::compiled::window::{Taken, Window};
use crate::compiled::window_layout::WindowLayout;
use crate::{Method, Routine};
use program::{Model, NodeId};
use std::rc::Rc;
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
    /// Steps of a fixed-step method in compiled form, if there are any.
    compiled: Option<Block>,
    /// Steps of the Dormand-Prince method in compiled form, if there are any.
    pub window: Option<Window>,
    /// The rate of each state if that is the constant 0 or -0.
    still: Vec<Option<f64>>,
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
        let still = nodes.iter().map(|&node| model.graph.as_constant(node).filter(|rate| *rate == 0.0)).collect();
        let rates = match &order {
            Some(Order { states, .. }) => {
                let nodes: Vec<NodeId> = states.iter().map(|&state| nodes[state as usize]).collect();
                Routine::with_order(&model.graph, states, &nodes)
            }
            None => Routine::compile(model, &nodes),
        };
        Self {
            rates,
            order,
            slopes: None,
            pattern: Vec::new(),
            inputs: Vec::new(),
            compiled: None,
            window: None,
            still,
            evaluations: 0,
            jacobians: 0,
        }
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
        if let Some(block) = &mut self.compiled {
            block.load(self.rates.registers());
        }
        if let Some(window) = &mut self.window {
            window.load(self.rates.registers());
        }
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

    /// Where f reads the state, one value per state, SI units; `None` if it has another order there.
    pub fn state_mut(&mut self) -> Option<&mut [f64]> {
        self.order.is_none().then(|| self.rates.state_mut())
    }

    /// [`Equations::rates`] at the state written to [`Equations::state_mut`], or else at `state`.
    // Not inlined: a method calls it for each of its stages.
    #[inline(never)]
    pub fn rates_at_written(&mut self, time: f64, state: &[f64], out: &mut [f64]) {
        if self.order.is_none() {
            self.ordered_rates(time, out, |_| ());
        } else {
            self.rates(time, state, out);
        }
    }

    /// Evaluates f at `time` (SI) with states and rates in the order of [`Equations::order`]; `set` writes the state.
    #[inline]
    pub fn ordered_rates(&mut self, time: f64, out: &mut [f64], set: impl FnOnce(&mut [f64])) {
        self.evaluations += 1;
        self.rates.evaluate_at(time, out, set);
    }

    /// Indices of the states in the order in which f is computed fastest; `None` for the order of the model.
    pub fn order(&self) -> Option<&[u32]> {
        self.order.as_ref().map(|order| order.states.as_slice())
    }

    /// Preparation of the operations of the listing; `None` if it solves linear systems.
    pub fn preparation(&self) -> Option<Preparation> {
        self.rates.preparation(0)
    }

    /// The right-hand side for a compiler, with the pairs of states of velocity Verlet.
    pub fn listing(&self, method: Method, pairs: Vec<(usize, usize)>) -> Result<Listing, Interpreted> {
        let lines = self.rates.lines().ok_or(Interpreted::LinearSystem)?;
        let count = self.rates.len();
        let (mut states, mut rates): (Vec<Register>, Vec<Register>) = ((1..).take(count).collect(), Vec::new());
        match &self.order {
            Some(Order { states: order, .. }) => {
                rates.resize(count, 0);
                for (place, &state) in order.iter().enumerate() {
                    states[state as usize] = 1 + place as Register;
                    rates[state as usize] = self.rates.roots()[place];
                }
            }
            None => rates.extend(self.rates.roots()),
        }
        let interpolations = self.rates.interpolations().to_vec();
        let (layout, still) = (self.layout(), self.still.clone());
        Ok(Listing { method, lines, states, rates, pairs, interpolations, still, layout, window: None })
    }

    fn layout(&self) -> Layout {
        let rows = (WORK_AHEAD / self.rates.work().max(1)).clamp(1, MOST_ROWS) as usize;
        Layout { registers: self.rates.registers().len(), states: self.rates.len(), rows }
    }

    /// Makes steps of a fixed-step method with code compiled from its listing from now on.
    pub fn use_compiled(&mut self, code: Rc<dyn Compiled>) {
        let mut block = Block::new(code, self.layout());
        block.load(self.rates.registers());
        self.compiled = Some(block);
    }

    /// Makes steps of the Dormand-Prince method with code compiled from its listing from now on. `layout` is that of the
    /// listing; `checks` is true if its formulas are those of all that could happen.
    pub fn use_window(&mut self, code: Rc<dyn Compiled>, layout: WindowLayout, checks: bool) {
        let mut window = Window::new(code, layout, checks, &self.still);
        window.load(self.rates.registers());
        self.window = Some(window);
    }

    /// Number of interpolations of the right-hand side.
    pub fn interpolations(&self) -> usize {
        self.rates.interpolations().len()
    }

    /// Number of states and of registers of the right-hand side.
    pub fn size(&self) -> (usize, usize) {
        (self.rates.len(), self.rates.registers().len())
    }

    /// Counts the evaluations of steps that were computed in advance.
    pub fn count(&mut self, taken: Taken) {
        self.evaluations += taken.stages();
    }

    /// Approximate number of floating-point operations of these evaluations.
    pub fn work_of(&self, taken: Taken) -> u64 {
        self.work_of_stages(taken.stages())
    }

    /// Approximate number of floating-point operations of so many evaluations.
    pub fn work_of_stages(&self, stages: u64) -> u64 {
        stages * self.rates.work()
    }

    /// Registers of f.
    pub fn registers(&self) -> &[f64] {
        self.rates.registers()
    }

    /// True if there are steps of a fixed-step method in compiled form.
    pub fn is_compiled(&self) -> bool {
        self.compiled.is_some()
    }

    /// Makes one step of a fixed-step method with `stages` evaluations of f in compiled form. False if there is none.
    #[inline]
    pub fn step_compiled(&mut self, stages: u64, time: f64, size: f64, from: &[f64], to: &mut [f64]) -> bool {
        let Some(block) = &mut self.compiled else { return false };
        self.evaluations += stages;
        block.step(time, size, from, to);
        true
    }

    /// Moves the state from grid point `index` to the next one by a step of a fixed-step method that compiled code has made in
    /// advance. False if there is none.
    #[inline(always)]
    pub fn take_row(&mut self, index: u64, state: &mut [f64]) -> bool {
        let Some(block) = &mut self.compiled else { return false };
        let stages = block.take_row(index, state);
        self.evaluations += stages;
        stages > 0
    }

    /// Makes steps of a fixed-step method with `stages` evaluations of f from grid point `index` on in advance, if they are in
    /// compiled form. They end before a state that is not finite.
    pub fn begin_rows(&mut self, stages: u64, index: u64, step: f64, state: &[f64]) {
        if let Some(block) = &mut self.compiled {
            block.begin(stages, index, step, state);
        }
    }

    /// Discards steps of a fixed-step method that were made in advance.
    pub fn forget_rows(&mut self) {
        if let Some(block) = &mut self.compiled {
            block.forget();
        }
    }

    /// Makes an attempt of a step of the Dormand-Prince method in compiled form. `rates`: those of the first stage,
    /// which are given, and those of the last one. False if there is no compiled form.
    #[inline]
    pub fn attempt_compiled(
        &mut self,
        time: f64,
        size: f64,
        from: &[f64],
        to: &mut [f64],
        error: &mut [f64],
        rates: [&mut [f64]; 2],
    ) -> bool {
        let Some(window) = &mut self.window else { return false };
        self.evaluations += STAGES as u64 - 1;
        window.attempt([time, size], from, to, error, rates);
        true
    }

    /// Coefficients of the continuous solution over the step of the last attempt, from the state `from`, in compiled form.
    /// False if there is no compiled form.
    #[inline]
    pub fn dense_compiled(&self, from: &[f64], coefficients: &mut [Vec<f64>; 5]) -> bool {
        let Some(window) = &self.window else { return false };
        window.dense(from, coefficients);
        true
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

/// Maximum number of steps that compiled code computes in advance.
const MOST_ROWS: u64 = 256;
/// Maximum number of floating-point operations of the right-hand side in these steps, counted once per step: a change of a
/// parameter discards them.
const WORK_AHEAD: u64 = 20_000;

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
