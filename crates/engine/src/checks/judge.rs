//! One claim, followed along a run.

use super::outcome::{Measured, Outcome, Verdict, Worst};
use crate::RunError;
use program::{Claim, Moment, NodeId, Relation, Test, Tolerance};

/// When a claim is judged, SI.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum When {
    Always,
    At(f64),
}

/// What is made of the values of a claim.
#[derive(Clone, Copy, Debug)]
enum Measure {
    Near(Tolerance),
    Compared(Relation),
    Condition,
}

/// A claim and what speaks most against it so far.
#[derive(Clone, Debug)]
pub(super) struct Judge {
    pub when: When,
    /// Whether that is where the run ends.
    at_end: bool,
    /// Whether its number is compared with that of a run with a finer step.
    pub halves: bool,
    measure: Measure,
    /// The first of its values among those that are read along the run, and how many there are.
    first: usize,
    count: usize,
    worst: Option<(f64, f64, f64)>,
    /// How bad the worst is.
    distance: f64,
    /// The greatest magnitude of what is expected.
    scale: f64,
    failed: bool,
    /// Whether it has met any moment of the run.
    pub met: bool,
}

impl Judge {
    /// The claim judged `when`; adds what it reads to `roots`.
    pub fn new(claim: &Claim, when: When, roots: &mut Vec<NodeId>) -> Self {
        let first = roots.len();
        let (measure, halves) = match &claim.test {
            Test::Near { value, expected, tolerance } => {
                roots.extend([value.node, expected.node]);
                (Measure::Near(*tolerance), false)
            }
            Test::Holds { condition, compared } => {
                roots.push(*condition);
                let sides = compared.as_ref().map(|compared| [compared.left.node, compared.right.node]);
                roots.extend(sides.into_iter().flatten());
                let relation = compared.as_ref().map(|compared| Measure::Compared(compared.relation));
                (relation.unwrap_or(Measure::Condition), false)
            }
            Test::HalvedStep { value, tolerance } => {
                roots.push(value.node);
                (Measure::Near(*tolerance), true)
            }
        };
        let count = roots.len() - first;
        let distance = f64::NEG_INFINITY;
        let at_end = claim.moment == Moment::End;
        Self {
            when,
            at_end,
            halves,
            measure,
            first,
            count,
            worst: None,
            distance,
            scale: 0.0,
            failed: false,
            met: false,
        }
    }

    /// The run has ended here, before it was expected to.
    pub fn end_at(&mut self, time: f64) {
        if self.at_end {
            self.when = When::At(time);
        }
    }

    /// When the last moment is that it waits for, in a run until `end`.
    pub fn until(&self, end: f64) -> f64 {
        match self.when {
            When::Always => end,
            When::At(time) => time,
        }
    }

    /// Whether a row at this time counts, in a run until `end`.
    pub fn counts(&self, time: f64, end: f64) -> bool {
        self.when == When::Always && time <= end + rounding(end)
    }

    /// Whether its one moment has come and has not been judged.
    pub fn is_due(&self, time: f64) -> Option<f64> {
        match self.when {
            When::At(moment) if !self.met && time + rounding(moment) >= moment => Some(moment),
            _ => None,
        }
    }

    /// Takes what is read along the run at a time.
    pub fn take(&mut self, time: f64, read: &[f64]) {
        match (self.measure, read.get(self.first..self.first + self.count)) {
            (Measure::Near(_), Some(&[value, expected])) => self.note(time, value, expected, (value - expected).abs()),
            (Measure::Compared(relation), Some(&[holds, left, right])) => {
                let distance = match relation {
                    Relation::Below => left - right,
                    Relation::Above => right - left,
                    Relation::Equal => (left - right).abs(),
                    Relation::Different => -(left - right).abs(),
                };
                self.failed |= holds != 1.0;
                self.note(time, left, right, distance);
            }
            (Measure::Condition, Some(&[holds])) => {
                self.met = true;
                if holds != 1.0 && !self.failed {
                    (self.failed, self.worst) = (true, Some((time, f64::NAN, f64::NAN)));
                }
            }
            _ => {}
        }
    }

    /// Takes what its number is at a time, with what is read along both runs.
    pub fn take_both(&mut self, time: f64, read: &[f64], finer: &[f64]) {
        if let (Some(&value), Some(&expected)) = (read.get(self.first), finer.get(self.first)) {
            self.note(time, value, expected, (value - expected).abs());
        }
    }

    fn note(&mut self, time: f64, value: f64, expected: f64, distance: f64) {
        self.met = true;
        self.scale = self.scale.max(expected.abs());
        // What is not a number is worse than anything, and the first of its kind stays.
        if self.worst.is_none() || distance > self.distance || (distance.is_nan() && !self.distance.is_nan()) {
            (self.worst, self.distance) = (Some((time, value, expected)), distance);
        }
    }

    /// What came of it. `stopped` is why the run could not go on, if it could not.
    pub fn outcome(&self, stopped: Option<&RunError>, out_of_work: bool) -> Outcome {
        let worst = self.worst.map(|(time, value, expected)| {
            let measured = match self.measure {
                Measure::Condition => None,
                Measure::Compared(_) => Some(Measured { value, expected, off: self.distance, allowed: None }),
                Measure::Near(Tolerance::Absolute(allowed)) => {
                    Some(Measured { value, expected, off: self.distance, allowed: Some(allowed) })
                }
                Measure::Near(Tolerance::Relative(allowed)) => {
                    let off = if self.distance == 0.0 { 0.0 } else { self.distance / self.scale };
                    Some(Measured { value, expected, off, allowed: Some(allowed) })
                }
            };
            Worst { time, measured }
        });
        let near =
            |measured: Measured| measured.allowed.is_none_or(|allowed| within(measured.off, allowed, self.halves));
        let fails = self.failed || !worst.and_then(|worst| worst.measured).is_none_or(near);
        // A claim for one moment is decided when that is over; one for all of them also by the first failure.
        let whole = self.when != When::Always && self.met;
        let verdict = match stopped {
            _ if whole && !fails => Verdict::Held,
            _ if fails => Verdict::Failed,
            Some(error) => Verdict::Stopped(error.clone()),
            None if out_of_work => Verdict::TooLong,
            None if !self.met => Verdict::NotReached,
            None => Verdict::Held,
        };
        Outcome { verdict, worst }
    }
}

/// Whether something is near enough; false for what is not a number.
fn within(off: f64, allowed: f64, strictly: bool) -> bool {
    if strictly { off < allowed } else { off <= allowed }
}

/// How far a time can be off by rounding.
pub(super) fn rounding(time: f64) -> f64 {
    crate::ROUNDING * time.abs()
}

/// When a claim is judged: `end` is where the run ends, and `at` the value of a moment of its own.
pub(super) fn when(moment: &Moment, end: f64, at: impl FnOnce(NodeId) -> f64) -> When {
    match moment {
        Moment::Always => When::Always,
        Moment::End => When::At(end),
        Moment::At(time) => When::At(at(time.node)),
    }
}
