//! Checks: what the author claims about runs of the simulation, and whether it holds. They run with the values of the
//! document, on demand and a slice in each frame; the run of the visitor has no part in it.

use crate::Play;
use crate::deviation::compared;
use engine::checks::{Checking, claim_outcome, supposed};

/// About how many floating-point operations are made for claims in a frame.
const WORK: u64 = 3_000_000;

/// A claim of the author.
#[derive(Clone, Debug, PartialEq)]
pub struct ClaimView {
    /// Its name.
    pub name: String,
    /// What is claimed, as the document writes it: `E within 1e-6 of E(0) always`.
    pub written: String,
    /// Whether it holds; none while that is not known.
    pub holds: Option<bool>,
    /// Whether [`Play::deviation`] can draw how far the present run is off.
    pub is_drawn: bool,
    /// The worst value and when it was, once that is known.
    pub outcome: String,
}

/// Claims about one run.
#[derive(Clone, Debug, PartialEq)]
pub struct ClaimsView {
    /// The names and values of the parameters that are set for it, `b` and `0 kg/s`; none for the document's own values.
    pub setup: Vec<(String, String)>,
    /// In the order of the document.
    pub claims: Vec<ClaimView>,
}

impl Play {
    /// Whether the author claims anything.
    pub fn has_checks(&self) -> bool {
        !self.program.checks.is_empty()
    }

    /// The claims and what is known of them.
    pub fn checks(&self) -> Vec<ClaimsView> {
        let outcomes = self.checking.as_ref().map_or(&[][..], Checking::outcomes);
        let view = |(place, check): (usize, &program::Check)| {
            let parameters = supposed(&self.program, &check.setup);
            let claim = |(number, claim): (usize, &program::Claim)| {
                let outcome = outcomes.get(place).and_then(|outcomes| outcomes.get(number));
                let text = outcome.map(|outcome| claim_outcome(&self.program, claim, outcome));
                ClaimView {
                    name: self.program.text(&self.tag, &claim.name).to_owned(),
                    written: claim.written.clone(),
                    is_drawn: compared(claim).is_some(),
                    holds: outcome.map(engine::checks::Outcome::held),
                    outcome: text.map_or_else(String::new, |text| text.text(self.language).to_owned()),
                }
            };
            let claims = check.claims.iter().enumerate().map(claim).collect();
            ClaimsView { setup: self.assigned(&check.setup, &parameters), claims }
        };
        self.program.checks.iter().enumerate().map(view).collect()
    }

    /// Begins to find out which claims hold; [`Play::advance_checks`] goes on with it.
    pub fn begin_checks(&mut self) {
        self.checking = Some(Checking::new());
        self.revision.checks += 1;
    }

    /// Whether some claims have still to be judged since [`Play::begin_checks`].
    pub fn is_checking(&self) -> bool {
        self.checking.as_ref().is_some_and(|checking| checking.outcomes().len() < self.program.checks.len())
    }

    /// Goes on judging claims for a part of a frame. Whether there is more to come.
    pub fn advance_checks(&mut self) -> bool {
        if !self.is_checking() {
            return false;
        }
        let Some(checking) = &mut self.checking else { return false };
        let judged = checking.outcomes().len();
        let over = checking.advance(&self.program, WORK);
        if checking.outcomes().len() > judged {
            self.revision.checks += 1;
        }
        !over
    }
}
