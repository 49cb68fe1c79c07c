//! Searches from elsewhere. Where a model has events or branches, the sum of squares has kinks and steps, and a search by
//! derivatives can stop at one of them far above the least value. Such a fit is therefore tried again from starts around its
//! answer, some standard deviations away, where the other minima lie that fit nearly as well. Whatever ends lower becomes the
//! answer, and is tried in the same way.

use super::Search;
use super::problem::Problem;
use super::start;
use super::window::{self, TRIALS, Window};
use crate::fit::linear::{Decomposition, dot, norm};
use crate::fit::task::Target;
use program::{Binary, Node, NodeId, Unary};

/// How the sum of squares depends on the numbers of the search.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Texture {
    /// Smoothly.
    Smooth,
    /// With branches (`if`, `abs`, `sign` ...), which often make no kinks in the curve.
    Branches,
    /// With events.
    Events,
}

/// A walk away from an answer, along one number that has a part in the events.
#[derive(Clone, Debug)]
struct Walk {
    /// Which number of the search.
    column: usize,
    /// Its values still to be visited, the last one first: to one side, and to the other.
    values: [Vec<f64>; 2],
    /// By side: the numbers where it has come to.
    at: [Vec<f64>; 2],
    /// The side to which it goes at present.
    side: usize,
}

/// Starts around an answer.
#[derive(Clone, Debug)]
struct Around {
    /// Walked first.
    walk: Option<Walk>,
    /// Still to be tried, the last one first.
    starts: Vec<Vec<f64>>,
    /// The sum of squares of the answer around which they lie.
    centre: f64,
    /// How many searches have come back to the best answer.
    returned: usize,
}

/// A search from elsewhere.
#[derive(Clone, Debug)]
pub(in crate::fit) struct Beginning {
    /// The search.
    pub search: Search,
    /// Whether one number is held; where the search has ended, [`Elsewhere::release`] goes on from there.
    pub held: bool,
}

/// What was tried elsewhere, and is to be tried.
#[derive(Clone, Debug)]
pub(in crate::fit) struct Elsewhere {
    /// How smooth the sum of squares is.
    texture: Texture,
    /// Starts around the best answer.
    around: Option<Around>,
    /// How many of them have been tried.
    tried: usize,
    /// Where the searches from all starts have ended, and how high.
    ends: Vec<(Vec<f64>, f64)>,
}

/// Another minimum that fits as well within the noise.
#[derive(Clone, Debug, PartialEq)]
pub struct Rival {
    /// By how much its sum of squares is larger, in variances of a residual.
    pub growth: f64,
    /// What was varied, in the order of [`crate::fit::Outcome::parameters`].
    pub values: Vec<f64>,
}

impl Elsewhere {
    /// Searches from elsewhere, at most: without events, and with them.
    const MOST: [usize; 2] = [30, 60];
    /// How far a number is walked to either side, in standard errors. Where the number of swings is another one, the derivatives
    /// tell little of the way there.
    const STEPS: [f64; 5] = [3.0, 6.0, 12.0, 24.0, 48.0];
    /// Trials with that number held.
    const TRIALS_HELD: usize = 10;
    /// Starts spread over a box around an answer.
    const BOX: usize = 16;
    /// Half the side of the box, in standard errors of each number.
    const BOX_SIZE: f64 = 6.0;
    /// And at most so many of the whole record times its values.
    const VALUES: usize = 100_000;
    /// Trials of one of them, for equations of motion: one that takes longer creeps along a kink.
    const TRIALS_OF_MOTION: usize = 20;
    /// If so many of them have come back to the best answer, there is hardly a better one: without events, and with them.
    const RETURNED: [usize; 2] = [4, 6];
    /// Where a search ends lower by this part of the sum of squares, starts around the new answer are tried.
    const MOVED: f64 = 1e-4;
    /// Sums of squares that differ by less than this part are those of one answer, or of one curve.
    const EQUAL: f64 = 1e-5;
    /// A direction in which the curve changes by less than this part of the greatest change is no direction to try.
    const VAGUE: f64 = 1e-8;
    /// A start that explains all but this part of the scatter leaves nothing to be found.
    const NOTHING: f64 = 1e-12;
    /// Another minimum fits as well if its sum of squares is larger by less than this many variances: two standard
    /// deviations of one number.
    const AS_WELL: f64 = 4.0;
    /// It is another one if the sum of squares would have to be larger by more than this many variances where it lies, were
    /// there only one: three standard deviations of one number.
    const APART: f64 = 9.0;

    /// Nothing was tried yet.
    pub fn new(problem: &Problem) -> Self {
        Self { texture: texture(problem), around: None, tried: 0, ends: Vec::new() }
    }

    /// Whether the model has events.
    pub fn has_events(&self) -> bool {
        self.texture == Texture::Events
    }

    /// The next search from elsewhere, if one is to be tried.
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

    /// Goes on from where a search with a held number has ended, without holding it.
    pub fn release(&mut self, problem: &mut Problem, ended: &Search) -> Search {
        if let Some(walk) = self.around.as_mut().and_then(|known| known.walk.as_mut()).filter(|_| ended.sum.is_finite())
        {
            walk.at[walk.side].clone_from(&ended.x);
        }
        free(problem, &ended.x)
    }

    /// Remembers where a search of the whole has ended, before its answer is taken as the best or not.
    pub fn remember_end(&mut self, search: &Search, best: Option<&Search>) {
        if let (Some(best), Some(known)) = (best, &mut self.around) {
            let same = (search.sum - best.sum).abs() <= Self::EQUAL * best.sum;
            known.returned += usize::from(same && known.walk.is_none());
        }
        if search.sum.is_finite() {
            self.ends.push((search.x.clone(), search.sum));
        }
    }

    /// Of all searches so far, the one that has ended lowest in another minimum that fits as well within the noise.
    pub fn rival(&self, problem: &Problem, best: &Search) -> Option<Rival> {
        let variance = variance(problem, best);
        // Scales come last.
        let numbers = best.x.len() - problem.scales();
        let rival = |(x, sum): &(Vec<f64>, f64)| {
            let growth = (sum - best.sum) / variance;
            // The same curve from other numbers is no other minimum: terms of a sum have changed places.
            let same = *sum <= best.sum * (1.0 + Self::EQUAL);
            (growth <= Self::AS_WELL && !same && growth_at(best, x) > Self::APART * variance)
                .then(|| Rival { growth, values: x[..numbers].to_vec() })
        };
        self.ends.iter().filter_map(rival).min_by(|one, other| one.growth.total_cmp(&other.growth))
    }

    /// What is to be tried around an answer: a walk along the worst determined of the numbers that have a part in the events, then
    /// starts along the direction that the data determine worst, then starts spread over a box of some standard errors of each
    /// number. Beside a kink the derivatives do not tell where the valleys lead, so that the box finds what no direction does.
    fn around(problem: &Problem, best: &Search) -> Around {
        let scale: Vec<f64> = (0..best.x.len()).map(|column| norm(best.jacobian.column(column))).collect();
        let free = |column: &usize| scale[*column] > 0.0 && problem.bounds[*column].0 < problem.bounds[*column].1;
        let columns: Vec<usize> = (0..scale.len()).filter(free).collect();
        let decomposition = Decomposition::new(&best.jacobian, &columns, &scale, &best.residuals);
        let least = Self::VAGUE * decomposition.greatest();
        let determined: Vec<usize> = (0..columns.len()).filter(|&k| decomposition.singular[k] > least).collect();
        let deviation = variance(problem, best).sqrt();
        // One standard deviation along direction k, in the number of this place.
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
    /// The next value, all other numbers following from where they have come to on this side; `None` at the end.
    fn step(&mut self, problem: &mut Problem) -> Option<Beginning> {
        self.side = usize::from(self.values[0].len() < self.values[1].len());
        let value = self.values[self.side].pop()?;
        let mut start = self.at[self.side].clone();
        start[self.column] = value;
        let mut bounds = problem.bounds.clone();
        bounds[self.column] = (value, value);
        let plans = problem.plans.clone();
        let search = Window { problem, plans: &plans }.search_within(&start, bounds, Elsewhere::TRIALS_HELD);
        Some(Beginning { search, held: true })
    }
}

/// A search without anything held.
fn free(problem: &mut Problem, start: &[f64]) -> Search {
    let limit = if problem.curve.has_states() { Elsewhere::TRIALS_OF_MOTION } else { TRIALS };
    window::search(problem, start, limit)
}

/// By number of the search: whether the conditions of events, or what they set, depend on it.
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

/// The variance of a residual: as given, or as the residuals show it where that is larger.
pub(in crate::fit) fn variance(problem: &Problem, best: &Search) -> f64 {
    let dof = (problem.independent_values() + problem.scales() as f64 - best.x.len() as f64).max(1.0);
    let shown = best.sum / dof;
    if problem.task.errors_given() { shown.max(1.0) } else { shown }
}

/// How much larger the sum of squares would be at `x` than at the end of a search if the curve changed in proportion to the
/// numbers.
pub(in crate::fit) fn growth_at(best: &Search, x: &[f64]) -> f64 {
    let mut change = vec![0.0; best.residuals.len()];
    for (column, (to, from)) in x.iter().zip(&best.x).enumerate() {
        change.iter_mut().zip(best.jacobian.column(column)).for_each(|(change, slope)| *change += (to - from) * slope);
    }
    dot(&change, &change)
}

/// How the sum of squares depends on the numbers of the search, as far as the model's text tells.
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

/// Whether a function has a kink or a step, or takes one of several values.
fn is_branch(node: Node) -> bool {
    node.is_switch()
        || matches!(node, Node::Select(..) | Node::Unary(Unary::Not, _) | Node::Binary(Binary::And | Binary::Or, ..))
}
