//! Events and switches of the equations: everything that can end a step early.

use super::crossing::Crossing;
use super::looks::{Dense, Looks};
use super::switches::Switches;
use super::timetable::Timetable;
use crate::events::Events;
use crate::methods::equations::Equations;
use crate::{Notice, NoticeKind};
use program::{Held, Model};

/// Events and switches of the equations of a model.
#[derive(Clone, Debug)]
pub(crate) struct Surfaces {
    pub events: Events,
    pub switches: Switches,
    pub timetable: Timetable,
    /// Search for moments within a step at which conditions are evaluated; `None` if no condition depends on states.
    pub looks: Option<Looks>,
    /// State before the last crossing.
    before: Vec<f64>,
    /// State after the last crossing, without the actions of events.
    beyond: Vec<f64>,
}

impl Surfaces {
    pub fn new(model: &Model, held: Option<&Held>) -> Self {
        let switches = held.map(Switches::new).unwrap_or_default();
        let zeros = vec![0.0; model.states.len()];
        let timetable = Timetable::new(model);
        let looks = Looks::new(model, held);
        Self { events: Events::new(model), switches, timetable, looks, before: zeros.clone(), beyond: zeros }
    }

    /// True if the model has neither events nor switches.
    pub fn is_empty(&self) -> bool {
        self.events.is_empty() && self.switches.is_empty()
    }

    /// True if nothing can end a step early.
    pub fn is_smooth(&self) -> bool {
        self.is_empty() && self.timetable.is_empty()
    }

    /// Sets parameters and initial values, SI units, in the order of the model.
    pub fn prepare(&mut self, parameters: &[f64], initial: &[f64]) {
        self.events.prepare(parameters, initial);
        self.switches.prepare(parameters, initial);
        self.timetable.prepare(parameters, initial);
    }

    /// Sets parameters and initial values (SI) of the search within a step, with the held values of the switches.
    pub fn prepare_looks(&mut self, parameters: &[f64], initial: &[f64]) {
        if let Some(looks) = &mut self.looks {
            looks.prepare(&[parameters, self.switches.held()].concat(), initial);
        }
    }

    /// Approximate number of floating-point operations of all evaluations of conditions.
    pub fn work(&self) -> u64 {
        let looks = self.looks.as_ref().map_or(0, Looks::work);
        self.events.work() + self.switches.work() + self.timetable.work() + looks
    }

    /// Notices of changes that may have been missed.
    pub fn notices(&self) -> Vec<Notice> {
        let skipped = self
            .looks
            .as_ref()
            .and_then(Looks::doubt)
            .map(|doubt| Notice { kind: NoticeKind::MayBeSkipped(doubt.event), time: doubt.time });
        let too_fast = self.timetable.doubt().map(|time| Notice { kind: NoticeKind::TooFastInTime, time });
        skipped.into_iter().chain(too_fast).collect()
    }

    /// True if a jump of the equations may have been missed at `time` (SI) or later, and none before.
    pub fn doubts_jump(&self, time: f64) -> bool {
        let doubt = self.looks.as_ref().and_then(Looks::doubt);
        doubt.is_some_and(|doubt| doubt.event.is_none() && doubt.time >= time)
    }

    /// Drops the doubt of [`Surfaces::doubts_jump`].
    pub fn drop_doubt(&mut self, time: f64) {
        if let Some(looks) = &mut self.looks {
            looks.go_back_to(time);
        }
    }

    /// Drops doubts recorded at `time` or later.
    pub fn go_back_to(&mut self, time: f64) {
        self.timetable.go_back_to(time);
        if let Some(looks) = &mut self.looks {
            looks.go_back_to(time);
        }
    }

    /// True if an event fires or a switch changes between the last evaluation and `time`.
    pub fn crossed(&mut self, time: f64, state: &[f64]) -> bool {
        let due = self.events.due(time, state);
        self.switches.differ(time, state) || due
    }

    /// Searches the step that started at `start`, between the times of `from` and `to`, for a change. Returns the last
    /// moment without a change and the first one found with a change, both relative to `start`. `state_at` gives the state
    /// at a time relative to `start`; `dense` is the continuous solution of the method, if it has one.
    pub fn look_between(
        &mut self,
        start: f64,
        dense: Dense,
        from: (f64, &[f64]),
        to: (f64, &[f64]),
        mut state_at: impl FnMut(f64, &mut [f64]),
    ) -> (f64, Option<f64>) {
        let mut low = from.0 - start;
        let moments = self.looks.as_mut().map_or(0, |looks| looks.find(dense, from, to));
        let mut probe = std::mem::take(&mut self.before);
        let mut happened = None;
        for number in 0..moments {
            let Some(moment) = self.looks.as_ref().and_then(|looks| looks.moment(number)) else { break };
            let since = moment - start;
            if since <= low {
                continue;
            }
            state_at(since, &mut probe);
            if self.crossed(start + since, &probe) {
                happened = Some(since);
                break;
            }
            self.events.pass();
            low = since;
        }
        self.before = probe;
        (low, happened)
    }

    /// Finds the first moment of a change in the interval (`low`, `high`), relative to `start`, and stores the states
    /// there. `state_at` gives the state at a time relative to `start`.
    ///
    /// `expected` is the time of a change that depends on the independent variable alone. The result is that time, unless
    /// something else changes before.
    pub fn locate(
        &mut self,
        start: f64,
        (mut low, mut high): (f64, f64),
        expected: Option<Crossing>,
        mut state_at: impl FnMut(f64, &mut [f64]),
    ) -> Crossing {
        if let Some(expected) = expected {
            // Relative times near the start are denser than absolute ones: neighbouring absolute times are no neighbours here.
            let moment = expected.since(start);
            let moment = Crossing::find(moment.low, moment.high, |since| start + since >= expected.high);
            self.events.note_due();
            let (mut before, mut beyond) = (std::mem::take(&mut self.before), std::mem::take(&mut self.beyond));
            state_at(moment.low, &mut before);
            state_at(moment.high, &mut beyond);
            let earlier = self.crossed(start + moment.low, &before);
            let there = !earlier && self.crossed(start + moment.high, &beyond);
            (self.before, self.beyond) = (before, beyond);
            if there {
                return moment;
            }
            if earlier {
                high = moment.low;
            } else {
                self.events.recall_due();
                low = moment.high.min(high);
            }
        }
        self.events.note_due();
        let mut probe = std::mem::take(&mut self.before);
        let crossing = Crossing::find(low, high, |since| {
            state_at(since, &mut probe);
            let crossed = self.crossed(start + since, &probe);
            if crossed {
                self.events.note_due();
            }
            crossed
        });
        self.events.recall_due();
        state_at(crossing.low, &mut probe);
        self.before = probe;
        state_at(crossing.high, &mut self.beyond);
        crossing
    }

    /// Evaluates the terms for the jump of the sensitivities at `time` (SI) and the state before the crossing found last.
    pub fn approach(&mut self, equations: &mut Equations, time: f64) {
        self.switches.approach(equations, time, &self.before);
    }

    /// State at the moment found last, before the crossing: SI, one value per state.
    pub fn before(&self) -> &[f64] {
        &self.before
    }

    /// True if both states around the crossing found last are finite.
    pub fn is_finite(&self) -> bool {
        self.before.iter().chain(&self.beyond).all(|value| value.is_finite())
    }

    /// State right after the crossing, without the actions of events: SI, one value per state.
    pub fn beyond(&self) -> &[f64] {
        &self.beyond
    }
}
