//! The linear systems of a stiff method, d - J with a number d and the derivatives J of the rates of change: dense for small
//! models, banded where each rate depends on few states, as in chains and in diffusion.

use crate::banded::Banded;
use crate::bandwidth::{bandwidth, narrow_order};
use crate::linear::Factors;

/// How often a step solves with one factorization.
const SOLUTIONS: usize = 6;

/// A matrix d - J and its factors.
#[derive(Clone, Debug)]
pub(crate) struct Jacobian {
    matrix: Matrix,
    /// Where each derivative stands in the matrix.
    places: Vec<usize>,
}

#[derive(Clone, Debug)]
enum Matrix {
    Dense(Factors, usize),
    Banded {
        factors: Banded,
        /// The states in the order of the rows.
        order: Vec<usize>,
        /// Room for a right side in that order.
        right: Vec<f64>,
    },
}

impl Jacobian {
    /// Smaller systems are dense: their elimination takes the least time, and keeps its bits.
    const LEAST_BANDED: usize = 32;
    /// A dense matrix of more rows takes too much memory and time.
    const MOST_DENSE: usize = 1024;

    /// Room for a model of so many states; `pattern` has rate and state of every derivative.
    pub fn new(states: usize, pattern: &[(usize, usize)]) -> Self {
        if let Some(order) = banded_order(states, pattern) {
            let place = inverse(&order);
            let (lower, upper) = bandwidth(pattern, &place);
            let factors = Banded::new(states, lower, upper);
            let places = pattern.iter().map(|&(rate, state)| factors.place(place[rate], place[state])).collect();
            return Self { matrix: Matrix::Banded { factors, order, right: vec![0.0; states] }, places };
        }
        let places = pattern.iter().map(|&(rate, state)| rate * states + state).collect();
        Self { matrix: Matrix::Dense(Factors::new(states), states), places }
    }

    /// Whether there is room for it.
    pub fn fits(states: usize, pattern: &[(usize, usize)]) -> bool {
        states <= Self::MOST_DENSE || banded_order(states, pattern).is_some()
    }

    /// About how many floating-point operations a step takes.
    pub fn work(&self) -> u64 {
        match &self.matrix {
            Matrix::Dense(_, states) => (states * states * (2 * SOLUTIONS + states / 3)) as u64,
            Matrix::Banded { factors, .. } => factors.work(SOLUTIONS) as u64,
        }
    }

    /// Sets the matrix to `diagonal` minus the derivatives, in the order of the pattern, and factorizes it.
    pub fn factorize(&mut self, diagonal: f64, derivatives: &[f64]) {
        let values = match &mut self.matrix {
            Matrix::Dense(factors, states) => {
                factors.values.fill(0.0);
                factors.values.iter_mut().step_by(*states + 1).for_each(|value| *value = diagonal);
                &mut factors.values[..]
            }
            Matrix::Banded { factors, order, .. } => {
                factors.values_mut().fill(0.0);
                for row in 0..order.len() {
                    let place = factors.place(row, row);
                    factors.values_mut()[place] = diagonal;
                }
                factors.values_mut()
            }
        };
        for (&place, derivative) in self.places.iter().zip(derivatives) {
            values[place] -= derivative;
        }
        match &mut self.matrix {
            Matrix::Dense(factors, _) => factors.factorize(),
            Matrix::Banded { factors, .. } => factors.factorize(),
        }
    }

    /// Replaces the right side by the solution.
    pub fn solve(&mut self, values: &mut [f64]) {
        match &mut self.matrix {
            Matrix::Dense(factors, _) => factors.solve(values),
            Matrix::Banded { factors, order, right } => {
                right.iter_mut().zip(&*order).for_each(|(right, &state)| *right = values[state]);
                factors.solve(right);
                order.iter().zip(&*right).for_each(|(&state, right)| values[state] = *right);
            }
        }
    }
}

/// The order of the states in which the matrix is banded; `None` where a dense one takes less work.
fn banded_order(states: usize, pattern: &[(usize, usize)]) -> Option<Vec<usize>> {
    if states < Jacobian::LEAST_BANDED {
        return None;
    }
    let width = |order: &[usize]| {
        let (lower, upper) = bandwidth(pattern, &inverse(order));
        Banded::width(lower, upper)
    };
    let natural: Vec<usize> = (0..states).collect();
    let narrow = narrow_order(states, pattern);
    let order = if width(&natural) <= width(&narrow) { natural } else { narrow };
    (2 * width(&order) < states).then_some(order)
}

/// The place of each number.
fn inverse(order: &[usize]) -> Vec<usize> {
    let mut places = vec![0; order.len()];
    order.iter().enumerate().for_each(|(place, &number)| places[number] = place);
    places
}
