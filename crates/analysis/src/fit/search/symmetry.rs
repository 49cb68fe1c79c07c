//! Equivalent answers of a symmetric formula: two terms of a sum may change places, a width may be negative. The answer
//! with signs and order like those of the start is returned.

use super::Search;
use super::problem::Problem;
use super::window;
use crate::fit::task::Target;
use units::Dimension;

/// Sums of squares that differ by less than this part are equal.
const EQUAL: f64 = 1e-6;
/// Sums of squares below this part of the scatter of the data are equal.
const NOTHING: f64 = 1e-20;
/// Upper bound of the exchanges tried.
const TRIES: usize = 60;

/// Numbers that fit as well as `best`, with signs and order more like those of the start; `None` if these do not differ.
pub(crate) fn like_start(problem: &mut Problem, best: &Search) -> Option<Vec<f64>> {
    let own = problem.own.clone();
    let linear = problem.linear_columns();
    // Film scales are the last columns.
    let numbers = own.len() - problem.scales();
    let others: Vec<usize> = (0..numbers).filter(|column| !linear.contains(column)).collect();
    let mut x = best.x.clone();
    for &column in &others {
        if x[column] * own[column] < 0.0 {
            let mut turned = x.clone();
            turned[column] = -x[column];
            x = equal(problem, best, turned).unwrap_or(x);
        }
    }
    // A term may have several numbers, which are adjacent and exchanged together.
    let mut tries = 0;
    for length in 1..=others.len() / 2 {
        for first in 0..others.len() {
            for second in first + length..=others.len() - length {
                let (a, b) = (others[first], others[second]);
                if (x[a] - x[b]) * (own[a] - own[b]) >= 0.0 {
                    continue;
                }
                let mut exchanged = x.clone();
                let unchanged = (0..length).all(|place| {
                    let (a, b) = (others[first + place], others[second + place]);
                    exchanged.swap(a, b);
                    sort(problem, a) == sort(problem, b)
                });
                if unchanged && tries < TRIES {
                    tries += 1;
                    x = equal(problem, best, exchanged).unwrap_or(x);
                }
            }
        }
    }
    (x != best.x).then_some(x)
}

/// `x` with the linear numbers at their best values, if it fits as well as `best`.
fn equal(problem: &mut Problem, best: &Search, x: Vec<f64>) -> Option<Vec<f64>> {
    let search = window::look(problem, &x);
    let as_good = search.sum <= best.sum * (1.0 + EQUAL) || search.sum <= NOTHING * problem.total;
    as_good.then_some(search.x)
}

/// Key that must be equal for two numbers that may change places: the dimension of the unit, and the record.
pub(in crate::fit) fn sort(problem: &Problem, column: usize) -> (Option<Dimension>, Option<usize>) {
    let column = problem.columns[column];
    let dimension = match column.target() {
        Some(Target::Parameter(index)) => problem.model.parameters.get(index).map(|parameter| parameter.unit.dimension),
        Some(Target::Origin | Target::Offset(_)) | None => None,
    };
    (dimension, column.record)
}
