//! Changes that depend on the independent variable alone: they are found before a step is made, so that none is skipped,
//! however short it is.

use super::crossing::Crossing;
use crate::Routine;
use crate::methods::cubic::Cubic;
use program::{Model, NodeId};

/// The switches of a model that depend on the independent variable alone ([`Model::timed_switches`]).
#[derive(Clone, Debug)]
pub(crate) struct Timetable {
    routine: Routine,
    /// Number of subintervals of a step at whose ends the switches are evaluated.
    moments: usize,
    times: Vec<f64>,
    values: Vec<f64>,
    looks: u64,
    /// Arguments that are not linear in the independent variable, then their slopes.
    shapes: Routine,
    /// Time from which on a change may have been missed, SI units.
    doubt: Option<f64>,
}

impl Timetable {
    /// Number of subintervals per step if some argument is not linear in the independent variable.
    const MOMENTS: usize = 32;
    /// Accepted error of the cubic between two neighbouring moments, relative to its greatest magnitude. A larger error
    /// shows that the moments are too sparse: a sine then has less than two of them per period.
    const EXACTNESS: f64 = 0.2;

    pub fn new(model: &Model) -> Self {
        let (graph, timed) = model.timed_switches();
        let nodes: Vec<NodeId> = timed.iter().map(|timed| timed.node).collect();
        let uneven = || timed.iter().filter(|timed| !timed.even);
        let shapes: Vec<NodeId> =
            uneven().map(|timed| timed.argument).chain(uneven().map(|timed| timed.slope)).collect();
        let compile = |roots: &[NodeId]| Routine::from_graph(&graph, model.states.len(), roots);
        // The first change of linear arguments is visible at the end of the step.
        let moments = if timed.iter().all(|timed| timed.even) { 1 } else { Self::MOMENTS };
        Self {
            routine: compile(&nodes),
            moments,
            times: vec![0.0; moments + 1],
            values: vec![0.0; nodes.len() * (moments + 1)],
            looks: 0,
            shapes: compile(&shapes),
            doubt: None,
        }
    }

    /// True if nothing depends on the independent variable alone.
    pub fn is_empty(&self) -> bool {
        self.routine.is_empty()
    }

    /// The switches, if the end of a step alone shows whether one changes.
    pub fn even(&self) -> Option<&Routine> {
        (self.moments == 1 && self.shapes.is_empty()).then_some(&self.routine)
    }

    /// Counts evaluations that were made elsewhere.
    pub fn count(&mut self, intervals: u64) {
        self.looks += if self.routine.is_empty() { 0 } else { 2 * intervals };
    }

    /// First moment (SI) from which on a change may have been missed.
    pub fn doubt(&self) -> Option<f64> {
        self.doubt
    }

    /// Drops a doubt at `time` or later.
    pub fn go_back_to(&mut self, time: f64) {
        self.doubt = self.doubt.filter(|doubt| *doubt < time);
    }

    /// Sets parameters and initial values, SI units, in the order of the model.
    pub fn prepare(&mut self, parameters: &[f64], initial: &[f64]) {
        self.routine.prepare(parameters, initial);
        self.shapes.prepare(parameters, initial);
    }

    /// Approximate number of floating-point operations of all evaluations.
    pub fn work(&self) -> u64 {
        self.looks * self.routine.work()
    }

    /// The first change in (`from`, `to`], SI units. Of `state` only the values matter that events alone change.
    pub fn next(&mut self, from: f64, to: f64, state: &[f64]) -> Option<Crossing> {
        if self.routine.is_empty() {
            return None;
        }
        let count = self.times.len();
        for (number, time) in self.times.iter_mut().enumerate() {
            *time = from + (to - from) * (number as f64 / self.moments as f64);
        }
        self.times[count - 1] = to;
        self.looks += count as u64;
        self.routine.evaluate_rows(&self.times, state, &mut self.values);
        let changed = |number: &usize| self.values.chunks(count).any(|values| values[*number] != values[0]);
        let first = (1..count).find(changed);
        if first != Some(1) && self.doubt.is_none() && !self.shapes.is_empty() && self.is_too_fast(state) {
            self.doubt = Some(from);
        }
        let first = first?;
        let (low, high) = (self.times[first - 1], self.times[first]);
        Some(self.narrow(low, high, state))
    }

    /// Bisects down to neighbouring numbers.
    fn narrow(&mut self, low: f64, high: f64, state: &[f64]) -> Crossing {
        let roots = self.routine.len();
        let before: Vec<f64> = self.values.chunks(self.times.len()).map(|values| values[0]).collect();
        let mut found = vec![0.0; roots];
        Crossing::find(low, high, |time| {
            self.looks += 1;
            self.routine.evaluate(time, state, &mut found);
            found != before
        })
    }

    /// True if an argument changes too fast to be followed at these times, judged by the first subinterval, in which no
    /// switch changes.
    fn is_too_fast(&mut self, state: &[f64]) -> bool {
        let [low, high] = [self.times[0], self.times[1]];
        let (size, count) = (high - low, self.shapes.len() / 2);
        let mut at = |part: f64| {
            let mut values = vec![0.0; 2 * count];
            self.looks += 1;
            self.shapes.evaluate(low + part * size, state, &mut values);
            values
        };
        let (start, end, inside) = (at(0.0), at(1.0), [0.29, 0.62].map(|part| (part, at(part))));
        (0..count).any(|number| {
            let slopes = [&start, &end].map(|values| size * values[count + number]);
            let cubic = Cubic::new([start[number], end[number]], slopes);
            let (least, greatest) = cubic.range();
            let allowed = Self::EXACTNESS * greatest.abs().max(least.abs());
            inside.iter().any(|(part, values)| (values[number] - cubic.at(*part)).abs() > allowed)
        })
    }
}
