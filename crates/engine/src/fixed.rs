//! The methods of fixed step.

use crate::Method;
use crate::equations::Equations;
use program::{Model, Node};

/// A method of fixed step and its working storage.
#[derive(Clone, Debug)]
pub(crate) struct Fixed {
    method: Method,
    rates: [Vec<f64>; 4],
    stage: Vec<f64>,
    /// For velocity Verlet, the states that are positions; behind each stands its velocity. The others rest.
    positions: Vec<usize>,
}

impl Fixed {
    pub fn new(method: Method, model: &Model) -> Self {
        let states = model.states.len();
        let positions =
            (1..states).filter(|&state| model.states[state].order == 1).map(|velocity| velocity - 1).collect();
        Self { method, rates: std::array::from_fn(|_| vec![0.0; states]), stage: vec![0.0; states], positions }
    }

    /// One step of `size` from the state `from` at `time`.
    #[inline]
    pub fn step(&mut self, equations: &mut Equations, time: f64, size: f64, from: &[f64], to: &mut [f64]) {
        match self.method {
            Method::Euler => self.euler(equations, time, size, from, to),
            Method::EulerRichardson => self.euler_richardson(equations, time, size, from, to),
            Method::VelocityVerlet => self.velocity_verlet(equations, time, size, from, to),
            // The adaptive methods never come here.
            Method::RungeKutta4 | Method::DormandPrince | Method::Rosenbrock => {
                self.runge_kutta(equations, time, size, from, to);
            }
        }
    }

    fn euler(&mut self, equations: &mut Equations, time: f64, size: f64, from: &[f64], to: &mut [f64]) {
        let [rates, ..] = &mut self.rates;
        equations.rates(time, from, rates);
        advance(to, from, size, rates);
    }

    /// The midpoint method, as in Gould, Tobochnik & Christian, An Introduction to Computer Simulation Methods (3rd ed.,
    /// chapter 3), where all states and not only the velocity go to the middle of the step first.
    fn euler_richardson(&mut self, equations: &mut Equations, time: f64, size: f64, from: &[f64], to: &mut [f64]) {
        let [first, middle, ..] = &mut self.rates;
        equations.rates(time, from, first);
        advance(&mut self.stage, from, 0.5 * size, first);
        equations.rates(time + 0.5 * size, &self.stage, middle);
        advance(to, from, size, middle);
    }

    /// Velocity Verlet (Swope et al., J. Chem. Phys. 76 (1982) 637). A force that depends on the velocity is evaluated at
    /// the end of the step with the predicted velocity v + h a, as by Groot & Warren (J. Chem. Phys. 107 (1997) 4423) with
    /// their lambda = 1: the prediction is off by O(h^2), the velocity after the step by O(h^3), so the order is still 2.
    fn velocity_verlet(&mut self, equations: &mut Equations, time: f64, size: f64, from: &[f64], to: &mut [f64]) {
        let [start, end, ..] = &mut self.rates;
        equations.rates(time, from, start);
        self.stage.copy_from_slice(from);
        for &position in &self.positions {
            let velocity = position + 1;
            let acceleration = start[velocity];
            self.stage[position] = from[position] + size * (from[velocity] + 0.5 * size * acceleration);
            self.stage[velocity] = from[velocity] + size * acceleration;
        }
        equations.rates(time + size, &self.stage, end);
        to.copy_from_slice(from);
        for &position in &self.positions {
            let velocity = position + 1;
            to[position] = self.stage[position];
            to[velocity] = from[velocity] + 0.5 * size * (start[velocity] + end[velocity]);
        }
    }

    /// The classical method of order 4 (Hairer, Norsett & Wanner, Solving Ordinary Differential Equations I, table II.1.2).
    fn runge_kutta(&mut self, equations: &mut Equations, time: f64, size: f64, from: &[f64], to: &mut [f64]) {
        let [k_1, k_2, k_3, k_4] = &mut self.rates;
        let half = 0.5 * size;
        let sixth = size / 6.0;
        let count = from.len();
        let (k_1, k_2, k_3, k_4) = (&mut k_1[..count], &mut k_2[..count], &mut k_3[..count], &mut k_4[..count]);
        equations.rates_at(time, k_1, |k| from[k]);
        equations.rates_at(time + half, k_2, |k| from[k] + half * k_1[k]);
        equations.rates_at(time + half, k_3, |k| from[k] + half * k_2[k]);
        equations.rates_at(time + size, k_4, |k| from[k] + size * k_3[k]);
        for (k, to) in to.iter_mut().enumerate() {
            *to = from[k] + sixth * (k_1[k] + 2.0 * k_2[k] + 2.0 * k_3[k] + k_4[k]);
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

/// The first state of a variable that does not have exactly two and does not rest between events either, which keeps
/// velocity Verlet from being used.
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
