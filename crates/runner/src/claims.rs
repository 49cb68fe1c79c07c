//! The claims of a document about its runs.

use document::Document;
use engine::checks::{Outcome, claim_outcome, judge_all};
use model::{Diagnostic, Span};
use program::Claim;
use units::{Language, Words, words};

/// A tested claim of a document.
#[derive(Clone, Debug)]
pub struct JudgedClaim {
    /// Name in the language that was asked for.
    pub name: String,
    /// True if the claim holds.
    pub held: bool,
    /// Description of the result.
    pub text: Words,
    /// Place of the claim in the document.
    pub place: Span,
}

impl JudgedClaim {
    /// Error for a claim that does not hold.
    pub fn finding(&self) -> Option<Diagnostic> {
        let message = words!(
            "the claim \"{name}\" does not hold: {text}",
            name = Words::same(self.name.clone()),
            text = self.text
        );
        (!self.held).then(|| Diagnostic::error("check-failed", message, self.place))
    }
}

/// Runs a document without errors to test its claims, in the order of its text.
pub fn judged(document: &Document, language: Language) -> Vec<JudgedClaim> {
    let program = &document.program;
    let outcomes = judge_all(program).into_iter().flatten();
    let claims = program.checks.iter().flat_map(|check| &check.claims);
    let one = |((claim, outcome), place): ((&Claim, Outcome), &Span)| JudgedClaim {
        name: program.text(language.tag(), &claim.name).to_owned(),
        held: outcome.held(),
        text: claim_outcome(program, claim, &outcome),
        place: *place,
    };
    claims.zip(outcomes).zip(&document.claims).map(one).collect()
}
