//! Runs a program for what its author claims about it ([`program::Check`]), and says which claims hold.

mod judge;
mod outcome;
mod parameters;
mod side;
mod trial;
mod words;

pub use outcome::{Measured, Outcome, Verdict, Worst};
pub use parameters::supposed;
pub use words::{claim_outcome, moment};

use program::Program;
use trial::Trial;

/// About how many floating-point operations all claims of a document may take together: some ten seconds.
pub const MOST_WORK: u64 = 4_000_000_000;

/// The claims of a program, being judged one run after the other. The same program gives the same outcomes to the last
/// bit, however the work is divided.
#[derive(Debug)]
pub struct Checking {
    /// The run that is being made, of [`Program::checks`] the one of this number.
    trial: Option<Box<Trial>>,
    next: usize,
    /// Of the runs that have been made, and behind them those of the claims that no run has decided.
    outcomes: Vec<Vec<Outcome>>,
    /// How much work is left.
    left: u64,
}

impl Checking {
    /// Nothing has been judged yet.
    pub fn new() -> Self {
        Self::within(MOST_WORK)
    }

    /// The same with another limit than [`MOST_WORK`].
    pub fn within(work: u64) -> Self {
        Self { trial: None, next: 0, outcomes: Vec::new(), left: work }
    }

    /// Goes on with about so many floating-point operations. Whether all claims are judged.
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

    /// What came of the claims of each check, in the order of the program. Those that are not judged yet are missing.
    pub fn outcomes(&self) -> &[Vec<Outcome>] {
        &self.outcomes
    }
}

impl Default for Checking {
    fn default() -> Self {
        Self::new()
    }
}

/// Judges all claims of a program.
pub fn judge_all(program: &Program) -> Vec<Vec<Outcome>> {
    let mut checking = Checking::new();
    while !checking.advance(program, u64::MAX) {}
    checking.outcomes
}
