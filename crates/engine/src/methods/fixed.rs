//! Fixed-step methods.

use super::equations::{Equations, gather, scatter};
use crate::Method;
use program::{Model, Node};

/// A fixed-step method and its working storage.
#[derive(Clone, Debug)]
pub(crate) struct Fixed {
    method: Method,
    rates: [Vec<f64>; 4],
    stage: Vec<f64>,
    /// For velocity Verlet, pairs of the indices of a position and its velocity; all other states are constant.
    pairs: Vec<(usize, usize)>,
    /// Working storage: both ends of a step in the order of the equations.
    ends: [Vec<f64>; 2],
}

impl Fixed {
    /// Prepares the method for a model and its equations.
    pub fn new(method: Method, model: &Model, equations: &Equations) -> Self {
        let states = model.states.len();
        let mut places: Vec<usize> = (0..states).collect();
        if let Some(order) = equations.order() {
            order.iter().enumerate().for_each(|(place, &state)| places[state as usize] = place);
        }
        let velocities = (1..states).filter(|&state| model.states[state].order == 1);
        let pairs = velocities.map(|velocity| (places[velocity - 1], places[velocity])).collect();
        let zeros = vec![0.0; states];
        let ends = [zeros.clone(), zeros.clone()];
        Self { method, rates: std::array::from_fn(|_| zeros.clone()), stage: zeros, pairs, ends }
    }

    /// Makes one step of `size` from the state `from` at `time`; one value per state, SI units.
    #[inline]
    pub fn step(&mut self, equations: &mut Equations, time: f64, size: f64, from: &[f64], to: &mut [f64]) {
        if equations.step_compiled(self.stages(), time, size, from, to) {
            return;
        }
        if equations.order().is_none() {
            return self.ordered_step(equations, time, size, from, to);
        }
        let [mut start, mut end] = std::mem::take(&mut self.ends);
        gather(&mut start, equations.order().unwrap_or_default(), from);
        self.ordered_step(equations, time, size, &start, &mut end);
        scatter(to, equations.order().unwrap_or_default(), &end);
        self.ends = [start, end];
    }

    /// [`Fixed::step`] for searches within a step, compiled once.
    #[inline(never)]
    pub fn repeat(&mut self, equations: &mut Equations, time: f64, size: f64, from: &[f64], to: &mut [f64]) {
        self.step(equations, time, size, from, to);
    }

    /// Indices of each position and its velocity, for velocity Verlet; `order` as in [`Equations::order`].
    pub fn pairs(&self, order: Option<&[u32]>) -> Vec<(usize, usize)> {
        let state = |place: usize| order.map_or(place, |order| order[place] as usize);
        self.pairs.iter().map(|&(position, velocity)| (state(position), state(velocity))).collect()
    }

    /// Number of evaluations of the equations per step.
    pub fn stages(&self) -> u64 {
        match self.method {
            Method::Euler => 1,
            Method::EulerRichardson | Method::VelocityVerlet => 2,
            Method::RungeKutta4 | Method::DormandPrince | Method::Rosenbrock => 4,
        }
    }

    /// One step with the states in the order of the equations.
    #[inline]
    fn ordered_step(&mut self, equations: &mut Equations, time: f64, size: f64, from: &[f64], to: &mut [f64]) {
        match self.method {
            Method::Euler => self.euler(equations, time, size, from, to),
            Method::EulerRichardson => self.euler_richardson(equations, time, size, from, to),
            Method::VelocityVerlet => self.velocity_verlet(equations, time, size, from, to),
            // The adaptive methods are not handled here.
            Method::RungeKutta4 | Method::DormandPrince | Method::Rosenbrock => {
                self.runge_kutta(equations, time, size, from, to);
            }
        }
    }

    fn euler(&mut self, equations: &mut Equations, time: f64, size: f64, from: &[f64], to: &mut [f64]) {
        let [rates, ..] = &mut self.rates;
        equations.ordered_rates(time, rates, |state| state.copy_from_slice(from));
        advance(to, from, size, rates);
    }

    /// The midpoint method, as in Gould, Tobochnik & Christian, An Introduction to Computer Simulation Methods (3rd ed.,
    /// chapter 3), with all states, not only the velocity, evaluated at the middle of the step.
    fn euler_richardson(&mut self, equations: &mut Equations, time: f64, size: f64, from: &[f64], to: &mut [f64]) {
        let [first, middle, ..] = &mut self.rates;
        equations.ordered_rates(time, first, |state| state.copy_from_slice(from));
        equations.ordered_rates(time + 0.5 * size, middle, |state| advance(state, from, 0.5 * size, first));
        advance(to, from, size, middle);
    }

    /// Velocity Verlet (Swope et al., J. Chem. Phys. 76 (1982) 637). A force that depends on the velocity is evaluated at
    /// the end of the step with the predicted velocity v + h a, as by Groot & Warren (J. Chem. Phys. 107 (1997) 4423) with
    /// lambda = 1. The error of the prediction is O(h^2), that of the velocity after the step O(h^3), so the order remains
    /// 2.
    fn velocity_verlet(&mut self, equations: &mut Equations, time: f64, size: f64, from: &[f64], to: &mut [f64]) {
        let [start, end, ..] = &mut self.rates;
        equations.ordered_rates(time, start, |state| state.copy_from_slice(from));
        self.stage.copy_from_slice(from);
        for &(position, velocity) in &self.pairs {
            let acceleration = start[velocity];
            self.stage[position] = from[position] + size * (from[velocity] + 0.5 * size * acceleration);
            self.stage[velocity] = from[velocity] + size * acceleration;
        }
        equations.ordered_rates(time + size, end, |state| state.copy_from_slice(&self.stage));
        to.copy_from_slice(from);
        for &(position, velocity) in &self.pairs {
            to[position] = self.stage[position];
            to[velocity] = from[velocity] + 0.5 * size * (start[velocity] + end[velocity]);
        }
    }

    /// Classical Runge-Kutta method of order 4 (Hairer, Norsett & Wanner, Solving Ordinary Differential Equations I, table
    /// II.1.2).
    fn runge_kutta(&mut self, equations: &mut Equations, time: f64, size: f64, from: &[f64], to: &mut [f64]) {
        let [k_1, k_2, k_3, k_4] = &mut self.rates;
        let half = 0.5 * size;
        let sixth = size / 6.0;
        equations.ordered_rates(time, k_1, |state| state.copy_from_slice(from));
        equations.ordered_rates(time + half, k_2, |state| advance(state, from, half, k_1));
        equations.ordered_rates(time + half, k_3, |state| advance(state, from, half, k_2));
        equations.ordered_rates(time + size, k_4, |state| advance(state, from, size, k_3));
        let rates = k_1.iter().zip(k_2.iter()).zip(k_3.iter()).zip(k_4.iter());
        for ((to, from), (((k_1, k_2), k_3), k_4)) in to.iter_mut().zip(from).zip(rates) {
            *to = from + sixth * (k_1 + 2.0 * k_2 + 2.0 * k_3 + k_4);
        }
    }
}

/// to = from + size * rates
#[inline]
fn advance(to: &mut [f64], from: &[f64], size: f64, rates: &[f64]) {
    for ((to, from), rate) in to.iter_mut().zip(from).zip(rates) {
        *to = from + size * rate;
    }
}

/// First state that velocity Verlet cannot integrate: its variable does not have exactly two states and is not constant
/// between events.
pub(crate) fn not_of_second_order(model: &Model) -> Option<usize> {
    let states = &model.states;
    let mut position = 0;
    while position < states.len() {
        let velocity = position + 1;
        let alone = states.get(velocity).is_none_or(|state| state.order == 0);
        if alone && model.graph.as_constant(states[position].derivative) == Some(0.0) {
            position += 1;
            continue;
        }
        let paired = states[position].order == 0
            && states.get(velocity).is_some_and(|state| state.order == 1)
            && states.get(velocity + 1).is_none_or(|state| state.order == 0)
            && model.graph.node(states[position].derivative) == Node::State(velocity as u32);
        if !paired {
            return Some(position);
        }
        position += 2;
    }
    None
}
