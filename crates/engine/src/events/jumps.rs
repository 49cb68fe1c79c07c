//! How the sensitivities of a model change at its events, in models that have them among their states. The formulas are the
//! model's ([`program::Jump`]); here they are evaluated for the events of one moment, one after the other.

use crate::Routine;
use program::Model;

/// The jumps of sensitivities.
#[derive(Clone, Debug)]
pub(crate) struct Jumps {
    /// For all events, the delays by each parameter.
    delays: Routine,
    delay_values: Vec<f64>,
    /// For each event: the sensitivities after it.
    sensitivities: Vec<Routine>,
    /// What they read: the states that the events so far have left, the delays.
    inputs: Vec<f64>,
    /// The states, sensitivities among them.
    all: usize,
    parameters: usize,
}

impl Jumps {
    /// Those of a model whose events have any.
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

    /// Sets parameters and initial values.
    pub fn prepare(&mut self, parameters: &[f64], initial: &[f64]) {
        self.delays.prepare(parameters, initial);
        self.sensitivities.iter_mut().for_each(|routine| routine.prepare(parameters, initial));
    }

    /// Computes how the moments of all events depend on the parameters, from the state `before` them.
    pub fn measure_delays(&mut self, time: f64, before: &[f64]) {
        self.delays.evaluate(time, before, &mut self.delay_values);
    }

    /// Carries the sensitivities in `state` past one event, before that sets the other states there. The moment of an event
    /// is its own if it was `crossed` by the motion; one that was made due by the jump of another fires with that one, and so
    /// its moment is the one taken last.
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
