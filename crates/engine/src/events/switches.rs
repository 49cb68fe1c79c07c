//! Jumps and bends of the equations ([`program::Held`]): the values at which they are held during a step, and whether they
//! still have them.

use crate::Routine;
use crate::methods::equations::Equations;
use program::{Held, NodeId, Switch};

/// The switches of a model, each with the value at which it is held.
#[derive(Clone, Debug, Default)]
pub(crate) struct Switches {
    /// Their true values.
    truths: Option<Routine>,
    /// By switch, whether the rates jump with it.
    jumps: Vec<bool>,
    held: Vec<f64>,
    found: Vec<f64>,
    looks: u64,
    sensitive: Option<Delays>,
}

/// How the moments of switches change with parameters, for the sensitivities of a model.
#[derive(Clone, Debug)]
struct Delays {
    /// By switch and parameter.
    routine: Routine,
    values: Vec<f64>,
    /// The model's own states.
    states: usize,
    parameters: usize,
    /// The rates before a switch.
    rates: Vec<f64>,
}

impl Switches {
    /// Those of a held model.
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

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.held.is_empty()
    }

    /// Sets parameters and initial values.
    pub fn prepare(&mut self, parameters: &[f64], initial: &[f64]) {
        if let Some(truths) = &mut self.truths {
            truths.prepare(parameters, initial);
        }
        if let Some(sensitive) = &mut self.sensitive {
            sensitive.routine.prepare(parameters, initial);
        }
    }

    /// About how many floating-point operations all looks took.
    pub fn work(&self) -> u64 {
        self.looks * self.truths.as_ref().map_or(0, Routine::work)
    }

    /// The values at which they are held.
    pub fn held(&self) -> &[f64] {
        &self.held
    }

    /// Whether any has another value than that at which it is held.
    pub fn differ(&mut self, time: f64, state: &[f64]) -> bool {
        let Some(truths) = &mut self.truths else { return false };
        self.looks += 1;
        truths.evaluate(time, state, &mut self.found);
        // A value that is not a number stays what it is; the state shows it soon enough.
        let differs = |(held, found): (&f64, &f64)| held != found && !(held.is_nan() && found.is_nan());
        self.held.iter().zip(&self.found).any(differs)
    }

    /// Holds them at the values found last; the first that changes and with which the rates jump, if there is one.
    pub fn hold(&mut self) -> Option<usize> {
        let mut changes = self.held.iter().zip(&self.found).zip(&self.jumps);
        let jumped = changes.position(|((held, found), jumps)| held != found && *jumps);
        self.held.copy_from_slice(&self.found);
        jumped
    }

    /// Sees how sensitivities will jump at a switch: the state `before` it, and the rates there.
    pub fn approach(&mut self, equations: &mut Equations, time: f64, before: &[f64]) {
        if let Some(Delays { routine, values, rates, .. }) = &mut self.sensitive {
            routine.evaluate(time, before, values);
            equations.rates(time, before, rates);
        }
    }

    /// Carries the sensitivities in `state` past the switch that changes first among those that do, to its moment tau:
    /// s+ = s + (f - f+) tau', with f and f+ the rates before and behind it.
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
        // Every switch that is held in a model with sensitivities is one of those at which it jumps.
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
