//! Solutions of the equations of a fit side by side, on all processors.

use analysis::fit::{Lanes, Solution, Sought};
use engine::Setup;
use ensemble::Solutions;
use program::{Model, NodeId};
use rayon::prelude::*;
use std::cell::RefCell;
use std::rc::Rc;

/// Least number of solutions that one thread computes side by side.
const LEAST: usize = 8;

/// Solver of the equations of a fit.
#[derive(Debug)]
struct Threads {
    /// One solver per thread.
    solvers: Vec<Solutions>,
    /// Number of values that are read at each time.
    readings: usize,
}

/// Solver for `model` with the setup of its runs, `readings` evaluated at each time; `None` if the runs must be computed one by one.
pub fn lanes(model: &Model, setup: &Setup, readings: &[NodeId]) -> Option<Rc<RefCell<dyn Lanes>>> {
    let solver = Solutions::new(model, setup, readings).ok()?;
    let solvers = vec![solver; rayon::current_num_threads()];
    Some(Rc::new(RefCell::new(Threads { solvers, readings: readings.len() })))
}

impl Lanes for Threads {
    fn solve(&mut self, tolerance: f64, sought: &[Sought]) -> Vec<Option<Solution>> {
        let share = sought.len().div_ceil(self.solvers.len()).next_multiple_of(LEAST);
        let readings = self.readings;
        let shares = sought.par_chunks(share).zip(&mut self.solvers);
        shares.flat_map_iter(|(sought, solver)| solve(solver, readings, tolerance, sought)).collect()
    }
}

fn solve(solver: &mut Solutions, readings: usize, tolerance: f64, sought: &[Sought]) -> Vec<Option<Solution>> {
    let mut solutions = Vec::with_capacity(sought.len());
    for sought in sought.chunks(solver.lanes()) {
        let mut values: Vec<Vec<f64>> = sought.iter().map(|sought| vec![0.0; readings * sought.times.len()]).collect();
        let asked: Vec<ensemble::Sought> =
            (sought.iter()).map(|Sought { parameters, times }| ensemble::Sought { parameters, times }).collect();
        let solved = solver.solve(tolerance, &asked, &mut |lane, row, read| {
            let rows = sought[lane].times.len();
            values[lane].chunks_exact_mut(rows).zip(read).for_each(|(column, value)| column[row] = *value);
        });
        solutions.extend(solved.into_iter().zip(values).map(|(work, values)| Some(Solution { values, work: work? })));
    }
    solutions
}
