//! `meniscus check --run`: tests the claims of a document about its runs.

use model::Diagnostic;
use runner::{JudgedClaim, Loaded, judged};
use units::Language;

/// The tested claims of one document.
pub struct Claims {
    /// Results in the order of the text.
    judged: Vec<JudgedClaim>,
    /// Number of the line of each, from 1.
    lines: Vec<usize>,
}

impl Claims {
    /// Runs a document to test its claims. Empty for a document with errors.
    pub fn judge(loaded: &Loaded, language: Language) -> Self {
        let sound = loaded.opened.document.as_ref().filter(|_| !loaded.opened.has_errors());
        let Some(document) = sound else { return Self { judged: Vec::new(), lines: Vec::new() } };
        let judged = judged(document, language);
        let line = |claim: &JudgedClaim| {
            1 + document.source.get(..claim.place.start).unwrap_or_default().matches('\n').count()
        };
        Self { lines: judged.iter().map(line).collect(), judged }
    }

    /// Number of claims, and number of those that do not hold.
    pub fn counts(&self) -> (usize, usize) {
        (self.judged.len(), self.judged.iter().filter(|judged| !judged.held).count())
    }

    /// One line of text per claim.
    pub fn lines(&self, language: Language) -> String {
        let shown = |(judged, place): (&JudgedClaim, &usize)| {
            let (name, text) = (&judged.name, judged.text.text(language));
            if judged.held {
                return format!("  ✓ {name}: {text}\n");
            }
            let line = language.say("line");
            format!("  ✗ {name}: {text} ({line} {place})\n")
        };
        self.judged.iter().zip(&self.lines).map(shown).collect()
    }

    /// One finding per claim that does not hold.
    pub fn findings(&self) -> impl Iterator<Item = Diagnostic> {
        self.judged.iter().filter_map(JudgedClaim::finding)
    }
}
