//! Pairs of numbers that can exchange their values: two rates of a chain, two terms of a sum. At the end of a fit each pair
//! of equal dimension is exchanged, the other numbers are fitted again, and the sums of squares are compared.

use crate::fit::search::Search;
use crate::fit::search::elsewhere::{growth_at, variance};
use crate::fit::search::problem::Problem;
use crate::fit::search::start;
use crate::fit::search::symmetry::sort;
use crate::fit::search::window::Window;
use crate::fit::task::plan::Plan;

/// Pairs under test.
#[derive(Clone, Debug)]
pub(in crate::fit) struct Exchange {
    /// Pairs still to be tried.
    pairs: Vec<[usize; 2]>,
    /// Pair under test at present.
    present: Option<[usize; 2]>,
    /// Pairs that give the same curve.
    pub found: Vec<[usize; 2]>,
}

impl Exchange {
    /// Upper bound of the number of pairs.
    const MOST: usize = 6;
    /// Upper bound of the trials with a pair exchanged.
    const TRIALS: usize = 12;
    /// Sums of squares that differ by less than this part belong to the same curve.
    const EQUAL: f64 = 1e-5;
    /// Tolerance like `EQUAL` for a part of the rows, where the best numbers differ.
    const NEAR: f64 = 0.1;
    /// A sum below this part of the scatter is rounding.
    const NOTHING: f64 = 1e-18;
    /// The two numbers differ if exchanging them in the linearised curve increases the sum of squares by more than this
    /// many variances.
    const APART: f64 = 9.0;

    /// Pairs of equal dimension. For equations of motion: numbers marked in `moving`, one entry per column. For a formula:
    /// numbers in which it is not linear.
    pub fn new(problem: &Problem, moving: &[bool]) -> Self {
        let linear = problem.linear_columns();
        let motion = problem.curve.has_states();
        let numbers = problem.own.len() - problem.scales();
        let takes_part = |column: &usize| {
            let moves = moving.get(*column).is_some_and(|moves| *moves);
            !linear.contains(column) && moves == motion && sort(problem, *column).0.is_some()
        };
        let columns: Vec<usize> = (0..numbers).filter(takes_part).collect();
        let all = columns.iter().enumerate().flat_map(|(place, &a)| columns[place + 1..].iter().map(move |&b| [a, b]));
        let pairs = all.filter(|[a, b]| sort(problem, *a) == sort(problem, *b)).take(Self::MOST).collect();
        Self { pairs, present: None, found: Vec::new() }
    }

    /// Search with the next pair exchanged, if one may give the same curve.
    pub fn next(&mut self, problem: &mut Problem, best: &Search) -> Option<Search> {
        while let Some([a, b]) = self.pairs.pop() {
            let mut start = best.x.clone();
            start.swap(a, b);
            let mut bounds = problem.bounds.clone();
            let inside = |column: usize| (bounds[column].0..=bounds[column].1).contains(&start[column]);
            let apart = growth_at(best, &start) > Self::APART * variance(problem, best);
            if !(inside(a)
                && inside(b)
                && apart
                && (problem.curve.has_states() || Self::is_near(problem, best, &start)))
            {
                continue;
            }
            [a, b].into_iter().for_each(|column| bounds[column] = (start[column], start[column]));
            self.present = Some([a, b]);
            let plans = problem.plans.clone();
            return Some(Window { problem, plans: &plans }.search_holding(&start, bounds, Self::TRIALS));
        }
        None
    }

    /// True if a formula with an exchanged pair fits a thinned set of values nearly as well, so that a search is
    /// worthwhile.
    fn is_near(problem: &mut Problem, best: &Search, start: &[f64]) -> bool {
        let plans: Vec<Plan> = problem.plans.iter().map(start::thinned).collect();
        let nothing = Self::NOTHING * problem.total;
        let mut window = Window { problem, plans: &plans };
        let [of_best, exchanged] = [&best.x[..], start].map(|x| window.look(x).sum);
        exchanged <= of_best * (1.0 + Self::NEAR) + nothing
    }

    /// Takes the result of a search with an exchanged pair.
    pub fn settle(&mut self, problem: &Problem, best: &Search, ended: &Search) {
        let same = ended.sum <= best.sum * (1.0 + Self::EQUAL) + Self::NOTHING * problem.total;
        self.found.extend(self.present.take().filter(|_| same));
    }
}
