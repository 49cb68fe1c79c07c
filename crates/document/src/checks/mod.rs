//! Checks in a block of their own: `"Energy is kept": E within 1e-6 of E(0) always`.

mod claim;
mod identity;
mod tolerance;

use crate::expressions::Expressions;
use model::{Diagnostic, Sentence, Span};
use program::{Assignment, Check};
use units::words;

/// Maximum number of claims of a document.
const CLAIMS: usize = 100;

/// Checks of a document, and the places of their claims.
#[derive(Debug, Default)]
pub struct Checks {
    /// Checks, in text order.
    pub checks: Vec<Check>,
    /// Place of each claim, check after check.
    pub places: Vec<Span>,
}

impl Checks {
    /// Reads a block. `set:` applies to the claims after it.
    pub fn read(&mut self, expressions: &mut Expressions, sentences: &[Sentence]) {
        let mut setup: Vec<Assignment> = Vec::new();
        for sentence in sentences {
            let span = sentence.span;
            if sentence.head.is_some() && sentence.title.is_none() && sentence.colon.is_some() {
                setup = expressions.assignments(sentence.body.range());
                continue;
            }
            if self.places.len() == CLAIMS {
                let message = words!("a document cannot make more than {CLAIMS} claims in its checks");
                expressions.error("too-large", message, span);
                return;
            }
            let Some(name) = named(expressions, sentence) else { continue };
            let Some(claim) = claim::read(expressions, name, sentence) else { continue };
            self.places.push(span);
            match self.checks.last_mut() {
                Some(last) if last.setup == setup => last.claims.push(claim),
                _ => self.checks.push(Check { setup: setup.clone(), claims: vec![claim] }),
            }
        }
    }
}

/// The name before the colon.
fn named(expressions: &mut Expressions, sentence: &Sentence) -> Option<String> {
    let name = sentence.title_text(expressions.source).filter(|_| sentence.head.is_none() && sentence.colon.is_some());
    if name.is_none() {
        expressions.diagnostics.push(
            Diagnostic::error(
                "check-syntax",
                words("a check is a name in quotation marks, a colon and a claim"),
                sentence.span,
            )
            .with_hint(words("write `\"Energy is kept\": E within 1e-6 of E(0) always`")),
        );
    }
    name.map(str::to_owned)
}
