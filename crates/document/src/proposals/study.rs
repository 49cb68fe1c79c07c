//! Equations under study: their motions, the points at which they are evaluated, and parameters that can be switched off.

use super::labels::meaning;
use program::{Choices, Model, Node, NodeId, Parameter, Program, Role, Variable, differentiate};
use units::number::shortest;
use units::split_mix::SplitMix64;

/// A state of the model at a moment, SI units.
#[derive(Clone, Debug, PartialEq)]
pub struct Point {
    /// The independent variable.
    pub time: f64,
    /// One value per state of the model.
    pub states: Vec<f64>,
}

/// Values of expressions, which a caller with an engine gives.
pub trait Evaluation {
    /// Points of a run of the document, at most some dozen, in the order of time; empty if it cannot run.
    fn run(&self) -> Vec<Point>;

    /// Values of nodes of a model, one list per node with one value per point. `parameters` and `initial`: one value per
    /// parameter and per state, SI units.
    fn values(
        &self,
        model: &Model,
        nodes: &[NodeId],
        parameters: &[f64],
        initial: &[f64],
        points: &[Point],
    ) -> Vec<Vec<f64>>;
}

/// A variable with a second derivative.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Motion {
    /// State of the position.
    pub position: u32,
    /// State of the velocity.
    pub velocity: u32,
    /// Rate of change of the velocity.
    pub acceleration: NodeId,
}

/// Points beside each point of the run.
const BESIDE: usize = 2;
/// Maximum number of states of a model that is studied.
const MOST_STATES: usize = 200;
/// Upper bound of the values of a run that is studied: their squares are still numbers.
const GREATEST: f64 = 1e100;

/// Equations of a document under study.
pub(super) struct Study<'a> {
    evaluation: &'a dyn Evaluation,
    /// Language tag of the document.
    pub language: String,
    /// The model; its graph grows.
    pub model: Model,
    pub motions: Vec<Motion>,
    /// Points of the run.
    pub run: Vec<Point>,
    /// Points of the run, and beside it.
    points: Vec<Point>,
    /// Values of the document.
    pub stated: Vec<f64>,
    /// Values of the document, with nonzero ones in the place of zeros.
    pub generic: Vec<f64>,
    /// Other values inside of the ranges.
    pub moved: Vec<f64>,
}

impl<'a> Study<'a> {
    /// `None` if there is nothing to study: no states, too many, discrete time, or no run.
    pub fn begin(program: &Program, evaluation: &'a dyn Evaluation) -> Option<Self> {
        let model = program.model.clone();
        if model.states.is_empty() || model.states.len() > MOST_STATES || model.independent.counts {
            return None;
        }
        let is_bounded = |point: &Point| point.states.iter().all(|value| value.abs() < GREATEST);
        let run: Vec<Point> = evaluation.run().into_iter().filter(is_bounded).collect();
        if run.is_empty() {
            return None;
        }
        let motions = motions(&model);
        let points = surrounded(&model, &motions, &run);
        let stated: Vec<f64> = model.parameters.iter().map(|parameter| parameter.value).collect();
        let generic = model.parameters.iter().map(generic).collect();
        let moved = model.parameters.iter().enumerate().map(|(index, parameter)| moved(index, parameter)).collect();
        let language = program.language.clone();
        Some(Self { evaluation, language, model, motions, run, points, stated, generic, moved })
    }

    /// Values of nodes at the points of the run and beside it, with no parameter 0 that can be another number.
    pub fn values(&self, nodes: &[NodeId]) -> Vec<Vec<f64>> {
        self.values_at(nodes, &self.generic, &self.points)
    }

    /// [`Self::values`] with other numbers than those of the document, so that no two agree by chance.
    pub fn values_moved(&self, nodes: &[NodeId]) -> Vec<Vec<f64>> {
        self.values_at(nodes, &self.moved, &self.points)
    }

    /// Values of nodes at points.
    pub fn values_at(&self, nodes: &[NodeId], parameters: &[f64], points: &[Point]) -> Vec<Vec<f64>> {
        let initial = self.initial(parameters);
        self.evaluation.values(&self.model, nodes, parameters, &initial, points)
    }

    /// Value of a node that depends on parameters only.
    pub fn constant(&self, node: NodeId, parameters: &[f64]) -> f64 {
        let values = self.values_at(&[node], parameters, &self.run[..1]);
        values.first().and_then(|values| values.first()).copied().unwrap_or(f64::NAN)
    }

    /// Initial values with these parameters, one per state.
    pub fn initial(&self, parameters: &[f64]) -> Vec<f64> {
        let nodes: Vec<NodeId> = self.model.states.iter().map(|state| state.initial).collect();
        let zeros = vec![0.0; nodes.len()];
        let start = Point { time: 0.0, states: zeros.clone() };
        let values = self.evaluation.values(&self.model, &nodes, parameters, &zeros, &[start]);
        values.iter().map(|values| values.first().copied().unwrap_or(f64::NAN)).collect()
    }

    /// Nodes with the velocities of all motions reversed.
    pub fn reversed(&mut self, nodes: &[NodeId]) -> Vec<NodeId> {
        let velocities: Vec<u32> = self.motions.iter().map(|motion| motion.velocity).collect();
        self.model.graph.substitute(nodes, |graph, node| match node {
            Node::State(index) if velocities.contains(&index) => {
                let state = graph.insert(node);
                Some(graph.negate(state))
            }
            _ => None,
        })
    }

    /// Partial derivative with respect to a state.
    pub fn slope(&mut self, node: NodeId, state: u32) -> NodeId {
        differentiate(&mut self.model.graph, node, Variable::State(state))
    }

    /// Parameters that can be switched off: a number whose range has 0, or a switch.
    pub fn can_vanish(&self, index: usize) -> bool {
        let parameter = &self.model.parameters[index];
        match parameter.choices {
            Choices::Numbers => parameter.range.is_none_or(|(low, high)| low <= 0.0 && 0.0 <= high),
            Choices::Switch => true,
            _ => false,
        }
    }

    /// Parameters without which all `nodes` vanish, one after the other; `None` if some do not.
    pub fn vanishing(&self, nodes: &[NodeId]) -> Option<Vec<usize>> {
        let mut chosen: Vec<usize> = Vec::new();
        for &node in nodes {
            if self.vanishes(node, &chosen) {
                continue;
            }
            let candidates = self.model.depends(node).parameters;
            let mut candidates: Vec<usize> = candidates.into_iter().map(|index| index as usize).collect();
            // A drive of the frequency 0 is still a force.
            let label = |index: usize| self.model.parameters[index].label.as_deref().unwrap_or_default();
            candidates.sort_by_key(|&index| meaning(label(index)).is_some());
            let found = candidates.into_iter().find(|&index| {
                let with = [chosen.as_slice(), &[index]].concat();
                self.can_vanish(index) && self.vanishes(node, &with)
            })?;
            chosen.push(found);
        }
        Some(chosen)
    }

    /// True if a node is 0 at all points once the parameters are 0.
    pub fn vanishes(&self, node: NodeId, parameters: &[usize]) -> bool {
        let mut values = self.generic.clone();
        parameters.iter().for_each(|&index| values[index] = 0.0);
        self.values_at(&[node], &values, &self.points).iter().flatten().all(|value| *value == 0.0)
    }

    /// State at the start with these parameters.
    pub fn start(&self, parameters: &[f64]) -> Point {
        Point { time: 0.0, states: self.initial(parameters) }
    }

    /// A run with parameters switched off in which some of the motions move: assignments that put them in motion, and all
    /// parameters, SI units. `None` if none can be put in motion.
    pub fn moving(&self, motions: &[Motion], off: &[usize]) -> Option<(Vec<String>, Vec<f64>)> {
        let mut parameters = self.stated.clone();
        off.iter().for_each(|&index| parameters[index] = 0.0);
        if self.is_moving(motions, &parameters) {
            return Some((Vec::new(), parameters));
        }
        let starts = motions.iter().flat_map(|motion| [motion.position, motion.velocity]);
        let starts: Vec<usize> = starts.filter_map(|state| self.initial_parameter(state)).collect();
        starts.into_iter().filter(|index| !off.contains(index)).find_map(|index| {
            let (low, high) = self.model.parameters[index].range.unwrap_or((0.0, 1.0));
            let mut moved = parameters.clone();
            moved[index] = if high > 0.0 { low.max(0.0) + 0.25 * (high - low.max(0.0)) } else { 0.25 * low };
            self.is_moving(motions, &moved).then(|| (vec![self.assignment(index, moved[index])], moved))
        })
    }

    fn is_moving(&self, motions: &[Motion], parameters: &[f64]) -> bool {
        let start = self.start(parameters);
        let nodes: Vec<NodeId> = motions.iter().map(|motion| motion.acceleration).collect();
        let forces = self.values_at(&nodes, parameters, std::slice::from_ref(&start));
        let moves = |motion: &Motion| start.states[motion.velocity as usize] != 0.0;
        motions.iter().any(moves) || forces.iter().flatten().any(|force| *force != 0.0)
    }

    /// Sum of nodes.
    pub fn sum(&mut self, nodes: &[NodeId]) -> NodeId {
        let zero = self.model.graph.constant(0.0);
        nodes.iter().fold(zero, |sum, &node| self.model.graph.add(sum, node))
    }

    /// The assignments that switch parameters off; those that are 0 in the document are left out.
    pub fn assignments(&self, parameters: &[usize]) -> Vec<String> {
        let shown = parameters.iter().filter(|&&index| self.stated[index] != 0.0);
        shown.map(|&index| self.assignment(index, 0.0)).collect()
    }

    /// `b = 0.2 [kg/s]`; the value in SI units.
    pub fn assignment(&self, index: usize, value: f64) -> String {
        let parameter = &self.model.parameters[index];
        if parameter.choices == Choices::Switch {
            return format!("{} = {}", parameter.name, if value == 0.0 { "off" } else { "on" });
        }
        format!("{} = {}", parameter.name, with_unit(parameter.unit.from_si(value), &parameter.unit.text))
    }

    /// Parameter that is the initial value of a state itself.
    pub fn initial_parameter(&self, state: u32) -> Option<usize> {
        match self.model.graph.node(self.model.states[state as usize].initial) {
            Node::Parameter(index) => Some(index as usize),
            _ => None,
        }
    }

    /// The moment of the start, as a claim writes it: `0 [s]`.
    pub fn beginning(&self) -> String {
        with_unit(0.0, &self.model.independent.unit.text)
    }

    /// True for a state that only events change.
    pub fn is_discrete(&self, state: u32) -> bool {
        self.model.graph.as_constant(self.model.states[state as usize].derivative) == Some(0.0)
    }
}

/// A number with its unit as an author writes it.
pub(super) fn with_unit(value: f64, unit: &str) -> String {
    // Twelve digits are enough for a claim, and hide rounding.
    let value = rounded(value, 11);
    let number = shortest(if value == 0.0 { 0.0 } else { value });
    if unit.is_empty() { number } else { format!("{number} [{unit}]") }
}

/// A difference rounded to one digit, with its unit; that of pure numbers is in percent, because a bare number would be a
/// fraction.
pub(super) fn rough(value: f64, unit: &str) -> String {
    let (value, unit) = if unit.is_empty() { (100.0 * value, "%") } else { (value, unit) };
    with_unit(rounded(value, 0), unit)
}

/// A number rounded to one digit and `more` further ones.
pub(super) fn rounded(value: f64, more: usize) -> f64 {
    format!("{value:.more$e}").parse().unwrap_or(value)
}

/// Variables whose rate of change is a velocity with a rate of its own.
fn motions(model: &Model) -> Vec<Motion> {
    let state = |index: u32| &model.states[index as usize];
    let own = |index: u32| matches!(state(index).role, Role::Own | Role::Hidden);
    let found = (0..model.states.len() as u32).filter_map(|position| {
        let Node::State(velocity) = model.graph.node(state(position).derivative) else { return None };
        let acceleration = state(velocity).derivative;
        let moves = model.graph.as_constant(acceleration) != Some(0.0);
        (own(position) && own(velocity) && velocity != position && moves).then_some(Motion {
            position,
            velocity,
            acceleration,
        })
    });
    let mut motions: Vec<Motion> = found.collect();
    // Two variables with one velocity are one motion.
    let mut seen = Vec::new();
    motions.retain(|motion| {
        !seen.contains(&motion.velocity) && {
            seen.push(motion.velocity);
            true
        }
    });
    motions
}

/// Value of a parameter, or a nonzero one in the place of 0.
fn generic(parameter: &Parameter) -> f64 {
    if parameter.value != 0.0 || parameter.choices != Choices::Numbers {
        return parameter.value;
    }
    match parameter.range {
        Some((low, high)) if high > 0.0 => 0.3 * high - 0.01 * low,
        Some((low, _)) if low < 0.0 => 0.3 * low,
        _ => parameter.unit.to_si(1.0),
    }
}

/// Value of a parameter moved by a part of its range that differs from one parameter to the next.
fn moved(index: usize, parameter: &Parameter) -> f64 {
    let (Choices::Numbers, Some((low, high))) = (&parameter.choices, parameter.range) else { return parameter.value };
    let part = 0.05 + 0.01 * (index % 10) as f64;
    let side = if parameter.value < (low + high) / 2.0 { 1.0 } else { -1.0 };
    parameter.unit.to_si(rounded(parameter.unit.from_si(parameter.value + side * part * (high - low)), 2))
}

/// The points of a run, and points beside them: positions and velocities are moved by up to a third of their greatest amount.
fn surrounded(model: &Model, motions: &[Motion], run: &[Point]) -> Vec<Point> {
    let greatest = |index: usize| run.iter().map(|point| point.states[index].abs()).fold(0.0, f64::max);
    let scales: Vec<f64> = (0..model.states.len()).map(greatest).collect();
    let of_dimension = |index: usize| {
        let alike = |other: &usize| model.states[*other].unit.dimension == model.states[index].unit.dimension;
        let all = motions.iter().flat_map(|motion| [motion.position as usize, motion.velocity as usize]);
        let greatest = all.filter(alike).map(|other| scales[other]).fold(0.0, f64::max);
        if greatest > 0.0 { greatest } else { 1.0 }
    };
    let mut random = SplitMix64::new(1);
    let mut uniform = || (random.bits() >> 11) as f64 / (1u64 << 52) as f64 - 1.0;
    // With other discrete values, such as that of a body at rest, other motions may not be possible.
    let is_discrete = |index: usize| model.graph.as_constant(model.states[index].derivative) == Some(0.0);
    let discrete: Vec<usize> = (0..model.states.len())
        .filter(|&index| is_discrete(index) && model.states[index].role != Role::Remembered)
        .collect();
    let as_at_start = |point: &&Point| discrete.iter().all(|&index| point.states[index] == run[0].states[index]);
    let mut points = run.to_vec();
    for point in run.iter().filter(as_at_start) {
        for _ in 0..BESIDE {
            let mut beside = point.clone();
            for index in motions.iter().flat_map(|motion| [motion.position as usize, motion.velocity as usize]) {
                let scale = if scales[index] > 0.0 { scales[index] } else { of_dimension(index) };
                beside.states[index] += uniform() / 3.0 * scale;
            }
            points.push(beside);
        }
    }
    points
}
