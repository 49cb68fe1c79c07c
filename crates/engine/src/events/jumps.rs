//! Jumps of sensitivities at events, for models that have sensitivities among their states. [`program::Jump`] has the
//! formulas; they are evaluated here for the events of one moment, one after the other.

use crate::Routine;
use program::Model;

/// Jumps of the sensitivities at all events.
#[derive(Clone, Debug)]
pub(crate) struct Jumps {
    /// Derivatives of the moment of each event with respect to each parameter, for all events.
    delays: Routine,
    delay_values: Vec<f64>,
    /// Sensitivities after the event, one routine per event.
    sensitivities: Vec<Routine>,
    /// Inputs of these routines: the states after the previous events, then the delays.
    inputs: Vec<f64>,
    /// Number of states, sensitivities included.
    all: usize,
    parameters: usize,
}

impl Jumps {
    /// The jumps of a model; `None` if no event has any.
    pub fn new(model: &Model) -> Option<Self> {
        let jumps: Vec<_> = model.events.iter().filter_map(|event| event.jump.as_ref()).collect();
        let parameters = jumps.first()?.delays.len();
        let all = model.states.len();
        let inputs = all + parameters;
        let delays: Vec<_> = jumps.iter().flat_map(|jump| &jump.delays).copied().collect();
        let routine = |jump: &&program::Jump| Routine::from_graph(&model.graph, inputs, &jump.sensitivities);
        Some(Self {
            delays: Routine::compile(model, &delays),
            delay_values: vec![0.0; delays.len()],
            sensitivities: jumps.iter().map(routine).collect(),
            inputs: vec![0.0; inputs],
            all,
            parameters,
        })
    }

    /// Sets parameters and initial values, SI units, in the order of the model.
    pub fn prepare(&mut self, parameters: &[f64], initial: &[f64]) {
        self.delays.prepare(parameters, initial);
        self.sensitivities.iter_mut().for_each(|routine| routine.prepare(parameters, initial));
    }

    /// Computes the derivatives of the moments of all events with respect to the parameters, at `time` (SI) and the state `before` them, with its sensitivities.
    pub fn measure_delays(&mut self, time: f64, before: &[f64]) {
        self.delays.evaluate(time, before, &mut self.delay_values);
    }

    /// Replaces the sensitivities in `state` by those after one event at `time` (SI), before its actions set the other states. If the
    /// motion `crossed` the condition, the event has its own moment; if the jump of another event made it due, it has the
    /// moment of that event, used last.
    pub fn carry(&mut self, event: usize, crossed: bool, time: f64, state: &mut [f64]) {
        let (states, delays) = self.inputs.split_at_mut(self.all);
        if crossed && let Some(own) = self.delay_values.chunks(self.parameters.max(1)).nth(event) {
            delays.copy_from_slice(own);
        }
        states.copy_from_slice(state);
        if let Some(routine) = self.sensitivities.get_mut(event) {
            let own = self.all - routine.len();
            routine.evaluate(time, &self.inputs, &mut state[own..]);
        }
    }
}
