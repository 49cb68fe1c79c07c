//! `meniscus check --run`: tests the claims of a document about its runs.

use crate::load::Loaded;
use document::Document;
use engine::checks::{Outcome, claim_outcome, judge_all};
use model::{Diagnostic, Span};
use program::Claim;
use units::{Language, words};

/// The tested claims of one document.
pub struct Claims {
    /// Results in the order of the text.
    judged: Vec<Judged>,
}

struct Judged {
    /// Name in the language of messages.
    name: String,
    held: bool,
    /// Description of the result, in both languages.
    text: units::Words,
    place: Span,
    /// Number of its line, from 1.
    line: usize,
}

impl Claims {
    /// Runs a document to test its claims. Empty for a document with errors.
    pub fn judge(loaded: &Loaded, language: Language) -> Self {
        let sound = loaded.opened.document.as_ref().filter(|_| !loaded.opened.has_errors());
        let judged = sound.map_or_else(Vec::new, |document| judged(document, language));
        Self { judged }
    }

    /// Number of claims, and number of those that do not hold.
    pub fn counts(&self) -> (usize, usize) {
        (self.judged.len(), self.judged.iter().filter(|judged| !judged.held).count())
    }

    /// One line of text per claim.
    pub fn lines(&self, language: Language) -> String {
        let line = |judged: &Judged| {
            let (name, text) = (&judged.name, judged.text.text(language));
            if judged.held {
                return format!("  ✓ {name}: {text}\n");
            }
            let line = language.say("line");
            format!("  ✗ {name}: {text} ({line} {})\n", judged.line)
        };
        self.judged.iter().map(line).collect()
    }

    /// One finding per claim that does not hold.
    pub fn findings(&self) -> impl Iterator<Item = Diagnostic> {
        let failed = self.judged.iter().filter(|judged| !judged.held);
        failed.map(|judged| {
            let message = words!(
                "the claim \"{name}\" does not hold: {text}",
                name = units::Words::same(judged.name.clone()),
                text = judged.text
            );
            Diagnostic::error("check-failed", message, judged.place)
        })
    }
}

fn judged(document: &Document, language: Language) -> Vec<Judged> {
    let program = &document.program;
    let outcomes = judge_all(program).into_iter().flatten();
    let claims = program.checks.iter().flat_map(|check| &check.claims);
    let one = |((claim, outcome), place): ((&Claim, Outcome), &Span)| Judged {
        name: program.text(language.tag(), &claim.name).to_owned(),
        held: outcome.held(),
        text: claim_outcome(program, claim, &outcome),
        place: *place,
        line: 1 + document.source.get(..place.start).unwrap_or_default().matches('\n').count(),
    };
    claims.zip(outcomes).zip(&document.claims).map(one).collect()
}
