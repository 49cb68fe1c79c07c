//! Limit for the number of diagnostics per file.

use model::Diagnostic;
use units::order::sort_by_key;
use units::words;

/// Maximum number of diagnostics per file.
const FINDINGS: usize = 100;

/// Diagnostics in the order of their places. If there are too many, warnings are dropped before errors.
pub fn limited(mut found: Vec<Diagnostic>) -> Vec<Diagnostic> {
    let more = found.len().saturating_sub(FINDINGS);
    if more > 0 {
        sort_by_key(&mut found, |diagnostic| std::cmp::Reverse(diagnostic.severity));
        found.truncate(FINDINGS);
    }
    sort_by_key(&mut found, |diagnostic| diagnostic.span().start);
    if let Some(last) = found.last().filter(|_| more > 0) {
        let message = words!("{more} more findings are not listed");
        found.push(Diagnostic::warning("more-findings", message, last.span()));
    }
    found
}
