//! Sizes that statements declare.

use super::declared::declared;
use crate::{Diagnostic, SizeStatement, Statement, StatementKind};
use program::Size;
use units::words;

/// Sizes of a model, in text order.
pub(crate) fn sizes(statements: &[Statement], diagnostics: &mut Vec<Diagnostic>) -> Vec<Size> {
    let mut sizes: Vec<Size> = Vec::new();
    for statement in statements {
        let StatementKind::Size(size) = &statement.kind else { continue };
        let name = &size.name.text;
        let other = statements
            .iter()
            .find(|other| !std::ptr::eq(*other, statement) && declared(other).is_some_and(|declared| declared == name));
        if let Some(other) = other {
            // Reported once, at the later declaration.
            if other.span.start < statement.span.start || !matches!(other.kind, StatementKind::Size(_)) {
                let message = words!("`{name}` is declared twice");
                diagnostics.push(
                    Diagnostic::error("duplicate-name", message, size.name.span)
                        .with_label(other.span, words("also declared here"))
                        .with_hint(words("give one of them another name")),
                );
            }
        }
        sizes.push(Size {
            name: name.clone(),
            label: statement.label.as_ref().map(|label| label.text.clone()),
            value: size.value,
            stated: size.value,
            range: range(size, diagnostics),
        });
    }
    sizes
}

/// Range of a size as integers. Reports a range that is not one.
fn range(size: &SizeStatement, diagnostics: &mut Vec<Diagnostic>) -> Option<(u32, u32)> {
    let bounds = size.range.as_ref()?;
    let name = &size.name.text;
    let whole = |value: f64| value.fract() == 0.0 && value >= 0.0 && value <= f64::from(crate::limits::MEMBERS);
    if !whole(bounds.low) || !whole(bounds.high) || bounds.low > bounds.high {
        let message = words!(
            "the range of the size `{name}` needs two whole numbers, the lesser first, of at most {}",
            crate::limits::MEMBERS
        );
        diagnostics.push(Diagnostic::error("size-range", message, bounds.span));
        return None;
    }
    let (low, high) = (bounds.low as u32, bounds.high as u32);
    if !(low..=high).contains(&size.value) {
        let message = words!("the size `{name}` is {}, outside its range {low}..{high}", size.value);
        diagnostics.push(Diagnostic::error("default-out-of-range", message, size.value_span));
    }
    Some((low, high))
}
