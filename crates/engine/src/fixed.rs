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
}

impl Fixed {
    pub fn new(method: Method, states: usize) -> Self {
        Self { method, rates: std::array::from_fn(|_| vec![0.0; states]), stage: vec![0.0; states] }
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
        // The states alternate: position, velocity.
        for ((stage, from), start) in
            self.stage.chunks_exact_mut(2).zip(from.chunks_exact(2)).zip(start.chunks_exact(2))
        {
            let ([x, v], [x_0, v_0], [_, a]) = (stage, from, start) else {
                continue;
            };
            *x = *x_0 + size * (*v_0 + 0.5 * size * *a);
            *v = *v_0 + size * *a;
        }
        equations.rates(time + size, &self.stage, end);
        for (k, value) in to.iter_mut().enumerate() {
            *value = if k % 2 == 0 { self.stage[k] } else { from[k] + 0.5 * size * (start[k] + end[k]) };
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

/// The first state of a variable that does not have exactly two, which keeps velocity Verlet from being used.
pub(crate) fn not_of_second_order(model: &Model) -> Option<usize> {
    let states = &model.states;
    let mut position = 0;
    while position < states.len() {
        let velocity = position + 1;
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
