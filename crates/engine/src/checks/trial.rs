//! One run, or two runs with different steps, and the claims about them.

use super::judge::{Judge, rounding, when};
use super::outcome::Outcome;
use super::parameters::{at_start, supposed};
use super::side::Side;
use crate::{RunError, Setup};
use program::{Check, NodeId, Program};

/// The run that tests the claims of one check.
#[derive(Debug)]
pub(super) struct Trial {
    judges: Vec<Judge>,
    /// The run, or the error that stopped it.
    side: Result<Side, RunError>,
    /// The run with half the step or a tenth of the tolerance, if a claim needs it.
    finer: Option<Result<Side, RunError>>,
    /// End of the run, SI units.
    end: f64,
    /// The last moment that a claim needs, SI units.
    last: f64,
    /// True if an event has ended the finer run.
    finer_ended: bool,
    over: bool,
}

impl Trial {
    /// Starts the run of a check.
    pub fn begin(program: &Program, check: &Check) -> Self {
        let model = &program.model;
        let end = program.end();
        let setup = Setup { parameters: supposed(program, &check.setup), ..Setup::of(program) };
        let mut roots: Vec<NodeId> = Vec::new();
        let mut judges = Vec::with_capacity(check.claims.len());
        for claim in &check.claims {
            let when = when(&claim.moment, end, |node| at_start(model, &setup.parameters, node));
            judges.push(Judge::new(claim, when, &mut roots));
        }
        let last = judges.iter().map(|judge| judge.until(end)).filter(|time| time.is_finite()).fold(0.0, f64::max);
        let finer = judges.iter().any(|judge| judge.halves).then(|| Side::start(model, setup.finer(), &roots));
        let mut trial =
            Self { judges, side: Side::start(model, setup, &roots), finer, end, last, finer_ended: false, over: false };
        trial.read();
        trial
    }

    /// Continues and subtracts the cost from `work`. Returns true if all claims are decided.
    pub fn advance(&mut self, work: &mut u64) -> bool {
        while !self.over && *work > 0 {
            let Ok(side) = &mut self.side else {
                self.over = true;
                break;
            };
            let time = side.time();
            // The finer run follows the other row by row.
            if let Some(Ok(finer)) = &mut self.finer
                && !self.finer_ended
                && finer.time() + rounding(time) < time
            {
                match finer.advance(work) {
                    Err(error) if error.is_end() => self.finer_ended = true,
                    Err(error) => self.finer = Some(Err(error)),
                    Ok(false) => {}
                    Ok(true) => while finer.next_row().is_some() {},
                }
                continue;
            }
            self.compare(time);
            if time + rounding(self.last) >= self.last {
                if let Ok(side) = &mut self.side {
                    side.finish(self.last);
                }
                self.read();
                self.over = true;
                break;
            }
            let Ok(side) = &mut self.side else { break };
            match side.advance(work) {
                Err(error) if error.is_end() => {
                    self.end = side.time();
                    self.last = self.end;
                    self.judges.iter_mut().for_each(|judge| judge.end_at(self.end));
                    self.read();
                }
                Err(error) => {
                    self.read();
                    self.side = Err(error);
                }
                Ok(false) => {}
                Ok(true) => self.read(),
            }
        }
        self.over
    }

    /// Judges the claims about the run alone at its new rows.
    fn read(&mut self) {
        let Ok(side) = &mut self.side else { return };
        while let Some((time, read)) = side.next_row() {
            for judge in self.judges.iter_mut().filter(|judge| !judge.halves && judge.counts(time, self.end)) {
                judge.take(time, read);
            }
        }
        let time = side.time();
        for judge in self.judges.iter_mut().filter(|judge| !judge.halves) {
            if let Some(moment) = judge.is_due(time) {
                judge.take(moment, side.at(moment));
            }
        }
    }

    /// Judges the claims that compare both runs, once both have reached `time`.
    fn compare(&mut self, time: f64) {
        let (Ok(side), Some(Ok(finer))) = (&mut self.side, &mut self.finer) else { return };
        for judge in self.judges.iter_mut().filter(|judge| judge.halves) {
            let moment = if judge.counts(time, self.end) { Some(time) } else { judge.is_due(time) };
            if let Some(moment) = moment {
                judge.take_both(moment, side.at(moment), finer.at(moment));
            }
        }
    }

    /// Outcomes of the claims, in their order.
    pub fn outcomes(&self) -> Vec<Outcome> {
        let stopped = self.side.as_ref().err();
        let outcome = |judge: &Judge| {
            let finer = self.finer.as_ref().filter(|_| judge.halves).and_then(|finer| finer.as_ref().err());
            judge.outcome(stopped.or(finer), !self.over)
        };
        self.judges.iter().map(outcome).collect()
    }
}
