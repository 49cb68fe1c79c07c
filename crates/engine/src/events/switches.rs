//! Switches: jumps and bends of the equations ([`program::Held`]). Each is held at a constant value during a step and
//! compared with its true value at the end.

use crate::Routine;
use crate::methods::equations::Equations;
use program::{Held, NodeId, Switch};

/// The switches of a model with their held values.
#[derive(Clone, Debug, Default)]
pub(crate) struct Switches {
    /// True values of the switches.
    truths: Option<Routine>,
    /// True if the rates jump with the switch, per switch.
    jumps: Vec<bool>,
    held: Vec<f64>,
    found: Vec<f64>,
    looks: u64,
    sensitive: Option<Delays>,
}

/// Derivatives of the moments of switches with respect to parameters, for the sensitivities of a model.
#[derive(Clone, Debug)]
struct Delays {
    /// One root per switch and parameter, in the order of the switches.
    routine: Routine,
    values: Vec<f64>,
    /// Number of states without sensitivities.
    states: usize,
    parameters: usize,
    /// Rates before the switch.
    rates: Vec<f64>,
}

impl Switches {
    /// The switches of a model.
    pub fn new(held: &Held) -> Self {
        let nodes: Vec<NodeId> = held.switches.iter().map(|switch| switch.node).collect();
        let zeros = vec![0.0; nodes.len()];
        Self {
            truths: Some(Routine::compile(&held.model, &nodes)),
            jumps: held.switches.iter().map(|switch| switch.jumps).collect(),
            held: zeros.clone(),
            found: zeros,
            looks: 0,
            sensitive: Delays::new(held),
        }
    }

    /// True if there are no switches.
    pub fn is_empty(&self) -> bool {
        self.held.is_empty()
    }

    /// Sets parameters and initial values, SI units, in the order of the model.
    pub fn prepare(&mut self, parameters: &[f64], initial: &[f64]) {
        if let Some(truths) = &mut self.truths {
            truths.prepare(parameters, initial);
        }
        if let Some(sensitive) = &mut self.sensitive {
            sensitive.routine.prepare(parameters, initial);
        }
    }

    /// Approximate number of floating-point operations of all evaluations.
    pub fn work(&self) -> u64 {
        self.looks * self.truths.as_ref().map_or(0, Routine::work)
    }

    /// True values of the switches.
    pub fn truths(&self) -> Option<&Routine> {
        self.truths.as_ref()
    }

    /// Counts evaluations that were made elsewhere.
    pub fn count(&mut self, intervals: u64) {
        self.looks += if self.truths.is_some() { intervals } else { 0 };
    }

    /// Held values, one per switch.
    pub fn held(&self) -> &[f64] {
        &self.held
    }

    /// True if the value of a switch at `time` and `state` (SI) differs from its held value.
    pub fn differ(&mut self, time: f64, state: &[f64]) -> bool {
        let Some(truths) = &mut self.truths else { return false };
        self.looks += 1;
        truths.evaluate(time, state, &mut self.found);
        // NaN that stays NaN is no change; it shows in the state.
        let differs = |(held, found): (&f64, &f64)| held != found && !(held.is_nan() && found.is_nan());
        self.held.iter().zip(&self.found).any(differs)
    }

    /// Holds the switches at the values found last. Returns the first that changes and makes the rates jump, if any.
    pub fn hold(&mut self) -> Option<usize> {
        let mut changes = self.held.iter().zip(&self.found).zip(&self.jumps);
        let jumped = changes.position(|((held, found), jumps)| held != found && *jumps);
        self.held.copy_from_slice(&self.found);
        jumped
    }

    /// Computes the delays and rates at `time` (SI) and the state `before` a switch; [`Switches::carry`] needs them.
    pub fn approach(&mut self, equations: &mut Equations, time: f64, before: &[f64]) {
        if let Some(Delays { routine, values, rates, .. }) = &mut self.sensitive {
            routine.evaluate(time, before, values);
            equations.rates(time, before, rates);
        }
    }

    /// Applies the jump of the sensitivities in `state` (SI) at the switch `changed`, the first that changes. With the
    /// derivative tau' of its moment by the parameter: s+ = s + (f - f+) tau', where f and f+ are the rates before and
    /// after it.
    pub fn carry(&mut self, equations: &mut Equations, time: f64, changed: usize, state: &mut [f64]) {
        let Some(Delays { values, states, parameters, rates, .. }) = &mut self.sensitive else { return };
        let mut behind = vec![0.0; rates.len()];
        equations.rates(time, state, &mut behind);
        let (_, sensitivities) = state.split_at_mut(*states);
        let delays = &values[changed * *parameters..][..*parameters];
        for (sensitivity, delay) in sensitivities.chunks_mut(*states).zip(delays) {
            for ((value, before), behind) in sensitivity.iter_mut().zip(rates.iter()).zip(&behind) {
                *value += (before - behind) * delay;
            }
        }
    }
}

impl Delays {
    fn new(held: &Held) -> Option<Self> {
        let sensitive = held.model.sensitive.as_ref()?;
        let of = |switch: &Switch| sensitive.delays.iter().find(|(node, _)| *node == switch.node);
        // Every switch held in a model with sensitivities must have its delays.
        let roots: Vec<NodeId> = held.switches.iter().filter_map(of).flat_map(|(_, delays)| delays).copied().collect();
        let expected = held.switches.len() * sensitive.parameters;
        (roots.len() == expected).then(|| Self {
            routine: Routine::compile(&held.model, &roots),
            values: vec![0.0; roots.len()],
            states: sensitive.states,
            parameters: sensitive.parameters,
            rates: vec![0.0; held.model.states.len()],
        })
    }
}
