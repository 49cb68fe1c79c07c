//! Evaluation of one claim along a run.

use super::outcome::{Measured, Outcome, Verdict, Worst};
use crate::RunError;
use program::{Claim, Moment, NodeId, Relation, Test, Tolerance};

/// The time at which a claim is judged, SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum When {
    Always,
    At(f64),
}

/// The comparison that a claim makes.
#[derive(Clone, Copy, Debug)]
enum Measure {
    Near(Tolerance),
    Compared(Relation),
    Condition,
}

/// A claim and its worst violation so far.
#[derive(Clone, Debug)]
pub(super) struct Judge {
    pub when: When,
    /// True if the claim is about the end of the run.
    at_end: bool,
    /// True if the value is compared with that of a run with a finer step.
    pub halves: bool,
    measure: Measure,
    /// Index of the first value of the claim among the roots, and number of its values.
    first: usize,
    count: usize,
    worst: Option<(f64, f64, f64)>,
    /// Distance at the worst moment; greater is worse.
    distance: f64,
    /// Greatest magnitude of the expected values, SI units.
    scale: f64,
    failed: bool,
    /// True if the claim was judged at least once.
    pub met: bool,
}

impl Judge {
    /// The claim judged `when`; appends the nodes it needs to `roots`.
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

    /// Notes that an event ended the run at `time`, SI units, before its planned end.
    pub fn end_at(&mut self, time: f64) {
        if self.at_end {
            self.when = When::At(time);
        }
    }

    /// The last moment that the claim needs, in a run until `end`; SI units.
    pub fn until(&self, end: f64) -> f64 {
        match self.when {
            When::Always => end,
            When::At(time) => time,
        }
    }

    /// True if the claim is judged at a row of this time, in a run until `end`.
    pub fn counts(&self, time: f64, end: f64) -> bool {
        self.when == When::Always && time <= end + rounding(end)
    }

    /// The moment of the claim (SI) if it is reached and not yet judged.
    pub fn is_due(&self, time: f64) -> Option<f64> {
        match self.when {
            When::At(moment) if !self.met && time + rounding(moment) >= moment => Some(moment),
            _ => None,
        }
    }

    /// Judges the claim at `time` with the values of the roots.
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

    /// Judges the claim at `time` with the values of the roots in both runs.
    pub fn take_both(&mut self, time: f64, read: &[f64], finer: &[f64]) {
        if let (Some(&value), Some(&expected)) = (read.get(self.first), finer.get(self.first)) {
            self.note(time, value, expected, (value - expected).abs());
        }
    }

    fn note(&mut self, time: f64, value: f64, expected: f64, distance: f64) {
        self.met = true;
        self.scale = self.scale.max(expected.abs());
        // NaN is worse than any number; the first NaN is kept.
        if self.worst.is_none() || distance > self.distance || (distance.is_nan() && !self.distance.is_nan()) {
            (self.worst, self.distance) = (Some((time, value, expected)), distance);
        }
    }

    /// Result of the claim. `stopped` is the error that stopped the run, if any.
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
        // A claim about one moment is decided once that is judged; one about all moments also by the first failure.
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

/// True if the difference is within the tolerance; false for NaN.
fn within(off: f64, allowed: f64, strictly: bool) -> bool {
    if strictly { off < allowed } else { off <= allowed }
}

/// Upper bound of the rounding error of a time, in the unit of `time`.
pub(super) fn rounding(time: f64) -> f64 {
    crate::ROUNDING * time.abs()
}

/// The time at which a claim is judged: `end` is the end of the run, and `at` evaluates the moment of a claim about one
/// moment.
pub(super) fn when(moment: &Moment, end: f64, at: impl FnOnce(NodeId) -> f64) -> When {
    match moment {
        Moment::Always => When::Always,
        Moment::End => When::At(end),
        Moment::At(time) => When::At(at(time.node)),
    }
}
