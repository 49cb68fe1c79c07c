//! Checks in a block of their own: `"Energy is kept": E within 1e-6 of E(0) always`.

mod claim;
mod identity;
mod tolerance;

use crate::expressions::Expressions;
use crate::text::scan::{leading_text, statements};
use crate::text::source::trim;
use model::{Diagnostic, Span};
use program::{Assignment, Check};
use std::ops::Range;
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
    /// Reads the block in `range`. `set:` applies to the claims after it.
    pub fn read(&mut self, expressions: &mut Expressions, range: Range<usize>) {
        let source = expressions.source;
        let mut setup: Vec<Assignment> = Vec::new();
        for statement in with_indented(source, statements(source, range)) {
            let span = Span::new(statement.start, statement.end);
            if let Some(rest) = source[statement.clone()].strip_prefix("set:") {
                setup = expressions.assignments(trim(source, statement.end - rest.len()..statement.end));
                continue;
            }
            if self.places.len() == CLAIMS {
                let message = words!("a document cannot make more than {CLAIMS} claims in its checks");
                expressions.error("too-large", message, span);
                return;
            }
            let Some((name, range)) = named(expressions, statement) else { continue };
            let Some(claim) = claim::read(expressions, name, range) else { continue };
            self.places.push(span);
            match self.checks.last_mut() {
                Some(last) if last.setup == setup => last.claims.push(claim),
                _ => self.checks.push(Check { setup: setup.clone(), claims: vec![claim] }),
            }
        }
    }
}

/// Joins an indented line with the line before, unless it begins another claim.
fn with_indented(source: &str, lines: Vec<Range<usize>>) -> Vec<Range<usize>> {
    let mut statements: Vec<Range<usize>> = Vec::new();
    for line in lines {
        let indented = source[..line.start].ends_with([' ', '\t']);
        let begins = source[line.clone()].starts_with('"') || source[line.clone()].starts_with("set:");
        match statements.last_mut() {
            Some(last) if indented && !begins => last.end = line.end,
            _ => statements.push(line),
        }
    }
    statements
}

/// The name before the colon, and the byte range of the claim after it.
fn named(expressions: &mut Expressions, statement: Range<usize>) -> Option<(String, Range<usize>)> {
    let source = expressions.source;
    let name = leading_text(source, statement.clone()).filter(|(name, _)| !name.trim().is_empty());
    let named = name.and_then(|(name, end)| {
        let rest = trim(source, end..statement.end);
        source[rest.clone()].starts_with(':').then(|| (name.to_owned(), trim(source, rest.start + 1..rest.end)))
    });
    if named.is_none() {
        expressions.diagnostics.push(
            Diagnostic::error(
                "check-syntax",
                words("a check is a name in quotation marks, a colon and a claim"),
                Span::new(statement.start, statement.end),
            )
            .with_hint(words("write `\"Energy is kept\": E within 1e-6 of E(0) always`")),
        );
    }
    named
}
