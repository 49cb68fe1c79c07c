//! Sinusoids of a model whose arguments are written in it, in a formula as well as in a drive: parameters that set their
//! frequency, and parameters that act on their phase only.

use engine::Routine;
use program::{Graph, Model, Node, NodeId, Unary, Variable, differentiate};
use std::f64::consts::TAU;

/// Sine or cosine whose argument depends on the independent variable and not on states.
#[derive(Clone, Debug)]
pub(crate) struct Tone {
    /// Varied parameters of the model that change its frequency.
    pub frequencies: Vec<usize>,
    /// Varied parameter of the model that only shifts its phase, and the period of that parameter, SI.
    pub phase: Option<Phase>,
}

/// Parameter that shifts the phase of sinusoids.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Phase {
    /// Index of the parameter in the model.
    pub parameter: usize,
    /// Change of the parameter that shifts the phase by a whole turn, SI.
    pub period: f64,
}

impl Phase {
    /// `value` moved by whole periods into the range; the nearest end of the range if it has no such value.
    pub fn inside(self, value: f64, (low, high): (f64, f64)) -> f64 {
        let turns =
            if value > high { ((value - high) / self.period).ceil() } else { -((low - value) / self.period).ceil() };
        match (low..=high).contains(&value) {
            true => value,
            false => (value - turns * self.period).max(low).min(high),
        }
    }
}

/// Tones of a model.
#[derive(Clone, Debug)]
pub(crate) struct Tones {
    /// Tones with different arguments.
    pub tones: Vec<Tone>,
    /// Parameters in which the whole curve is periodic.
    pub periodic: Vec<Phase>,
    /// Rate of the argument of each tone, rad per unit of the independent variable.
    rates: Routine,
    /// Number of states of the model.
    states: usize,
}

impl Tones {
    /// Upper bound of the number of tones.
    const MOST: usize = 8;
    /// Upper bound of the steps in which a frequency is set, and relative error at which they end.
    const STEPS: usize = 30;
    const EXACT: f64 = 1e-12;

    /// Tones in the `observed` expressions and the equations of motion of `model`; `varied` are indices of parameters.
    pub fn new(model: &Model, observed: &[NodeId], varied: &[usize]) -> Self {
        let mut roots: Vec<NodeId> = observed.to_vec();
        roots.extend(model.states.iter().flat_map(|state| [state.derivative, state.initial]));
        for event in &model.events {
            roots.push(event.condition);
            roots.extend(event.actions.iter().map(|(_, value)| *value));
        }
        let mut graph = model.graph.clone();
        let (mut tones, mut arguments, mut rates) = (Vec::new(), Vec::new(), Vec::new());
        // For each varied parameter: sinusoids in whose argument it is a term, and its factors in them.
        let mut shifts: Vec<(Vec<NodeId>, Vec<f64>)> = vec![Default::default(); varied.len()];
        for sinusoid in model.graph.reachable(&roots) {
            let Node::Unary(Unary::Sin | Unary::Cos, argument) = model.graph.node(sinusoid) else { continue };
            let depends = model.depends(argument);
            let mut tone = Tone { frequencies: Vec::new(), phase: None };
            for (place, &index) in
                varied.iter().enumerate().filter(|(_, index)| depends.parameters.contains(&(**index as u32)))
            {
                let slope = differentiate(&mut graph, argument, Variable::Parameter(index as u32));
                if let Some(factor) = graph.as_constant(slope).filter(|factor| *factor != 0.0) {
                    shifts[place].0.push(sinusoid);
                    shifts[place].1.push(factor.abs());
                    tone.phase = Some(Phase { parameter: index, period: TAU / factor.abs() });
                } else if graph.reachable(&[slope]).iter().any(|node| graph.node(*node) == Node::Independent) {
                    tone.frequencies.push(index);
                }
            }
            let sounds = depends.independent && depends.states.is_empty() && depends.initial.is_empty();
            if sounds && !tone.frequencies.is_empty() && !arguments.contains(&argument) && tones.len() < Self::MOST {
                rates.push(differentiate(&mut graph, argument, Variable::Independent));
                arguments.push(argument);
                tones.push(tone);
            }
        }
        let periodic = (varied.iter().zip(&shifts))
            .filter_map(|(&index, (sinusoids, factors))| {
                Some(Phase { parameter: index, period: period(&mut graph, &roots, index, sinusoids, factors)? })
            })
            .collect();
        let states = model.states.len();
        Self { tones, periodic, rates: Routine::from_graph(&graph, states, &rates), states }
    }

    /// Angular frequency of a tone, rad per unit of the independent variable, at `time` with these `parameters` of the model (all SI).
    pub fn frequency(&mut self, tone: usize, parameters: &[f64], time: f64) -> f64 {
        let zeros = vec![0.0; self.states];
        let mut rates = vec![0.0; self.tones.len()];
        self.rates.prepare(parameters, &zeros);
        self.rates.evaluate(time, &zeros, &mut rates);
        rates[tone].abs()
    }

    /// Value of the parameter `index` at which a tone has the angular frequency `wanted` at `time`, with the other `parameters`.
    /// `None` if none is found.
    pub fn tuned(&mut self, tone: usize, index: usize, parameters: &[f64], (time, wanted): (f64, f64)) -> Option<f64> {
        let mut trial = parameters.to_vec();
        if trial[index] == 0.0 {
            trial[index] = 1.0;
        }
        for _ in 0..Self::STEPS {
            let value = trial[index];
            let frequency = self.frequency(tone, &trial, time);
            if (frequency / wanted - 1.0).abs() <= Self::EXACT {
                break;
            }
            trial[index] = value * (1.0 + 1e-6);
            // A frequency is a power of most parameters: 1 for a frequency, -1 for a period, 1/2 for a stiffness.
            let power = libm::log(self.frequency(tone, &trial, time) / frequency) / libm::log(1.0 + 1e-6);
            let power = [1.0, -1.0, 0.5, -0.5].into_iter().find(|usual| (power - usual).abs() < 1e-4).unwrap_or(power);
            trial[index] = value * libm::pow(wanted / frequency, 1.0 / power);
            if !(trial[index].is_finite() && trial[index] != 0.0) {
                return None;
            }
        }
        let near = (self.frequency(tone, &trial, time) / wanted - 1.0).abs() < 1e-6;
        near.then_some(trial[index])
    }
}

/// Period of the whole curve in a parameter that is a term, with these factors, in the arguments of these sinusoids. `None` if
/// it has another effect.
fn period(graph: &mut Graph, roots: &[NodeId], index: usize, sinusoids: &[NodeId], factors: &[f64]) -> Option<f64> {
    let least = factors.iter().copied().fold(f64::INFINITY, f64::min);
    let whole = |factor: &f64| (factor / least - (factor / least).round()).abs() < 1e-9;
    if sinusoids.is_empty() || !factors.iter().all(whole) {
        return None;
    }
    let without = graph.rewrite(roots, |graph, id, _| sinusoids.contains(&id).then(|| graph.constant(0.0)));
    let remains = graph.reachable(&without).iter().any(|node| graph.node(*node) == Node::Parameter(index as u32));
    (!remains).then_some(TAU / least)
}
