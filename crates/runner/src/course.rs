//! A run from 0 to its end, row by row.

use crate::refusal::Refusal;
use document::Document;
use engine::{Advance, History, Run, RunError, Subject};
use model::Span;
use std::ops::Range;

/// Size in bytes of the history at which rows, which have been taken, are dropped: the length of a run is not limited by memory.
const HISTORY: usize = 1 << 20;

/// Work in floating-point operations after which `take` is asked within a step: some tens of milliseconds.
const WORK: u64 = 50_000_000;

/// Number of whole steps of a run between 0 and `until` (SI), tolerant to rounding.
///
/// # Errors
/// There are so many that step number times step is no longer exact.
pub fn steps(run: &Run, until: f64) -> Result<u64, Refusal> {
    // The step of the run, which is always 1 in a discrete model.
    let steps = (until / run.setup().step * (1.0 + engine::ROUNDING)).floor();
    const MOST: f64 = (1_u64 << 53) as f64;
    if steps < MOST { Ok(steps as u64) } else { Err(Refusal::request("--until is too many steps away")) }
}

/// Makes `steps` steps and the events up to `until` (SI). `take` gets the rows of the history that are new after each step, with
/// the number of steps so far, first the row of the start; within a long step it gets no rows from time to time. Returns the error
/// that ended the run, if any.
///
/// # Errors
/// The errors of `take`.
pub fn follow<E>(
    run: &mut Run,
    (steps, until): (u64, f64),
    mut take: impl FnMut(&History, Range<usize>, u64) -> Result<(), E>,
) -> Result<Option<RunError>, E> {
    take(run.history(), 0..1, 0)?;
    for done in 0..steps {
        if run.history().bytes() > HISTORY {
            run.forget();
        }
        let taken = run.history().len();
        let outcome = loop {
            match run.advance_within(WORK) {
                Ok(Advance::Partial) => take(run.history(), taken..taken, done)?,
                outcome => break outcome,
            }
        };
        take(run.history(), taken..run.history().len(), done + 1)?;
        if let Err(error) = outcome {
            return Ok(Some(error));
        }
    }
    let taken = run.history().len();
    let outcome = run.finish(until);
    take(run.history(), taken..run.history().len(), steps)?;
    Ok(outcome.err())
}

/// Position of a part of the model in the document.
pub fn place(document: &Document, subject: Subject) -> Option<Span> {
    let places = &document.places;
    let span = match subject {
        Subject::Parameter(index) => places.parameters.get(index),
        Subject::State(index) => places.states.get(index),
        Subject::Event(index) => places.events.get(index),
    };
    span.copied()
}
