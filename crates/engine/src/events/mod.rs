//! Events: sudden changes of the state.
//!
//! An event fires when its condition goes from false to true within a step. The moment is found by bisection down to
//! neighbouring numbers; the state at each trial comes from a shorter step of the method from the same start. The event
//! acts on the state at the last moment at which the condition is false. A bouncing ball is therefore never below the
//! floor, not even by rounding, and the condition can become true again in its next flight, however short.
//!
//! After an event has acted, it must be decided whether it can fire again, or whether its crossing still lies ahead: `when
//! t > 5 [s]` is false at 5 s and becomes true right after, with or without the action. The state before the action is
//! extrapolated linearly to where the condition is true. If the state after the action, extrapolated as far, also fulfils
//! it, the action has not prevented the crossing, and the event is used up.
//!
//! Switches are what jumps or bends in the equations ([`program::Model::held`]): each keeps its value during a step, and the
//! step ends where the true value changes. In a model without them nothing is different, to the bit. `Surfaces` joins the
//! switches with the events, `Timetable` computes beforehand what depends on time alone, and `Looks` finds where within a
//! step to look, so that nothing is skipped that is over before its end. Where it cannot promise that, the run has a
//! [`crate::Notice`]. A held branch may have no value beyond its corner: `methods/stepper/corner.rs` shortens such a step;
//! compiled code and lanes leave it to the engine. A switch at which the rates are continuous, by their form
//! (`program/src/model/continuity.rs`), is no jump: nothing is lost where it is skipped.

pub(crate) mod ahead;
pub(crate) mod crossing;
pub(crate) mod interpolant;
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
    /// Values of the actions, one routine per event.
    actions: Vec<Routine>,
    /// Indices of the states that the actions set, per event.
    targets: Vec<Vec<usize>>,
    /// True if the event ends the run, per event.
    stops: Vec<bool>,
    /// First event of the last moment that ends the run.
    ended: Option<usize>,
    /// True if the condition was false at the last evaluation, so that the event can fire; per event.
    armed: Vec<bool>,
    /// True if the event fires now, per event.
    due: Vec<bool>,
    truths: Vec<f64>,
    values: Vec<f64>,
    /// True if the event was due at the moment found and is not yet known to be used up; per event.
    crossing: Vec<bool>,
    /// State at that moment, before all jumps.
    approach: Vec<f64>,
    /// State before the last jump.
    before: Vec<f64>,
    /// State after the last jump.
    after: Vec<f64>,
    rates_before: Vec<f64>,
    rates_after: Vec<f64>,
    probe: Vec<f64>,
    /// Jumps of sensitivities, if these are among the states.
    jumps: Option<Jumps>,
    /// Number of evaluations of the conditions by [`Events::due`].
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

    /// True if the model has no events.
    pub fn is_empty(&self) -> bool {
        self.targets.is_empty()
    }

    /// Sets parameters and initial values, SI units, in the order of the model.
    pub fn prepare(&mut self, parameters: &[f64], initial: &[f64]) {
        self.conditions.prepare(parameters, initial);
        self.actions.iter_mut().for_each(|actions| actions.prepare(parameters, initial));
        if let Some(jumps) = &mut self.jumps {
            jumps.prepare(parameters, initial);
        }
    }

    /// Arms the events whose conditions are false at the initial state (SI) and its `time` (SI).
    pub fn arm(&mut self, time: f64, state: &[f64]) {
        self.due(time, state);
        self.pass();
    }

    /// True for each event that can fire: its condition was false at the last evaluation, and its crossing is not used up.
    pub fn armed(&self) -> &[bool] {
        &self.armed
    }

    /// The conditions.
    pub fn conditions(&self) -> &Routine {
        &self.conditions
    }

    /// Counts evaluations of the conditions that were made elsewhere.
    pub fn count(&mut self, intervals: u64) {
        self.looks += intervals;
    }

    /// Restores which events are armed.
    pub fn set_armed(&mut self, armed: &[bool]) {
        self.armed.copy_from_slice(armed);
    }

    /// Approximate number of floating-point operations of all evaluations of the conditions.
    pub fn work(&self) -> u64 {
        self.looks * self.conditions.work()
    }

    /// Evaluates the conditions at `time`. True if an armed event fires.
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

    /// Accepts the last evaluation, at which no event was due.
    pub fn pass(&mut self) {
        for (armed, &truth) in self.armed.iter_mut().zip(&self.truths) {
            *armed = truth == 0.0;
        }
    }

    /// Stores which events are due.
    pub fn note_due(&mut self) {
        self.crossing.copy_from_slice(&self.due);
    }

    /// Restores the events stored as due. True if there is any.
    pub fn recall_due(&mut self) -> bool {
        self.due.copy_from_slice(&self.crossing);
        self.first_due().is_some()
    }

    /// The state after the last jump: SI, one value per state.
    pub fn after(&self) -> &[f64] {
        &self.after
    }

    /// Runs the actions of the events that are due, the first on the state `before`. Returns their number.
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

    /// Runs the actions of one event on the state `before` at `time` (both SI), after a press of its button.
    pub fn fire_one(&mut self, event: usize, equations: &mut Equations, time: f64, before: &[f64]) -> usize {
        self.due.iter_mut().enumerate().for_each(|(number, due)| *due = number == event);
        let fired = self.fire(equations, time, before);
        // No condition was crossed, so no crossing can lie ahead.
        self.crossing.fill(false);
        fired
    }

    /// Runs the actions of the events made due by the last jump, on the state after it. Returns their number.
    pub fn cascade(&mut self, time: f64) -> usize {
        self.conditions.evaluate(time, &self.after, &mut self.truths);
        let fired = self.due.iter_mut().zip(&mut self.armed);
        for ((due, armed), &truth) in fired.zip(&self.truths) {
            // An event that just fired can fire again only after its condition was false.
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

    /// Decides after all jumps of a moment which of the events due at first are used up. `resolution` is the shortest time
    /// in which the state changes, `reach` the longest time of linear extrapolation; both in SI units.
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

    /// Runs the actions of the events that are due, each on the state left by the previous one. Returns their number.
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

    /// Returns the event that ended the run since the last call.
    pub fn take_end(&mut self) -> Option<usize> {
        self.ended.take()
    }

    /// The first event that is due.
    pub fn first_due(&self) -> Option<usize> {
        self.due.iter().position(|due| *due)
    }
}

/// Linear extrapolation: probe = state + ahead * rates
pub(crate) fn follow(probe: &mut [f64], state: &[f64], rates: &[f64], ahead: f64) {
    for ((probe, state), rate) in probe.iter_mut().zip(state).zip(rates) {
        *probe = state + ahead * rate;
    }
}
