//! Further searches around the answer. For a model with events or branches, the sum of squares has kinks and steps, and a
//! search by derivatives can stop at one of them far above the minimum. So further searches start around the answer, some
//! standard deviations away, where other minima that fit nearly as well lie. A lower result becomes the answer, and is
//! tested in the same way.

use super::Search;
use super::problem::Problem;
use super::start;
use super::window::{self, TRIALS, Window};
use crate::fit::linear::{Decomposition, dot, norm};
use crate::fit::task::Target;
use program::{Binary, Node, NodeId, Unary};
use serde::{Deserialize, Serialize};

/// Smoothness of the sum of squares.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Texture {
    /// Smooth.
    Smooth,
    /// With branches (`if`, `abs`, `sign` ...), which often make no kinks in the curve.
    Branches,
    /// With events.
    Events,
}

/// Walk away from an answer, along one number that acts on the events.
#[derive(Clone, Debug)]
struct Walk {
    /// Column of the number in the search.
    column: usize,
    /// Values still to be visited, the last one first: below and above the answer.
    values: [Vec<f64>; 2],
    /// One per side: the numbers at the end of the last search.
    at: [Vec<f64>; 2],
    /// Side of the present step.
    side: usize,
}

/// Starts around an answer.
#[derive(Clone, Debug)]
struct Around {
    /// Walk, made before the starts.
    walk: Option<Walk>,
    /// Starts still to be tried, the last one first.
    starts: Vec<Vec<f64>>,
    /// Sum of squares of the answer around which they lie.
    centre: f64,
    /// Number of searches that returned to the best answer.
    returned: usize,
}

/// Search around the answer.
#[derive(Clone, Debug)]
pub(in crate::fit) struct Beginning {
    /// Search at its start.
    pub search: Search,
    /// True if one number is held; after the search, [`Elsewhere::release`] continues without holding it.
    pub held: bool,
}

/// State of the searches around the answer.
#[derive(Clone, Debug)]
pub(in crate::fit) struct Elsewhere {
    /// Smoothness of the sum of squares.
    texture: Texture,
    /// Starts around the best answer.
    around: Option<Around>,
    /// Number of searches so far.
    tried: usize,
    /// Numbers and sum of squares at the end of each search.
    ends: Vec<(Vec<f64>, f64)>,
}

/// Another minimum that fits as well within the noise.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Rival {
    /// Sum of squares minus that of the best answer, in variances of a residual.
    pub growth: f64,
    /// Values of the varied numbers, SI, in the order of [`crate::fit::Outcome::parameters`].
    pub values: Vec<f64>,
}

impl Elsewhere {
    /// Upper bound of the searches: without events, and with them.
    const MOST: [usize; 2] = [30, 60];
    /// Distances of the walk to either side, in standard errors. Far apart, because a minimum with another number of
    /// oscillations can lie far away, and derivatives do not show the way there.
    const STEPS: [f64; 5] = [3.0, 6.0, 12.0, 24.0, 48.0];
    /// Upper bound of the trials with the number held.
    const TRIALS_HELD: usize = 10;
    /// Starts spread over a box around an answer.
    const BOX: usize = 16;
    /// Half the side of the box, in standard errors of each number.
    const BOX_SIZE: f64 = 6.0;
    /// Upper bound of the number of searches times the number of residuals.
    const VALUES: usize = 100_000;
    /// Upper bound of the trials of one search for equations of motion: a longer search creeps along a kink.
    const TRIALS_OF_MOTION: usize = 20;
    /// Number of returns to the best answer after which no better one is expected: without events, and with them.
    const RETURNED: [usize; 2] = [4, 6];
    /// Relative decrease of the sum of squares from which on starts around the new answer are tried.
    const MOVED: f64 = 1e-4;
    /// Sums of squares that differ by less than this part belong to the same answer or the same curve.
    const EQUAL: f64 = 1e-5;
    /// Directions in which the curve changes by less than this part of the greatest change are not tried.
    const VAGUE: f64 = 1e-8;
    /// A sum of squares below this part of the scatter cannot be improved.
    const NOTHING: f64 = 1e-12;
    /// Greatest growth of the sum of squares of a rival, in variances: two standard deviations of one number.
    const AS_WELL: f64 = 4.0;
    /// Least growth predicted by the linearised curve at a separate minimum, in variances: three standard deviations of one
    /// number.
    const APART: f64 = 9.0;

    /// State before the first search.
    pub fn new(problem: &Problem) -> Self {
        Self { texture: texture(problem), around: None, tried: 0, ends: Vec::new() }
    }

    /// True if the model has events.
    pub fn has_events(&self) -> bool {
        self.texture == Texture::Events
    }

    /// Next search around the answer, `None` after the last one.
    pub fn next(&mut self, problem: &mut Problem, best: &Search) -> Option<Beginning> {
        let most = Self::VALUES / best.residuals.len().max(1);
        let nothing = best.sum <= Self::NOTHING * problem.total;
        let most = most.clamp(Self::RETURNED[0], Self::MOST[usize::from(self.has_events())]);
        if nothing || self.texture == Texture::Smooth || self.tried >= most {
            return None;
        }
        let current = |known: &Around| best.sum >= known.centre * (1.0 - Self::MOVED);
        let mut known = match self.around.take().filter(current) {
            Some(known) => known,
            None => Self::around(problem, best),
        };
        let beginning = known.walk.as_mut().and_then(|walk| walk.step(problem)).or_else(|| {
            known.walk = None;
            let enough = known.returned >= Self::RETURNED[usize::from(self.has_events())];
            let start = if enough { None } else { known.starts.pop() };
            start.map(|start| Beginning { search: free(problem, &start), held: false })
        });
        self.around = Some(known);
        self.tried += usize::from(beginning.is_some());
        beginning
    }

    /// Continues from the end of a search with a held number, without holding it.
    pub fn release(&mut self, problem: &mut Problem, ended: &Search) -> Search {
        if let Some(walk) = self.around.as_mut().and_then(|known| known.walk.as_mut()).filter(|_| ended.sum.is_finite())
        {
            walk.at[walk.side].clone_from(&ended.x);
        }
        free(problem, &ended.x)
    }

    /// Records the end of a search over the whole fitted part. Call it before the best answer is updated.
    pub fn remember_end(&mut self, search: &Search, best: Option<&Search>) {
        if let (Some(best), Some(known)) = (best, &mut self.around) {
            let same = (search.sum - best.sum).abs() <= Self::EQUAL * best.sum;
            known.returned += usize::from(same && known.walk.is_none());
        }
        if search.sum.is_finite() {
            self.ends.push((search.x.clone(), search.sum));
        }
    }

    /// True if two searches have ended at the answer.
    pub fn is_confirmed(&self, best: &Search) -> bool {
        let same = |(_, sum): &&(Vec<f64>, f64)| (sum - best.sum).abs() <= Self::EQUAL * best.sum;
        self.ends.iter().filter(same).nth(1).is_some()
    }

    /// Lowest end of all searches so far in another minimum that fits as well within the noise.
    pub fn rival(&self, problem: &Problem, best: &Search) -> Option<Rival> {
        let variance = variance(problem, best);
        // Film scales are the last columns.
        let numbers = best.x.len() - problem.scales();
        let rival = |(x, sum): &(Vec<f64>, f64)| {
            let growth = (sum - best.sum) / variance;
            // Other numbers with an equal curve are no other minimum: terms of a sum have changed places.
            let same = *sum <= best.sum * (1.0 + Self::EQUAL);
            (growth <= Self::AS_WELL && !same && growth_at(best, x) > Self::APART * variance)
                .then(|| Rival { growth, values: x[..numbers].to_vec() })
        };
        self.ends.iter().filter_map(rival).min_by(|one, other| one.growth.total_cmp(&other.growth))
    }

    /// Searches around an answer, in this order: a walk along the worst determined of the numbers that act on the events;
    /// starts along the direction that the data determine worst; starts spread over a box of some standard errors of each
    /// number. The box is needed because derivatives beside a kink do not show the directions of the valleys.
    fn around(problem: &Problem, best: &Search) -> Around {
        let scale: Vec<f64> = (0..best.x.len()).map(|column| norm(best.jacobian.column(column))).collect();
        let free = |column: &usize| scale[*column] > 0.0 && problem.bounds[*column].0 < problem.bounds[*column].1;
        let columns: Vec<usize> = (0..scale.len()).filter(free).collect();
        let decomposition = Decomposition::new(&best.jacobian, &columns, &scale, &best.residuals);
        let least = Self::VAGUE * decomposition.greatest();
        let determined: Vec<usize> = (0..columns.len()).filter(|&k| decomposition.singular[k] > least).collect();
        let deviation = variance(problem, best).sqrt();
        // Change of the number at `place` for one standard deviation along direction k.
        let along = |k: usize, place: usize| {
            let size = scale[columns[place]] * decomposition.singular[k];
            deviation * decomposition.right[k * columns.len() + place] / size
        };
        let moved = |change: &dyn Fn(usize) -> f64| {
            let mut x = best.x.clone();
            columns.iter().enumerate().for_each(|(place, &column)| x[column] += change(place));
            x
        };
        let mut starts = Vec::new();
        let singular = |k: &usize| decomposition.singular[*k];
        if let Some(worst) = determined.iter().copied().min_by(|one, other| singular(one).total_cmp(&singular(other))) {
            let distances = [4.0, -4.0, 10.0, -10.0];
            starts.extend(distances.map(|distance| moved(&|place| distance * along(worst, place))));
        }
        let error = |place| norm(&determined.iter().map(|&k| along(k, place)).collect::<Vec<f64>>());
        starts
            .extend((0..Self::BOX).map(|index| {
                moved(&|place| Self::BOX_SIZE * (2.0 * start::halton(index, place) - 1.0) * error(place))
            }));
        starts.reverse();
        let kinks = kinks(problem);
        let inflated = |place: &usize| error(*place) * scale[columns[*place]];
        let walked = (0..columns.len())
            .filter(|&place| kinks[columns[place]])
            .max_by(|one, other| inflated(one).total_cmp(&inflated(other)));
        let walk = walked.map(|place| {
            let (column, error) = (columns[place], error(place));
            let values = [-error, error].map(|error| {
                let values = Self::STEPS.iter().rev().map(|step| best.x[column] + step * error);
                let (low, high) = problem.bounds[column];
                values.filter(|value| (low..=high).contains(value)).collect()
            });
            Walk { column, values, at: [best.x.clone(), best.x.clone()], side: 0 }
        });
        Around { walk, starts, centre: best.sum, returned: 0 }
    }
}

impl Walk {
    /// Search at the next value, starting from the other numbers reached on this side; `None` at the end.
    fn step(&mut self, problem: &mut Problem) -> Option<Beginning> {
        self.side = usize::from(self.values[0].len() < self.values[1].len());
        let value = self.values[self.side].pop()?;
        let mut start = self.at[self.side].clone();
        start[self.column] = value;
        let mut bounds = problem.bounds.clone();
        bounds[self.column] = (value, value);
        let plans = problem.plans.clone();
        let search = Window { problem, plans: &plans }.search_holding(&start, bounds, Elsewhere::TRIALS_HELD);
        Some(Beginning { search, held: true })
    }
}

/// Search with no number held.
fn free(problem: &mut Problem, start: &[f64]) -> Search {
    let limit = if problem.curve.has_states() { Elsewhere::TRIALS_OF_MOTION } else { TRIALS };
    window::search(problem, start, limit)
}

/// One per column: true if the condition of an event, or a value it sets, depends on it.
fn kinks(problem: &Problem) -> Vec<bool> {
    let model = &problem.model;
    let nodes = model.events.iter().flat_map(|event| {
        let set = event.actions.iter().map(|(_, value)| *value);
        set.chain([event.condition])
    });
    let parameters: Vec<u32> = nodes.flat_map(|node| model.depends(node).parameters).collect();
    let has_part = |target| matches!(target, Some(Target::Parameter(index)) if parameters.contains(&(index as u32)));
    problem.columns.iter().map(|column| has_part(column.target())).collect()
}

/// Variance of a residual: as given, or from the residuals if that is larger.
pub(in crate::fit) fn variance(problem: &Problem, best: &Search) -> f64 {
    let dof = (problem.independent_values() + problem.scales() as f64 - best.x.len() as f64).max(1.0);
    let shown = best.sum / dof;
    if problem.task.errors_given() { shown.max(1.0) } else { shown }
}

/// Growth of the sum of squares from the end of a search to `x`, predicted by the linearised curve.
pub(in crate::fit) fn growth_at(best: &Search, x: &[f64]) -> f64 {
    let mut change = vec![0.0; best.residuals.len()];
    for (column, (to, from)) in x.iter().zip(&best.x).enumerate() {
        change.iter_mut().zip(best.jacobian.column(column)).for_each(|(change, slope)| *change += (to - from) * slope);
    }
    dot(&change, &change)
}

/// Smoothness of the sum of squares, from the expressions of the model.
fn texture(problem: &Problem) -> Texture {
    let model = &problem.model;
    if !model.events.is_empty() {
        return Texture::Events;
    }
    let mut roots: Vec<NodeId> = problem.layout.expressions.clone();
    roots.extend(model.states.iter().flat_map(|state| [state.derivative, state.initial]));
    let varied =
        |index: &u32| problem.columns.iter().any(|column| column.target() == Some(Target::Parameter(*index as usize)));
    let branches = |id: &NodeId| {
        is_branch(model.graph.node(*id)) && {
            let dependence = model.depends(*id);
            dependence.varies() || !dependence.initial.is_empty() || dependence.parameters.iter().any(varied)
        }
    };
    if model.graph.reachable(&roots).iter().any(branches) { Texture::Branches } else { Texture::Smooth }
}

/// True if a function has a kink or a step, or takes one of several values.
fn is_branch(node: Node) -> bool {
    node.is_switch()
        || matches!(node, Node::Select(..) | Node::Unary(Unary::Not, _) | Node::Binary(Binary::And | Binary::Or, ..))
}
