//! Runs a program to test the claims of its author ([`program::Check`]).
//!
//! [`Checking`] makes one run for the claims with the same parameters, and beside it a finer one where a claim is about the
//! step. A `Judge` follows each claim and keeps the moment that speaks most against it. The work of all claims is bounded and
//! can be divided, so that command line and page use the same code. Rows that have been read are dropped.

mod judge;
mod outcome;
mod parameters;
mod side;
mod trial;
mod words;

pub use outcome::{Measured, Outcome, Verdict, Worst};
pub use parameters::{answer, assign, supposed};
pub use words::{claim_outcome, moment};

use program::Program;
use trial::Trial;

/// Work limit for all claims of a document together, in floating-point operations: about ten seconds.
pub const MOST_WORK: u64 = 4_000_000_000;

/// Test of all claims of a program, one run after the other. The outcomes are the same to the last bit however the work is
/// divided.
#[derive(Debug)]
pub struct Checking {
    /// The run in progress, for the check at index `next` of [`Program::checks`].
    trial: Option<Box<Trial>>,
    next: usize,
    /// Outcomes of the finished checks, one list per check.
    outcomes: Vec<Vec<Outcome>>,
    /// Remaining work, in floating-point operations.
    left: u64,
}

impl Checking {
    /// A test with the work limit [`MOST_WORK`], nothing judged yet.
    pub fn new() -> Self {
        Self::within(MOST_WORK)
    }

    /// A test with the work limit `work`.
    pub fn within(work: u64) -> Self {
        Self { trial: None, next: 0, outcomes: Vec::new(), left: work }
    }

    /// Continues with about `work` floating-point operations. Returns true if all claims are judged.
    pub fn advance(&mut self, program: &Program, work: u64) -> bool {
        let mut work = work.max(1);
        while self.next < program.checks.len() && work > 0 {
            let Some(check) = program.checks.get(self.next) else { break };
            let trial = match &mut self.trial {
                Some(trial) => trial,
                None => self.trial.insert(Box::new(Trial::begin(program, check))),
            };
            let mut allowed = work.min(self.left);
            let before = allowed;
            let over = trial.advance(&mut allowed);
            let spent = before - allowed;
            work -= spent;
            self.left -= spent;
            if over || self.left == 0 {
                self.outcomes.extend(self.trial.take().map(|trial| trial.outcomes()));
                self.next += 1;
            }
        }
        self.next >= program.checks.len()
    }

    /// Outcomes of the claims, one list per check in the order of the program; checks that are not finished are missing.
    pub fn outcomes(&self) -> &[Vec<Outcome>] {
        &self.outcomes
    }
}

impl Default for Checking {
    fn default() -> Self {
        Self::new()
    }
}

/// Judges all claims of a program in one call: one list of outcomes per check.
pub fn judge_all(program: &Program) -> Vec<Vec<Outcome>> {
    let mut checking = Checking::new();
    while !checking.advance(program, u64::MAX) {}
    checking.outcomes
}
