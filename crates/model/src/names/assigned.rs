//! Checks of the values that are assigned to the seats of a class.

use crate::{AssignedRange, Diagnostic, ParameterForm, ParameterStatement};
use program::{Grid, GridFault};
use units::words;

/// Reports a range of assigned values that cannot be used.
pub(super) fn check_assigned(parameter: &ParameterStatement, diagnostics: &mut Vec<Diagnostic>) {
    let Some(assigned) = &parameter.assigned else { return };
    if parameter.form != ParameterForm::Number {
        let wrong = words!("`{0}` cannot have assigned values: only a parameter can", parameter.name.text);
        diagnostics.push(Diagnostic::error("assigned-form", wrong, assigned.span));
        return;
    }
    diagnostics.extend(in_range(parameter, assigned));
    diagnostics.extend(grid(parameter, assigned));
}

/// Assigned values outside of the range of the parameter.
fn in_range(parameter: &ParameterStatement, assigned: &AssignedRange) -> Option<Diagnostic> {
    let range = parameter.range.as_ref()?;
    let own = &assigned.bounds;
    if own.low >= range.low && own.high <= range.high {
        return None;
    }
    let (name, low, high) = (&parameter.name.text, own.low, own.high);
    let wrong = words!("the assigned values of `{name}`, {low}..{high}, lie outside its range");
    let diagnostic = Diagnostic::error("assigned-out-of-range", wrong, own.span);
    Some(
        diagnostic
            .with_label(range.span, words("the range, in the unit of the value"))
            .with_hint(words("widen the range or assign other values")),
    )
}

/// Assigned values that are no grid.
fn grid(parameter: &ParameterStatement, assigned: &AssignedRange) -> Option<Diagnostic> {
    let (low, high, name) = (assigned.bounds.low, assigned.bounds.high, &parameter.name.text);
    let Some(step) = assigned.step else {
        let wrong = words!("the assigned values of `{name}` have no step");
        let hint = words!("state their distance behind the range: assigned {low}..{high} step STEP");
        return Some(Diagnostic::error("assigned-step", wrong, assigned.span).with_hint(hint));
    };
    let fault = Grid::new(low, high, step).err()?;
    let (least, most) = (Grid::LEAST, Grid::MOST);
    let (wrong, hint) = match fault {
        GridFault::Empty => (
            words!("`{name}` has no assigned values from {low} to {high} with the step {step}"),
            words("write the smaller number first, and a step greater than 0"),
        ),
        GridFault::Uneven => (
            words!("from {low} to {high} there is no whole number of steps of {step}"),
            words("choose a step that leads from the first value to the last one"),
        ),
        GridFault::TooFew => (
            words!("`{name}` has fewer than {least} assigned values"),
            words!("each eighth of the range needs one: take a smaller step than {step}"),
        ),
        GridFault::TooMany => {
            (words!("`{name}` has more than {most} assigned values"), words!("take a greater step than {step}"))
        }
        GridFault::TooExact => (
            words!("the assigned values of `{name}` have too many digits"),
            words("write fewer digits, or take a unit in which the numbers are neither large nor small"),
        ),
    };
    Some(Diagnostic::error("assigned-values", wrong, assigned.span).with_hint(hint))
}
