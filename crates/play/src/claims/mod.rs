//! Claims of the author about runs of the simulation, and their results. They are judged on demand with the document's own
//! values, one time slice per frame, and do not affect the visitor's run.

mod deviation;

pub use deviation::{Deviation, deviation, deviation_svg};

use crate::{Basis, Changes};
use deviation::compared;
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
    /// True if [`deviation`] can plot the deviation of the present run from the claim.
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

/// Progress and results of the author's claims.
#[derive(Debug, Default)]
pub struct Claims {
    /// `None` until requested.
    checking: Option<Checking>,
}

impl Claims {
    /// All claims with the results known so far.
    pub fn list(&self, basis: &Basis) -> Vec<ClaimsView> {
        let outcomes = self.checking.as_ref().map_or(&[][..], Checking::outcomes);
        let view = |(place, check): (usize, &program::Check)| {
            let parameters = supposed(basis.program(), &check.setup);
            let claim = |(number, claim): (usize, &program::Claim)| {
                let outcome = outcomes.get(place).and_then(|outcomes| outcomes.get(number));
                let text = outcome.map(|outcome| claim_outcome(basis.program(), claim, outcome));
                ClaimView {
                    name: basis.text(&claim.name).to_owned(),
                    written: claim.written.clone(),
                    is_drawn: compared(claim).is_some(),
                    holds: outcome.map(engine::checks::Outcome::held),
                    outcome: text.map_or_else(String::new, |text| text.text(basis.language()).into_owned()),
                }
            };
            let claims = check.claims.iter().enumerate().map(claim).collect();
            ClaimsView { setup: basis.assigned(&check.setup, &parameters), claims }
        };
        basis.program().checks.iter().enumerate().map(view).collect()
    }

    /// Starts judging the claims; [`Claims::advance`] continues it.
    pub fn begin(&mut self) -> Changes {
        self.checking = Some(Checking::new());
        Changes::CLAIMS
    }

    /// True while claims remain to be judged after [`Claims::begin`].
    pub fn is_judging(&self, basis: &Basis) -> bool {
        self.checking.as_ref().is_some_and(|checking| checking.outcomes().len() < basis.program().checks.len())
    }

    /// Judges claims for part of one frame. Returns true if claims remain.
    pub fn advance(&mut self, basis: &Basis) -> (bool, Changes) {
        let Some(checking) = self.checking.as_mut().filter(|own| own.outcomes().len() < basis.program().checks.len())
        else {
            return (false, Changes::NONE);
        };
        let judged = checking.outcomes().len();
        let over = checking.advance(basis.program(), WORK);
        (!over, Changes::CLAIMS.only_if(checking.outcomes().len() > judged))
    }
}
