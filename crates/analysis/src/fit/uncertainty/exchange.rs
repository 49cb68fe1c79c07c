//! Two numbers that can exchange their values: two rates of a chain, two terms of a sum. At the end of a fit each pair of one
//! dimension is exchanged, the others follow, and the sums of squares are compared.

use crate::fit::search::Search;
use crate::fit::search::elsewhere::{growth_at, variance};
use crate::fit::search::problem::Problem;
use crate::fit::search::start;
use crate::fit::search::symmetry::sort;
use crate::fit::search::window::Window;
use crate::fit::task::plan::Plan;

/// The pairs that are tried.
#[derive(Clone, Debug)]
pub(in crate::fit) struct Exchange {
    /// Still to be tried.
    pairs: Vec<[usize; 2]>,
    /// The one that is tried at present.
    present: Option<[usize; 2]>,
    /// Those that give the same curve.
    pub found: Vec<[usize; 2]>,
}

impl Exchange {
    /// Pairs that are tried, at most.
    const MOST: usize = 6;
    /// Trials with a pair exchanged.
    const TRIALS: usize = 12;
    /// Sums of squares that differ by less than this part are those of one curve.
    const EQUAL: f64 = 1e-5;
    /// The same of a part of the rows, where the best numbers are others.
    const NEAR: f64 = 0.1;
    /// A sum below this part of the scatter is nothing but rounding.
    const NOTHING: f64 = 1e-18;
    /// The numbers of a pair differ if the sum of squares would grow by so many variances, were the curve proportional to them.
    const APART: f64 = 9.0;

    /// The pairs of one dimension on which the motion depends, `moving` by number of the search, or of a formula of those in which
    /// it is not linear.
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

    /// A search with the next pair exchanged, if there is one that may give the same curve.
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
            return Some(Window { problem, plans: &plans }.search_within(&start, bounds, Self::TRIALS));
        }
        None
    }

    /// True if a formula with an exchanged pair is near some of the values, so that it is worth a search.
    fn is_near(problem: &mut Problem, best: &Search, start: &[f64]) -> bool {
        let plans: Vec<Plan> = problem.plans.iter().map(start::thinned).collect();
        let nothing = Self::NOTHING * problem.total;
        let mut window = Window { problem, plans: &plans };
        let [of_best, exchanged] = [&best.x[..], start].map(|x| window.look(x).sum);
        exchanged <= of_best * (1.0 + Self::NEAR) + nothing
    }

    /// Takes in a search that has ended.
    pub fn settle(&mut self, problem: &Problem, best: &Search, ended: &Search) {
        let same = ended.sum <= best.sum * (1.0 + Self::EQUAL) + Self::NOTHING * problem.total;
        self.found.extend(self.present.take().filter(|_| same));
    }
}
