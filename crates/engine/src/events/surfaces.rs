//! What can end a step before its time: an event, or a switch of the equations.

use super::crossing::Crossing;
use super::looks::{Dense, Looks};
use super::switches::Switches;
use super::timetable::Timetable;
use crate::events::Events;
use crate::methods::equations::Equations;
use crate::{Notice, NoticeKind};
use program::{Held, Model};

/// What can end a step before its time.
#[derive(Clone, Debug)]
pub(crate) struct Surfaces {
    pub events: Events,
    pub switches: Switches,
    pub timetable: Timetable,
    /// Where within a step to look.
    pub looks: Option<Looks>,
    /// The state before a crossing.
    before: Vec<f64>,
    /// The state after a crossing, without what events do.
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

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.events.is_empty() && self.switches.is_empty()
    }

    /// Sets parameters and initial values.
    pub fn prepare(&mut self, parameters: &[f64], initial: &[f64]) {
        self.events.prepare(parameters, initial);
        self.switches.prepare(parameters, initial);
        self.timetable.prepare(parameters, initial);
    }

    /// Sets them for the looks within a step, with the values at which the switches are held.
    pub fn prepare_looks(&mut self, parameters: &[f64], initial: &[f64]) {
        if let Some(looks) = &mut self.looks {
            looks.prepare(&[parameters, self.switches.held()].concat(), initial);
        }
    }

    /// About how many floating-point operations all looks took.
    pub fn work(&self) -> u64 {
        let looks = self.looks.as_ref().map_or(0, Looks::work);
        self.events.work() + self.switches.work() + self.timetable.work() + looks
    }

    /// What may have been missed.
    pub fn notices(&self) -> Vec<Notice> {
        let skipped = self
            .looks
            .as_ref()
            .and_then(Looks::doubt)
            .map(|doubt| Notice { kind: NoticeKind::MayBeSkipped(doubt.event), time: doubt.time });
        let too_fast = self.timetable.doubt().map(|time| Notice { kind: NoticeKind::TooFastInTime, time });
        skipped.into_iter().chain(too_fast).collect()
    }

    /// Forgets what was noticed at `time` and later.
    pub fn go_back_to(&mut self, time: f64) {
        self.timetable.go_back_to(time);
        if let Some(looks) = &mut self.looks {
            looks.go_back_to(time);
        }
    }

    /// Whether an event fires or a switch changes between the last look and `time`.
    pub fn crossed(&mut self, time: f64, state: &[f64]) -> bool {
        let due = self.events.due(time, state);
        self.switches.differ(time, state) || due
    }

    /// Looks between the ends of a step that started at `start`, or of a part of it, for what happens there: the last moment
    /// at which nothing has happened, and the next look, at which something has. These count from `start`, and `state_at`
    /// gives the state so long after it; `dense` is the continuous solution, if the method has one.
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

    /// Finds the first moment at which anything that was found at `high` happens, for a step that started at `start`, and
    /// remembers the states there. `state_at` gives the state so long after the start.
    ///
    /// Where nothing but time decides, `expected` says at what time between `low` and `high` it will be, and there it is,
    /// unless something else happens before.
    pub fn locate(
        &mut self,
        start: f64,
        (mut low, mut high): (f64, f64),
        expected: Option<Crossing>,
        mut state_at: impl FnMut(f64, &mut [f64]),
    ) -> Crossing {
        if let Some(expected) = expected {
            // Numbers are denser near the start of the step than at its time, so neighbours there are none here.
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

    /// Sees how a switch at the moment found last will change sensitivities.
    pub fn approach(&mut self, equations: &mut Equations, time: f64) {
        self.switches.approach(equations, time, &self.before);
    }

    /// The state at the moment found last, before the crossing.
    pub fn before(&self) -> &[f64] {
        &self.before
    }

    /// The state at the next moment, as it is without events.
    pub fn beyond(&self) -> &[f64] {
        &self.beyond
    }
}
