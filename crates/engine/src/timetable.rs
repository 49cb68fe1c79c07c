//! What happens at moments that depend on time alone: these are known before a step is made, so that none is skipped, however
//! soon it is over.

use crate::Routine;
use crate::crossing::Crossing;
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
}

impl Timetable {
    /// What does not change evenly is looked at so often in a step.
    const MOMENTS: usize = 32;

    pub fn new(model: &Model) -> Self {
        let timed = model.timed_switches();
        let nodes: Vec<NodeId> = timed.iter().map(|timed| timed.node).collect();
        // Of what changes evenly the first change is seen at the end.
        let moments = if timed.iter().all(|timed| timed.even) { 1 } else { Self::MOMENTS };
        Self {
            routine: Routine::compile(model, &nodes),
            moments,
            times: vec![0.0; moments + 1],
            values: vec![0.0; nodes.len() * (moments + 1)],
            looks: 0,
        }
    }

    /// Sets parameters and initial values.
    pub fn prepare(&mut self, parameters: &[f64], initial: &[f64]) {
        self.routine.prepare(parameters, initial);
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
        let first = (1..count).find(changed)?;
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
}
