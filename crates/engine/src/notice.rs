//! Notices: limits of accuracy met by a run.

use crate::Subject;
use crate::error::moment;
use program::Model;
use units::{Words, words};

/// A limit of accuracy met by a run. It is no error: the run continues.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Notice {
    /// The kind of notice.
    pub kind: NoticeKind,
    /// Independent variable from which on it applies, SI units.
    pub time: f64,
}

/// The kind of a [`Notice`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoticeKind {
    /// The quantities in the condition of this event change too fast within a step to detect all changes; `None`: those in
    /// a jump of the equations.
    MayBeSkipped(Option<usize>),
    /// The argument of the table of this index has left the range of its points.
    OutsideTable(usize),
    /// A condition on the independent variable alone changes too often within a step.
    TooFastInTime,
    /// The fixed-step method is unstable with this step.
    StepTooLong,
}

impl Notice {
    /// The part of the model that the notice concerns, `None` if it is not one event.
    pub fn subject(&self) -> Option<Subject> {
        match self.kind {
            NoticeKind::MayBeSkipped(event) => event.map(Subject::Event),
            NoticeKind::TooFastInTime | NoticeKind::OutsideTable(_) | NoticeKind::StepTooLong => None,
        }
    }

    /// Stable identifier; never translated.
    pub fn code(&self) -> &'static str {
        match self.kind {
            NoticeKind::MayBeSkipped(_) => "may-be-skipped",
            NoticeKind::TooFastInTime => "too-fast-in-time",
            NoticeKind::OutsideTable(_) => "outside-table",
            NoticeKind::StepTooLong => "step-too-long",
        }
    }

    /// The notice in one sentence without a full stop, with the names used in the model.
    pub fn message(&self, model: &Model) -> Words {
        let (name, moment) = (&model.independent.name, moment(model, self.time));
        match self.kind {
            NoticeKind::MayBeSkipped(Some(event)) => words!(
                "{event} may be skipped from {moment} on: what its condition compares changes too fast within a step",
                event = event_name(model, event),
            ),
            NoticeKind::MayBeSkipped(None) => words!(
                "a jump of the equations may be skipped from {moment} on: what decides it changes too fast within a step",
            ),
            NoticeKind::OutsideTable(table) => {
                let table = model.tables.get(table);
                let (table, argument) = table.map_or(("", ""), |table| (&table.name, &table.argument));
                words!(
                    "{argument} is outside the points of the table {table} at {moment}: the table keeps its last value there",
                )
            }
            NoticeKind::TooFastInTime => words!(
                "a condition on {name} alone changes so often in a step that changes may be skipped from {moment} on",
            ),
            NoticeKind::StepTooLong => words!(
                "the step is too long from {moment} on: the method is unstable, and values can grow without a physical cause",
            ),
        }
    }

    /// Advice on how to avoid it.
    pub fn hint(&self) -> Words {
        match self.kind {
            NoticeKind::OutsideTable(_) => words("give the table more points"),
            NoticeKind::MayBeSkipped(_) | NoticeKind::TooFastInTime => words("a smaller step helps"),
            NoticeKind::StepTooLong => words(
                "choose a smaller step or a method that adapts its step: Dormand-Prince, or Rosenbrock for stiff equations",
            ),
        }
    }
}

/// Name of an event: its title, or the first state that it changes.
fn event_name(model: &Model, event: usize) -> Words {
    let event = model.events.get(event);
    if let Some(title) = event.and_then(|event| event.title.as_ref()) {
        return words!("the event `{title}`");
    }
    let changed = event.and_then(|event| event.actions.first());
    match changed.and_then(|(state, _)| model.states.get(*state as usize)) {
        Some(state) => words!("the event that changes `{}`", state.kept_for()),
        None => words("an event"),
    }
}
