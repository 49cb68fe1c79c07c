//! What happens at moments that depend on time alone: these are known before a step is made, so that none is skipped, however
//! soon it is over.

use super::crossing::Crossing;
use crate::Routine;
use crate::methods::cubic::Cubic;
use program::{Model, NodeId};

/// The switches of a model that depend on time alone ([`Model::timed_switches`]).
#[derive(Clone, Debug)]
pub(crate) struct Timetable {
    routine: Routine,
    /// So many moments of each step are looked at.
    moments: usize,
    times: Vec<f64>,
    values: Vec<f64>,
    looks: u64,
    /// What the uneven ones compare, and behind it how fast that changes.
    shapes: Routine,
    /// From when on something may have been missed.
    doubt: Option<f64>,
}

impl Timetable {
    /// What does not change evenly is looked at so often in a step.
    const MOMENTS: usize = 32;
    /// A cubic from one moment to the next that is wrong by more than this part of its greatest value shows that this is too
    /// seldom: a sine has then less than two moments in a period.
    const EXACTNESS: f64 = 0.2;

    pub fn new(model: &Model) -> Self {
        let (graph, timed) = model.timed_switches();
        let nodes: Vec<NodeId> = timed.iter().map(|timed| timed.node).collect();
        let uneven = || timed.iter().filter(|timed| !timed.even);
        let shapes: Vec<NodeId> =
            uneven().map(|timed| timed.argument).chain(uneven().map(|timed| timed.slope)).collect();
        let compile = |roots: &[NodeId]| Routine::from_graph(&graph, model.states.len(), roots);
        // Of what changes evenly the first change is seen at the end.
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

    /// The first moment from which on a change may have been missed.
    pub fn doubt(&self) -> Option<f64> {
        self.doubt
    }

    /// Forgets what is not earlier than `time`.
    pub fn go_back_to(&mut self, time: f64) {
        self.doubt = self.doubt.filter(|doubt| *doubt < time);
    }

    /// Sets parameters and initial values.
    pub fn prepare(&mut self, parameters: &[f64], initial: &[f64]) {
        self.routine.prepare(parameters, initial);
        self.shapes.prepare(parameters, initial);
    }

    /// About how many floating-point operations all looks took.
    pub fn work(&self) -> u64 {
        self.looks * self.routine.work()
    }

    /// The first change after `from` and not after `to`, in a state whose values do not matter but those that events alone
    /// change.
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

    /// Down to neighbouring numbers.
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

    /// Whether something changes so fast that looks at these times can miss it, by what it does between the first two, where
    /// nothing jumps.
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
