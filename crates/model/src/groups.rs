//! Groups of controls: `group "Circuit"` applies to the parameters after it, up to the next group.

use crate::{Diagnostic, Statement, StatementKind};
use units::words;

/// Warns of each group without a control, because its heading would be empty.
pub(crate) fn warn_of_empty(statements: &[Statement], diagnostics: &mut Vec<Diagnostic>) {
    let mut groups = Vec::new();
    for statement in statements {
        match &statement.kind {
            StatementKind::Group(name) => groups.push((name, false)),
            StatementKind::Parameter(_) | StatementKind::Choice(_) => {
                if let Some((_, has_control)) = groups.last_mut() {
                    *has_control = true;
                }
            }
            _ => {}
        }
    }
    for (name, _) in groups.iter().filter(|(_, has_control)| !has_control) {
        let message =
            words!("the group \"{}\" has no control: no parameter stands between it and the next group", name.text);
        diagnostics.push(
            Diagnostic::warning("empty-group", message, name.span)
                .with_hint(words("put it before the parameters that belong to it, or take it away")),
        );
    }
}
