//! Checks: claims of the author about runs of the simulation, and their results. They run on demand with the document's
//! own values, one time slice per frame, and do not affect the visitor's run.

use crate::deviation::compared;
use crate::{Changes, Play};
use engine::checks::{Checking, claim_outcome, supposed};

/// Approximate work on claims per frame, in floating-point operations.
const WORK: u64 = 3_000_000;

/// One claim of the author and its result.
#[derive(Clone, Debug, PartialEq)]
pub struct ClaimView {
    /// Name of the claim in the chosen language.
    pub name: String,
    /// The claim as written in the document: `E within 1e-6 of E(0) always`.
    pub written: String,
    /// True if the claim holds; `None` while not yet judged.
    pub holds: Option<bool>,
    /// True if [`Play::deviation`] can plot the deviation of the present run from the claim.
    pub is_drawn: bool,
    /// Worst value and its time; empty while not yet judged.
    pub outcome: String,
}

/// Claims about one run.
#[derive(Clone, Debug, PartialEq)]
pub struct ClaimsView {
    /// Names and values of the parameters set for this run, such as `b` and `0 kg/s`; empty for the document's own
    /// values.
    pub setup: Vec<(String, String)>,
    /// Claims in the order of the document.
    pub claims: Vec<ClaimView>,
}

impl Play {
    /// True if the document contains checks.
    pub fn has_checks(&self) -> bool {
        !self.basis.program().checks.is_empty()
    }

    /// All claims with the results known so far.
    pub fn checks(&self) -> Vec<ClaimsView> {
        let outcomes = self.checking.as_ref().map_or(&[][..], Checking::outcomes);
        let view = |(place, check): (usize, &program::Check)| {
            let parameters = supposed(self.basis.program(), &check.setup);
            let claim = |(number, claim): (usize, &program::Claim)| {
                let outcome = outcomes.get(place).and_then(|outcomes| outcomes.get(number));
                let text = outcome.map(|outcome| claim_outcome(self.basis.program(), claim, outcome));
                ClaimView {
                    name: self.basis.text(&claim.name).to_owned(),
                    written: claim.written.clone(),
                    is_drawn: compared(claim).is_some(),
                    holds: outcome.map(engine::checks::Outcome::held),
                    outcome: text.map_or_else(String::new, |text| text.text(self.basis.language()).to_owned()),
                }
            };
            let claims = check.claims.iter().enumerate().map(claim).collect();
            ClaimsView { setup: self.basis.assigned(&check.setup, &parameters), claims }
        };
        self.basis.program().checks.iter().enumerate().map(view).collect()
    }

    /// Starts judging the claims; [`Play::advance_checks`] continues it.
    pub fn begin_checks(&mut self) {
        self.checking = Some(Checking::new());
        self.note(Changes::CLAIMS);
    }

    /// True while claims remain to be judged after [`Play::begin_checks`].
    pub fn is_checking(&self) -> bool {
        self.checking.as_ref().is_some_and(|checking| checking.outcomes().len() < self.basis.program().checks.len())
    }

    /// Judges claims for part of one frame. Returns true if claims remain.
    pub fn advance_checks(&mut self) -> bool {
        if !self.is_checking() {
            return false;
        }
        let Some(checking) = &mut self.checking else { return false };
        let judged = checking.outcomes().len();
        let over = checking.advance(self.basis.program(), WORK);
        if checking.outcomes().len() > judged {
            self.note(Changes::CLAIMS);
        }
        !over
    }
}
