//! Sudden changes of the state.
//!
//! An event fires when its condition goes from false to true within a step. The moment is found by bisection on the state
//! that the method itself gives for a shorter step from the same start, down to neighbouring numbers, and the state taken
//! is the one at the last moment at which the condition is still false: a ball is never below the floor, not even by
//! rounding, and so its next flight, however short, is again one from false to true.
//!
//! What remains to be decided is whether an event that has fired may fire again or whether the crossing that caused it
//! still lies ahead (`when t > 5 [s]` is false at 5 s and becomes true right after, action or no action). The motion that
//! would follow without the action is followed in a straight line to where its condition is true; if the motion with the
//! action makes it true there as well, the action has not prevented the crossing and the event has been used up.

pub(crate) mod crossing;
pub(crate) mod jumps;
pub(crate) mod looks;
pub(crate) mod press;
pub(crate) mod surfaces;
pub(crate) mod switches;
pub(crate) mod timetable;

use crate::Routine;
use crate::methods::equations::Equations;
use jumps::Jumps;
use program::{Event, Model, NodeId};

/// The conditions and actions of a model.
#[derive(Clone, Debug)]
pub(crate) struct Events {
    conditions: Routine,
    /// For each event, the values of its actions.
    actions: Vec<Routine>,
    /// For each event, which states these are for.
    targets: Vec<Vec<usize>>,
    /// By event: whether it ends the run.
    stops: Vec<bool>,
    /// The first event of the last moment that does.
    ended: Option<usize>,
    /// By event: whether its condition was false when last looked at, so that it can fire.
    armed: Vec<bool>,
    /// By event: whether it fires now.
    due: Vec<bool>,
    truths: Vec<f64>,
    values: Vec<f64>,
    /// By event: whether it was due when the moment was found, and whether it is used up is still open.
    crossing: Vec<bool>,
    /// The state at that moment, before all jumps.
    approach: Vec<f64>,
    /// The state before the last jump.
    before: Vec<f64>,
    /// The state after the jump.
    after: Vec<f64>,
    rates_before: Vec<f64>,
    rates_after: Vec<f64>,
    probe: Vec<f64>,
    /// How sensitivities change, where they are among the states.
    jumps: Option<Jumps>,
    /// How often the conditions were evaluated to see what is due.
    looks: u64,
}

impl Events {
    pub fn new(model: &Model) -> Self {
        let conditions: Vec<NodeId> = model.events.iter().map(|event| event.condition).collect();
        let of_event = |event: &Event| {
            let values: Vec<NodeId> = event.actions.iter().map(|(_, value)| *value).collect();
            Routine::compile(model, &values)
        };
        let targets = |event: &Event| event.actions.iter().map(|(state, _)| *state as usize).collect();
        let zeros = vec![0.0; model.states.len()];
        Self {
            conditions: Routine::compile(model, &conditions),
            actions: model.events.iter().map(of_event).collect(),
            targets: model.events.iter().map(targets).collect(),
            stops: model.events.iter().map(|event| event.stops).collect(),
            ended: None,
            armed: vec![false; conditions.len()],
            due: vec![false; conditions.len()],
            truths: vec![0.0; conditions.len()],
            values: vec![0.0; model.events.iter().map(|event| event.actions.len()).max().unwrap_or(0)],
            crossing: vec![false; conditions.len()],
            approach: zeros.clone(),
            before: zeros.clone(),
            after: zeros.clone(),
            rates_before: zeros.clone(),
            rates_after: zeros.clone(),
            probe: zeros,
            jumps: Jumps::new(model),
            looks: 0,
        }
    }

    /// Whether the model has any.
    pub fn is_empty(&self) -> bool {
        self.targets.is_empty()
    }

    /// Sets parameters and initial values.
    pub fn prepare(&mut self, parameters: &[f64], initial: &[f64]) {
        self.conditions.prepare(parameters, initial);
        self.actions.iter_mut().for_each(|actions| actions.prepare(parameters, initial));
        if let Some(jumps) = &mut self.jumps {
            jumps.prepare(parameters, initial);
        }
    }

    /// Arms the events whose conditions are false at the state from which a run starts.
    pub fn arm(&mut self, time: f64, state: &[f64]) {
        self.due(time, state);
        self.pass();
    }

    /// By event, whether it can fire: its condition was false when last looked at, and its crossing is not used up.
    pub fn armed(&self) -> &[bool] {
        &self.armed
    }

    /// Arms exactly these events, as they were armed at an earlier moment.
    pub fn set_armed(&mut self, armed: &[bool]) {
        self.armed.copy_from_slice(armed);
    }

    /// About how many floating-point operations all looks at the conditions took.
    pub fn work(&self) -> u64 {
        self.looks * self.conditions.work()
    }

    /// Whether an event fires between the last look and `time`.
    pub fn due(&mut self, time: f64, state: &[f64]) -> bool {
        self.looks += 1;
        self.conditions.evaluate(time, state, &mut self.truths);
        let mut any = false;
        for ((due, &armed), &truth) in self.due.iter_mut().zip(&self.armed).zip(&self.truths) {
            *due = armed && truth != 0.0;
            any |= *due;
        }
        any
    }

    /// Goes on to the last look, at which no event was due.
    pub fn pass(&mut self) {
        for (armed, &truth) in self.armed.iter_mut().zip(&self.truths) {
            *armed = truth == 0.0;
        }
    }

    /// Remembers what is due.
    pub fn note_due(&mut self) {
        self.crossing.copy_from_slice(&self.due);
    }

    /// Takes for due what was due when that was remembered; whether there is anything.
    pub fn recall_due(&mut self) -> bool {
        self.due.copy_from_slice(&self.crossing);
        self.first_due().is_some()
    }

    /// The state after the last jump.
    pub fn after(&self) -> &[f64] {
        &self.after
    }

    /// Lets the events act that are due, the first on the state `before`; how many there are.
    pub fn fire(&mut self, equations: &mut Equations, time: f64, before: &[f64]) -> usize {
        self.before.copy_from_slice(before);
        self.approach.copy_from_slice(before);
        equations.rates(time, before, &mut self.rates_before);
        self.note_due();
        if let Some(jumps) = &mut self.jumps {
            jumps.measure_delays(time, &self.before);
        }
        self.act(time)
    }

    /// Lets one event act on the state `before`, which nothing but a person has made due.
    pub fn fire_one(&mut self, event: usize, equations: &mut Equations, time: f64, before: &[f64]) -> usize {
        self.due.iter_mut().enumerate().for_each(|(number, due)| *due = number == event);
        let fired = self.fire(equations, time, before);
        // Nothing was crossed that could lie ahead still.
        self.crossing.fill(false);
        fired
    }

    /// Lets the events act that the last jump has made due, on the state after it; how many there were.
    pub fn cascade(&mut self, time: f64) -> usize {
        self.conditions.evaluate(time, &self.after, &mut self.truths);
        let fired = self.due.iter_mut().zip(&mut self.armed);
        for ((due, armed), &truth) in fired.zip(&self.truths) {
            // What has just fired can fire again only after its condition has been false.
            let can_fire = *armed && !*due;
            *due = can_fire && truth != 0.0;
            *armed = can_fire || truth == 0.0;
        }
        if !self.due.contains(&true) {
            return 0;
        }
        self.before.copy_from_slice(&self.after);
        self.act(time)
    }

    /// Decides, after all jumps of a moment, which of the events that were due at first have been used up. `resolution`
    /// is the least time in which the state changes, `reach` the greatest over which its motion is taken to be straight.
    pub fn settle(&mut self, equations: &mut Equations, time: f64, resolution: f64, reach: f64) {
        equations.rates(time, &self.after, &mut self.rates_after);
        let mut crossed = vec![false; self.crossing.len()];
        let mut ahead = resolution.max(f64::MIN_POSITIVE);
        while self.crossing.contains(&true) {
            let found_nothing = ahead > reach;
            follow(&mut self.probe, &self.approach, &self.rates_before, ahead);
            self.conditions.evaluate(time + ahead, &self.probe, &mut self.truths);
            for (crossed, &truth) in crossed.iter_mut().zip(&self.truths) {
                *crossed = truth != 0.0;
            }
            follow(&mut self.probe, &self.after, &self.rates_after, ahead);
            self.conditions.evaluate(time + ahead, &self.probe, &mut self.truths);
            let answers = crossed.iter().zip(&self.truths);
            for ((crossing, armed), (&crossed, &truth)) in self.crossing.iter_mut().zip(&mut self.armed).zip(answers) {
                if *crossing && (crossed || found_nothing) {
                    *crossing = false;
                    *armed &= truth == 0.0 && !found_nothing;
                }
            }
            ahead *= 4.0;
        }
    }

    /// One event after the other, each on what those before have left.
    fn act(&mut self, time: f64) -> usize {
        self.after.copy_from_slice(&self.before);
        let mut count = 0;
        for (event, targets) in self.targets.iter().enumerate().filter(|(event, _)| self.due[*event]) {
            self.actions[event].evaluate(time, &self.after, &mut self.values);
            if let Some(jumps) = &mut self.jumps {
                jumps.carry(event, self.crossing[event], time, &mut self.after);
            }
            for (&state, &value) in targets.iter().zip(&self.values) {
                self.after[state] = value;
            }
            if self.stops[event] {
                self.ended = self.ended.or(Some(event));
            }
            count += 1;
        }
        count
    }

    /// The event that has ended the run since this was asked last.
    pub fn take_end(&mut self) -> Option<usize> {
        self.ended.take()
    }

    /// An event that is due.
    pub fn first_due(&self) -> Option<usize> {
        self.due.iter().position(|due| *due)
    }
}

/// probe = state + ahead * rates
fn follow(probe: &mut [f64], state: &[f64], rates: &[f64], ahead: f64) {
    for ((probe, state), rate) in probe.iter_mut().zip(state).zip(rates) {
        *probe = state + ahead * rate;
    }
}
